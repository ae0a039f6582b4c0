#include <birdstrike/core/machine.h>

#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
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
    std::ifstream groups(root / "proc/self/cgroup"); // "0::/user.slice/job" (v2), "7:memory:/job" (v1)
    for (std::string line; std::getline(groups, line);)
      {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos)
          continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const fs::path    inner       = fs::path(line.substr(second + 1)).relative_path();
        const fs::path    top         = root / "sys/fs/cgroup";
        if (controllers.size() == 2)
          left = std::min(left, left_by_groups((top / inner).lexically_normal(), top, "memory.max", "memory.current",
                                               "inactive_file"));
        else if (controllers.find(",memory,") != std::string::npos)
          left =
            std::min(left, left_by_groups((top / "memory" / inner).lexically_normal(), top / "memory",
                                          "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"));
      }
    if (rlimit limit{}; ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      left = std::min<std::uint64_t>(left, limit.rlim_cur);
    return left;
  }

  std::size_t usable_cores()
  {
    // A set of fixed size holds 1024 cores; of a larger machine the call refuses it.
    cpu_set_t offered;
    if (::sched_getaffinity(0, sizeof offered, &offered) == 0)
      return std::max(1, CPU_COUNT(&offered));
    return std::max(1u, std::thread::hardware_concurrency());
  }
} // namespace birdstrike
