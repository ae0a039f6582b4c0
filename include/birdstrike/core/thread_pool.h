#pragma once

#include <birdstrike/core/function_ref.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace birdstrike
{
  /// A persistent pool. A loop is cut beforehand into ranges, several to each thread; a thread that is done with its
  /// own takes ranges that others have not begun. Results must not depend on the number of threads or on who does a
  /// range: a loop body writes only to entities of its own range, and sums go through `ordered_sum`, whose chunks are
  /// fixed.
  ///
  /// Nested use is refused (std::logic_error). An exception thrown by a body is re-thrown in the caller, lowest range
  /// first.
  class ThreadPool
  {
  public:
    explicit ThreadPool(std::size_t n_threads = 1); ///< throws InputError if they cannot be started
    ~ThreadPool();
    ThreadPool(const ThreadPool &)            = delete;
    ThreadPool &operator=(const ThreadPool &) = delete;

    std::size_t n_threads() const;

    /// Calls body(begin, end) on disjoint ranges that cover [0, n), whose borders are multiples of `grain` (so that
    /// SIMD batches stay whole) and which hold `grain` entities at least: what is worth a thread, some microseconds of
    /// work.
    void parallel_for(std::size_t n, std::size_t grain, FunctionRef<void(std::size_t begin, std::size_t end)> body);

    /// As above with a cost per entity: prefix[k] is the summed cost of entities [0, k), prefix has n + 1 entries. A
    /// range may hold fewer than `grain` entities where these are costly, and the last one where n is no multiple.
    void parallel_for_balanced(std::size_t n, std::size_t grain, const std::size_t *prefix,
                               FunctionRef<void(std::size_t begin, std::size_t end)> body);

    /// Sums of several quantities at once: term(begin, end) returns them, over fixed chunks that are added in order.
    template <std::size_t n_sums, class Term>
    std::array<double, n_sums> ordered_sums(const std::size_t n, const Term &term, const std::size_t chunk = 1024)
    {
      const std::size_t n_chunks = (n + chunk - 1) / chunk;
      scratch.resize(n_chunks * n_sums);
      parallel_for(n_chunks, 1, [&](const std::size_t begin, const std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
          {
            const std::array<double, n_sums> part = term(c * chunk, std::min(n, (c + 1) * chunk));
            std::copy(part.begin(), part.end(), scratch.begin() + c * n_sums);
          }
      });
      std::array<double, n_sums> sums{};
      for (std::size_t c = 0; c < n_chunks; ++c)
        for (std::size_t k = 0; k < n_sums; ++k)
          sums[k] += scratch[c * n_sums + k];
      return sums;
    }

    /// Sum of term(begin, end) over fixed chunks of `chunk` entities, added in chunk order: bitwise the same for any
    /// number of threads.
    double ordered_sum(std::size_t n, FunctionRef<double(std::size_t begin, std::size_t end)> term,
                       std::size_t chunk = 4096);

    /// Maximum of term(begin, end) over the same chunks; -infinity for n = 0.
    double ordered_max(std::size_t n, FunctionRef<double(std::size_t begin, std::size_t end)> term,
                       std::size_t chunk = 4096);

  private:
    /// So many that each holds one unit of work at least.
    std::size_t pieces_per_thread(std::size_t n_units) const;

    class Workers;
    std::unique_ptr<Workers> workers;
    std::vector<double>      scratch; ///< results of chunks; one loop at a time
  };
} // namespace birdstrike
