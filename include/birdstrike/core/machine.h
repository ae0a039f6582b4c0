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
  /// machine's; at least 1.
  std::size_t usable_cores();
} // namespace birdstrike
