#pragma once

#include <cstddef>

namespace birdstrike::benchmarks
{
  /// Bytes in use and number of allocations so far through operator new, which this program replaces (memory.cc).
  /// What deal.II and the C library take by malloc is not counted.
  std::size_t   bytes_in_use();
  unsigned long n_allocations();
} // namespace birdstrike::benchmarks
