#include <birdstrike/core/memory.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <unistd.h>

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
