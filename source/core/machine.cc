#include <birdstrike/core/machine.h>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <thread>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

    /// The first number of a file; none for "max" and for a file that is not there.
    std::optional<std::uint64_t> read_number(const fs::path &file)
    {
      std::ifstream in(file);
      std::uint64_t value = 0;
      return in >> value ? std::optional(value) : std::nullopt;
    }

    /// The number after a key that begins a line.
    std::optional<std::uint64_t> find_number(const fs::path &file, const std::string &key)
    {
      std::ifstream in(file);
      for (std::string word; in >> word; in.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
        if (std::uint64_t value = 0; word == key && in >> value)
          return value;
      return std::nullopt;
    }

    /// Calls `visit` with ",memory," (the second version of groups: ",,") and the path of each group of this process.
    void for_each_group(const fs::path &root, const auto &visit)
    {
      std::ifstream groups(root / "proc/self/cgroup"); // "0::/user.slice/job" (v2), "7:memory:/job" (v1)
      for (std::string line; std::getline(groups, line);)
        if (const std::size_t first = line.find(':'), second = line.find(':', first + 1); second != std::string::npos)
          visit("," + line.substr(first + 1, second - first - 1) + ",",
                fs::path(line.substr(second + 1)).relative_path());
    }

    /// What a group and those above it leave below their limits. Pages of files that are not in use give way.
    std::uint64_t left_by_groups(fs::path group, const fs::path &top, const char *limit_file, const char *usage_file,
                                 const char *cache_key)
    {
      std::uint64_t left = unlimited;
      for (;; group = group.parent_path())
        {
          const auto limit = read_number(group / limit_file), usage = read_number(group / usage_file);
          if (limit && usage)
            {
              const std::uint64_t used =
                *usage - std::min(*usage, find_number(group / "memory.stat", cache_key).value_or(0));
              left = std::min(left, *limit - std::min(*limit, used));
            }
          if (group == top || group == group.parent_path())
            return left;
        }
    }
  } // namespace

  std::uint64_t available_memory(const fs::path &root)
  {
    std::uint64_t left = unlimited;
    if (const auto free = find_number(root / "proc/meminfo", "MemAvailable:"))
      left = *free * 1024;
    for_each_group(root, [&](const std::string &controllers, const fs::path &inner) {
      const fs::path top = root / "sys/fs/cgroup";
      if (controllers.size() == 2)
        left = std::min(
          left, left_by_groups((top / inner).lexically_normal(), top, "memory.max", "memory.current", "inactive_file"));
      else if (controllers.find(",memory,") != std::string::npos)
        left = std::min(left, left_by_groups((top / "memory" / inner).lexically_normal(), top / "memory",
                                             "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"));
    });
    if (rlimit limit{}; ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      left = std::min<std::uint64_t>(left, limit.rlim_cur);
    return left;
  }

  namespace
  {
    /// Of the scheduler's set, however large the machine is.
    std::size_t count_affine_cores()
    {
      for (int n_bits = CPU_SETSIZE; n_bits <= 1 << 20; n_bits *= 2)
        {
          const std::size_t n_bytes = CPU_ALLOC_SIZE(n_bits);
          cpu_set_t *const  offered = CPU_ALLOC(n_bits);
          const bool        fits    = offered != nullptr && ::sched_getaffinity(0, n_bytes, offered) == 0;
          const int         n       = fits ? CPU_COUNT_S(n_bytes, offered) : 0;
          CPU_FREE(offered);
          if (fits)
            return static_cast<std::size_t>(std::max(1, n));
        }
      return std::max(1u, std::thread::hardware_concurrency());
    }

    /// Cores' worth of time that a group and those above it may take; infinite where nothing limits them.
    double cores_of_groups(fs::path group, const fs::path &top, const auto &quota_of)
    {
      double cores = std::numeric_limits<double>::infinity();
      for (;; group = group.parent_path())
        {
          cores = std::min(cores, quota_of(group));
          if (group == top || group == group.parent_path())
            return cores;
        }
    }

    /// "200000 100000", or "max 100000" where there is no limit.
    double quota_v2(const fs::path &group)
    {
      std::ifstream in(group / "cpu.max");
      double        time = 0., period = 0.;
      return in >> time >> period && period > 0. ? time / period : std::numeric_limits<double>::infinity();
    }

    /// A time of -1 is no limit.
    double quota_v1(const fs::path &group)
    {
      std::ifstream times(group / "cpu.cfs_quota_us"), periods(group / "cpu.cfs_period_us");
      double        time = 0., period = 0.;
      return times >> time && periods >> period && time > 0. && period > 0. ? time / period
                                                                            : std::numeric_limits<double>::infinity();
    }
  } // namespace

  std::size_t usable_cores(const fs::path &root)
  {
    double cores = static_cast<double>(count_affine_cores());
    for_each_group(root, [&](const std::string &controllers, const fs::path &inner) {
      const fs::path top = root / "sys/fs/cgroup";
      if (controllers.size() == 2)
        cores = std::min(cores, cores_of_groups((top / inner).lexically_normal(), top, quota_v2));
      else if (controllers.find(",cpu,") != std::string::npos)
        for (const char *mounted : {"cpu", "cpu,cpuacct"})
          cores = std::min(cores, cores_of_groups((top / mounted / inner).lexically_normal(), top / mounted, quota_v1));
    });
    return static_cast<std::size_t>(std::max(1., std::ceil(cores - 1e-9)));
  }

  HeldMemory held_memory()
  {
    HeldMemory    held;
    rusage        usage{};
    std::ifstream in("/proc/self/statm");
    if (double whole = 0., resident = 0.; in >> whole >> resident)
      held.now = resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
    if (::getrusage(RUSAGE_SELF, &usage) == 0)
      held.most = 1024. * static_cast<double>(usage.ru_maxrss);
    return held;
  }

  void trim_memory()
  {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
  }
} // namespace birdstrike
