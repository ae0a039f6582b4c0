#include <birdstrike/core/thread_pool.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
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

  /// Every worker has an offer of its own. What a worker has not begun when the caller is done with its own range, the
  /// caller takes back and does itself: a worker that sleeps, or has no core to run on, is never waited for. Who does
  /// a range does not change its result.
  class ThreadPool::Workers
  {
  public:
    explicit Workers(const std::size_t n_threads) : errors(n_threads), offers(n_threads), task(nullptr)
    {
      for (std::size_t t = 1; t < n_threads; ++t)
        threads.emplace_back([this, t] { work(t); });
    }

    ~Workers()
    {
      for (Offer &offer : offers)
        offer.state = State::stopping;
      wake_up();
      for (auto &thread : threads)
        thread.join();
    }

    std::size_t size() const
    {
      return offers.size();
    }

    /// Calls job(t) for every t below size(), each once, and waits for all.
    void run(const FunctionRef<void(std::size_t)> job)
    {
      assert(!task && "a loop within a loop");
      task = &job;
      // Sequentially consistent, as is the worker's side: either this thread sees that one is about to sleep, or that
      // one sees the offer.
      for (std::size_t t = 1; t < offers.size(); ++t)
        offers[t].state = State::open;
      if (n_asleep > 0)
        wake_up();
      call(0);
      for (std::size_t t = offers.size() - 1; t > 0; --t)
        if (State expected = State::open; offers[t].state.compare_exchange_strong(expected, State::none))
          call(t);
      for (std::size_t t = 1; t < offers.size(); ++t)
        wait_for(offers[t]);
      task = nullptr;
      if (has_failed.exchange(false))
        rethrow_first();
    }

  private:
    enum class State
    {
      none,
      open,
      taken,
      stopping
    };

    struct alignas(64) Offer // a cache line each
    {
      std::atomic<State> state{State::none};
    };

    void call(const std::size_t t)
    {
      try
        {
          (*task)(t);
        }
      catch (...)
        {
          errors[t]  = std::current_exception();
          has_failed = true;
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

    static void wait_for(const Offer &offer)
    {
      // On a machine with more work than cores the worker may have lost its core: then give way to it.
      for (int spin = 0; offer.state.load(std::memory_order_acquire) == State::taken; ++spin)
        if (spin < n_spins)
          relax();
        else
          std::this_thread::yield();
    }

    void work(const std::size_t t)
    {
      std::atomic<State> &state = offers[t].state;
      while (true)
        {
          for (int spin = 0; spin < n_spins && state.load(std::memory_order_acquire) == State::none; ++spin)
            relax();
          if (state.load(std::memory_order_acquire) == State::none)
            {
              std::unique_lock<std::mutex> lock(mutex);
              ++n_asleep;
              if (state == State::none)
                wake.wait(lock); // whatever wakes it: more loops will come
              --n_asleep;
            }
          if (state.load(std::memory_order_acquire) == State::stopping)
            return;
          State expected = State::open;
          if (!state.compare_exchange_strong(expected, State::taken))
            continue; // taken back
          call(t);
          state.store(State::none, std::memory_order_release);
        }
    }

    std::vector<std::thread>              threads;
    std::vector<std::exception_ptr>       errors; ///< of each range, all empty between loops
    std::vector<Offer>                    offers; ///< to each thread; the caller, thread 0, needs none
    const FunctionRef<void(std::size_t)> *task;
    std::mutex                            mutex;
    std::condition_variable               wake;
    std::atomic<std::size_t>              n_asleep{0};
    std::atomic<bool>                     has_failed{false};
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
    const std::size_t unit      = std::max<std::size_t>(grain, 1);
    const std::size_t n_units   = n / unit;
    const std::size_t n_threads = workers->size();
    if (n_units <= 1 || n_threads == 1)
      {
        if (n > 0)
          body(0, n);
        return;
      }
    workers->run([&](const std::size_t t) {
      const std::size_t begin = n_units * t / n_threads * unit;
      const std::size_t end   = t + 1 == n_threads ? n : n_units * (t + 1) / n_threads * unit;
      if (begin < end)
        body(begin, end);
    });
  }

  void ThreadPool::parallel_for_balanced(const std::size_t n, const std::size_t grain, const std::size_t *prefix,
                                         const FunctionRef<void(std::size_t, std::size_t)> body)
  {
    const std::size_t unit      = std::max<std::size_t>(grain, 1);
    const std::size_t n_threads = workers->size();
    if (n < 2 * unit || n_threads == 1)
      {
        if (n > 0)
          body(0, n);
        return;
      }
    const auto border = [&](const std::size_t t) -> std::size_t {
      if (t == 0)
        return 0;
      if (t == n_threads)
        return n;
      const std::size_t target = prefix[n] * t / n_threads;
      const std::size_t first  = std::lower_bound(prefix, prefix + n, target) - prefix;
      return std::min(n, (first + unit - 1) / unit * unit);
    };
    workers->run([&](const std::size_t t) {
      const std::size_t begin = border(t), end = border(t + 1);
      if (begin < end)
        body(begin, end);
    });
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
                           [](const double a, const double b) { return std::max(a, b); });
  }
} // namespace birdstrike
