#include <birdstrike/core/machine.h>

#include <gtest/gtest.h>

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace
{
  /// A tree of files as Linux shows them.
  class FakeRoot
  {
  public:
    FakeRoot() : top(std::filesystem::temp_directory_path() / ("birdstrike-memory-" + std::to_string(::getpid())))
    {
      std::filesystem::remove_all(top);
    }
    ~FakeRoot()
    {
      std::filesystem::remove_all(top);
    }
    FakeRoot(const FakeRoot &)            = delete;
    FakeRoot &operator=(const FakeRoot &) = delete;

    void write(const std::string &file, const std::string &text) const
    {
      std::filesystem::create_directories((top / file).parent_path());
      std::ofstream(top / file) << text;
    }
    std::size_t cores() const
    {
      return birdstrike::usable_cores(top);
    }
    std::uint64_t available() const
    {
      return birdstrike::available_memory(top);
    }

  private:
    std::filesystem::path top;
  };
} // namespace

TEST(Memory, IsWhatTheMachineHasWhereNoGroupLimitsIt)
{
  const FakeRoot root;
  root.write("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:  100 kB\nMemAvailable:   8000000 kB\n");
  root.write("proc/self/cgroup", "0::/user.slice/job\n");
  root.write("sys/fs/cgroup/user.slice/job/memory.max", "max\n");
  root.write("sys/fs/cgroup/user.slice/job/memory.current", "5000\n");
  EXPECT_EQ(root.available(), std::uint64_t(8000000) * 1024);
}

TEST(Memory, IsWhatTheTightestGroupAboveTheProcessLeaves)
{
  const FakeRoot root;
  root.write("proc/meminfo", "MemAvailable:   8000000 kB\n");
  root.write("proc/self/cgroup", "0::/user.slice/job\n");
  root.write("sys/fs/cgroup/user.slice/job/memory.max", "9000000\n");
  root.write("sys/fs/cgroup/user.slice/job/memory.current", "1000000\n");
  root.write("sys/fs/cgroup/user.slice/memory.max", "4000000\n");
  root.write("sys/fs/cgroup/user.slice/memory.current", "3000000\n");
  EXPECT_EQ(root.available(), 1000000u);
  // pages of files that nobody uses give way
  root.write("sys/fs/cgroup/user.slice/memory.stat", "anon 7\ninactive_file 500000\n");
  EXPECT_EQ(root.available(), 1500000u);
}

TEST(Memory, KnowsGroupsOfTheFirstVersion)
{
  const FakeRoot root;
  root.write("proc/meminfo", "MemAvailable:   8000000 kB\n");
  root.write("proc/self/cgroup", "7:cpu,cpuacct:/x\n4:hugetlb,memory:/job\n");
  root.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  root.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "7\n");
  root.write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "2000\n");
  root.write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "3000\n");
  EXPECT_EQ(root.available(), 0u);
}

TEST(Memory, IsUnlimitedWhereNothingCanBeRead)
{
  const FakeRoot root;
  EXPECT_GT(root.available(), std::uint64_t(1) << 40);
}

TEST(UsableCores, AreNoMoreThanAGroupMayUseAtATime)
{
  const std::size_t of_machine = birdstrike::usable_cores("/no/such/root");
  const FakeRoot    root;
  root.write("proc/self/cgroup", "0::/user.slice/job\n");
  root.write("sys/fs/cgroup/user.slice/job/cpu.max", "max 100000\n");
  EXPECT_EQ(root.cores(), of_machine);
  root.write("sys/fs/cgroup/user.slice/cpu.max", "150000 100000\n");
  EXPECT_EQ(root.cores(), std::min<std::size_t>(2, of_machine)) << "a part of a core counts as one";
  root.write("sys/fs/cgroup/user.slice/job/cpu.max", "20000 100000\n");
  EXPECT_EQ(root.cores(), 1u);
}

TEST(UsableCores, KnowGroupsOfTheFirstVersion)
{
  const std::size_t of_machine = birdstrike::usable_cores("/no/such/root");
  const FakeRoot    root;
  root.write("proc/self/cgroup", "4:memory:/job\n3:cpu,cpuacct:/job\n");
  root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "-1\n");
  root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(root.cores(), of_machine);
  root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "100000\n");
  EXPECT_EQ(root.cores(), 1u);
}

// A job of a cluster gets some of a machine's cores: threads beyond them would only take turns.
TEST(UsableCores, AreThoseThatTheProcessIsLeft)
{
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  EXPECT_EQ(birdstrike::usable_cores(), static_cast<std::size_t>(CPU_COUNT(&all)));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core)
    if (CPU_ISSET(core, &all))
      CPU_SET(core, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(birdstrike::usable_cores(), 1u);
  ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
}
