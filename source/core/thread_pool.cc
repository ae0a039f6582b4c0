#include <birdstrike/core/errors.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/core/thread_pool.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// A loop of the explicit step lasts 10-1000 us: spinning this often before sleeping keeps the wake-up out of it.
    constexpr int n_spins = 2000;

    void relax()
    {
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
  } // namespace

  /// A loop is cut into pieces, as many to each thread, whoever does them: a piece's result does not depend on that. A
  /// thread begins its own from the front and, when none is left, takes those of others from the back. So a worker that
  /// sleeps, or has lost its core, is waited for at most for the one piece that it has begun.
  ///
  /// Kept beside TBB 2021.8 of deal.II because it is faster: us at the fastest tenth of 9000, three runs, 2 threads on
  /// 2 shared Zen 4 cores, TBB in a task_arena with the same pieces; loops as in a step of prm/frontal.prm:
  ///
  ///                            this pool     auto_partitioner   static_partitioner   affinity_partitioner
  ///     a step                 48.6 - 55.3   51.3 - 62.4        50.7 - 81.9          88.0
  ///     a loop without work    0.24          0.51               0.16                 1.02
  class ThreadPool::Workers
  {
  public:
    static constexpr std::size_t max_pieces = 8; ///< of a thread

    explicit Workers(const std::size_t n_threads) : errors(n_threads * max_pieces), queues(n_threads)
    {
      threads.reserve(n_threads - 1);
      try
        {
          for (std::size_t t = 1; t < n_threads; ++t)
            threads.emplace_back([this, t] { work(t); });
        }
      catch (const std::system_error &error)
        {
          stop();
          throw InputError("Cannot start " + std::to_string(n_threads) + " threads, only " +
                           std::to_string(threads.size() + 1) + ": " + error.code().message() +
                           ".\n  Action: a smaller Time/Threads, or a larger limit of processes (ulimit -u).");
        }
    }

    ~Workers()
    {
      stop();
    }

    std::size_t size() const
    {
      return queues.size();
    }

    /// Calls job(p) for every p below size() n_pieces, each once, and waits for all.
    void run(const std::size_t n_pieces, const FunctionRef<void(std::size_t)> job)
    {
      assert(n_pieces > 0 && n_pieces <= max_pieces);
      if (task)
        throw std::logic_error("ThreadPool: a loop within a loop.");
      task       = &job;
      per_thread = n_pieces;
      n_left     = size() * n_pieces;
      // Sequentially consistent, as is the worker's side: either this thread sees that one is about to sleep, or that
      // one sees its pieces.
      for (Queue &queue : queues)
        queue.open = (1u << n_pieces) - 1;
      if (n_asleep > 0)
        wake_up();
      help(0);
      wait_for_all();
      task = nullptr;
      if (has_failed.exchange(false))
        rethrow_first();
    }

  private:
    void stop()
    {
      is_stopping = true;
      wake_up();
      for (auto &thread : threads)
        thread.join();
    }

    struct alignas(64) Queue // a cache line each
    {
      std::atomic<unsigned int> open{0}; ///< one bit for each piece that nobody has begun
    };

    void call(const std::size_t piece)
    {
      try
        {
          (*task)(piece);
        }
      catch (...)
        {
          errors[piece] = std::current_exception();
          has_failed    = true;
        }
      n_left.fetch_sub(1, std::memory_order_release);
    }

    /// The number of an open piece that nobody else can take any more, of which pick(open) chooses the bit; -1 if none.
    template <class Pick>
    int take(Queue &queue, const Pick &pick)
    {
      for (unsigned int open = queue.open.load(std::memory_order_relaxed); open != 0;)
        {
          const int          piece = pick(open);
          const unsigned int bit   = 1u << piece;
          open                     = queue.open.fetch_and(~bit, std::memory_order_acquire);
          if (open & bit)
            return piece;
        }
      return -1;
    }

    void help(const std::size_t t)
    {
      const auto lowest  = [](const unsigned int open) { return __builtin_ctz(open); };
      const auto highest = [](const unsigned int open) { return 31 - __builtin_clz(open); };
      for (int piece; (piece = take(queues[t], lowest)) >= 0;)
        call(t * per_thread + static_cast<std::size_t>(piece));
      for (std::size_t k = 1; k < size(); ++k)
        {
          const std::size_t other = (t + k) % size();
          for (int piece; (piece = take(queues[other], highest)) >= 0;)
            call(other * per_thread + static_cast<std::size_t>(piece));
        }
    }

    void rethrow_first()
    {
      std::exception_ptr first;
      for (auto &error : errors)
        {
          if (!first)
            first = error;
          error = nullptr;
        }
      std::rethrow_exception(first);
    }

    void wake_up()
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
      }
      wake.notify_all();
    }

    void wait_for_all() const
    {
      // On a machine with more work than cores a worker may have lost its core: then give way to it.
      for (int spin = 0; n_left.load(std::memory_order_acquire) > 0; ++spin)
        if (spin < n_spins)
          relax();
        else
          std::this_thread::yield();
    }

    void work(const std::size_t t)
    {
      const auto is_idle = [this, t] { return queues[t].open == 0 && !is_stopping; };
      while (!is_stopping)
        {
          for (int spin = 0; spin < n_spins && is_idle(); ++spin)
            relax();
          if (is_idle())
            {
              std::unique_lock<std::mutex> lock(mutex);
              ++n_asleep;
              if (is_idle())
                wake.wait(lock); // whatever wakes it: more loops will come
              --n_asleep;
            }
          help(t);
        }
    }

    std::vector<std::thread>              threads;
    std::vector<std::exception_ptr>       errors; ///< of each piece, all empty between loops
    std::vector<Queue>                    queues; ///< of each thread; the caller is thread 0
    const FunctionRef<void(std::size_t)> *task       = nullptr;
    std::size_t                           per_thread = 1;
    std::mutex                            mutex;
    std::condition_variable               wake;
    alignas(64) std::atomic<std::size_t> n_left{0};
    alignas(64) std::atomic<std::size_t> n_asleep{0};
    std::atomic<bool> has_failed{false}, is_stopping{false};
  };

  ThreadPool::ThreadPool(const std::size_t n_threads)
    : workers(std::make_unique<Workers>(std::max<std::size_t>(n_threads, 1)))
  {
  }

  ThreadPool::~ThreadPool() = default;

  std::size_t ThreadPool::n_threads() const
  {
    return workers->size();
  }

  void ThreadPool::parallel_for(const std::size_t n, const std::size_t grain,
                                const FunctionRef<void(std::size_t, std::size_t)> body)
  {
    const std::size_t unit    = std::max<std::size_t>(grain, 1);
    const std::size_t n_units = n / unit;
    if (n_units <= 1 || n_threads() == 1)
      {
        if (n > 0)
          body(0, n);
        return;
      }
    const std::size_t per_thread = pieces_per_thread(n_units), n_pieces = n_threads() * per_thread;
    workers->run(per_thread, [&](const std::size_t p) {
      const std::size_t begin = n_units * p / n_pieces * unit;
      const std::size_t end   = p + 1 == n_pieces ? n : n_units * (p + 1) / n_pieces * unit;
      if (begin < end)
        body(begin, end);
    });
  }

  void ThreadPool::parallel_for_balanced(const std::size_t n, const std::size_t grain, const std::size_t *prefix,
                                         const FunctionRef<void(std::size_t, std::size_t)> body)
  {
    const std::size_t unit = std::max<std::size_t>(grain, 1);
    if (n < 2 * unit || n_threads() == 1)
      {
        if (n > 0)
          body(0, n);
        return;
      }
    const std::size_t per_thread = pieces_per_thread(n / unit), n_pieces = n_threads() * per_thread;
    const auto        border = [&](const std::size_t p) -> std::size_t {
      if (p == 0)
        return 0;
      if (p == n_pieces)
        return n;
      const std::size_t target = prefix[n] * p / n_pieces;
      const std::size_t first  = std::lower_bound(prefix, prefix + n, target) - prefix;
      return std::min(n, (first + unit - 1) / unit * unit);
    };
    workers->run(per_thread, [&](const std::size_t p) {
      const std::size_t begin = border(p), end = border(p + 1);
      if (begin < end)
        body(begin, end);
    });
  }

  std::size_t ThreadPool::pieces_per_thread(const std::size_t n_units) const
  {
    return std::clamp<std::size_t>(n_units / n_threads(), 1, Workers::max_pieces);
  }

  double ThreadPool::ordered_sum(const std::size_t n, const FunctionRef<double(std::size_t, std::size_t)> term,
                                 const std::size_t chunk)
  {
    return ordered_sums<1>(
      n, [&](const std::size_t begin, const std::size_t end) { return std::array<double, 1>{term(begin, end)}; },
      chunk)[0];
  }

  double ThreadPool::ordered_max(const std::size_t n, const FunctionRef<double(std::size_t, std::size_t)> term,
                                 const std::size_t chunk)
  {
    const std::size_t n_chunks = (n + chunk - 1) / chunk;
    scratch.resize(n_chunks);
    parallel_for(n_chunks, 1, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        scratch[c] = term(c * chunk, std::min(n, (c + 1) * chunk));
    });
    return std::accumulate(scratch.begin(), scratch.end(), -std::numeric_limits<double>::infinity(),
                           [](const double a, const double b) { return larger(a, b); });
  }
} // namespace birdstrike
