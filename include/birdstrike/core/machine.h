#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace birdstrike
{
  /// Bytes that this process may still take: the least of what the machine has free (MemAvailable of /proc/meminfo:
  /// with caches that give way), of what every control group above the process leaves below its limit (memory.max of
  /// cgroup v2, memory.limit_in_bytes of v1), and of RLIMIT_AS. The largest number where none of them can be read.
  /// `root`: where proc/ and sys/ stand.
  std::uint64_t available_memory(const std::filesystem::path &root = "/");

  /// Cores that this process may run on: those that a job or `taskset` leaves it (sched_getaffinity(2)) of the
  /// machine's, and no more than every control group above the process may use at a time (cpu.max of cgroup v2,
  /// cpu.cfs_quota_us over cpu.cfs_period_us of v1; a part of a core counts as one); at least 1.
  /// `root`: where proc/ and sys/ stand.
  std::size_t usable_cores(const std::filesystem::path &root = "/");

  /// Memory (bytes) of this process that the machine holds at present (/proc/self/statm), and the most that it held
  /// (getrusage(2)); 0 where neither can be read.
  struct HeldMemory
  {
    double now = 0., most = 0.;
  };
  HeldMemory held_memory();

  /// Gives the system back what has been freed, also where it lies among what is in use (malloc_trim(3)).
  void trim_memory();
} // namespace birdstrike
