#pragma once

#include <cstdint>
#include <string>

namespace birdstrike
{
  /// Counts the memory that is asked for while it lives, by any thread that is not exempt: the step loop must not
  /// allocate once it is warm. Counting replaces the global operator new; it is compiled into debug builds (NDEBUG
  /// off), or with BIRDSTRIKE_COUNT_ALLOCATIONS, and elsewhere the count stays 0 at no cost. One guard at a time.
  class AllocationGuard
  {
  public:
    explicit AllocationGuard(bool is_armed = true);
    ~AllocationGuard();
    AllocationGuard(const AllocationGuard &)            = delete;
    AllocationGuard &operator=(const AllocationGuard &) = delete;

    std::uint64_t count() const;

    static bool is_counting(); ///< whether this program was built to count

    /// What this thread allocates is not the loop's, e.g. that of a file writer.
    static void exempt_this_thread();

    /// Who allocated, for the developer: the stacks of the first counted allocations of this program, one frame a line
    /// (addresses for addr2line).
    static std::string first_call_sites();
  };
} // namespace birdstrike
