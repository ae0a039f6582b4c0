#include <birdstrike/core/thread_pool.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
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

  class ThreadPool::Workers
  {
  public:
    explicit Workers(const std::size_t n_threads) : errors(n_threads), task(nullptr)
    {
      for (std::size_t t = 1; t < n_threads; ++t)
        threads.emplace_back([this, t] { work(t); });
    }

    ~Workers()
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
        stopping.store(true, std::memory_order_release);
      }
      wake.notify_all();
      for (auto &thread : threads)
        thread.join();
    }

    std::size_t size() const
    {
      return threads.size() + 1;
    }

    /// Calls job(t) for every thread t, the caller being thread 0, and waits for all.
    void run(const FunctionRef<void(std::size_t)> job)
    {
      std::fill(errors.begin(), errors.end(), nullptr);
      {
        const std::lock_guard<std::mutex> lock(mutex);
        task = &job;
        n_pending.store(threads.size(), std::memory_order_relaxed);
        generation.fetch_add(1, std::memory_order_release);
      }
      wake.notify_all();
      call(0);
      // On a machine with more work than cores the last worker may not even be running: then give way to it.
      for (int spin = 0; n_pending.load(std::memory_order_acquire) != 0; ++spin)
        if (spin < n_spins)
          relax();
        else
          std::this_thread::yield();
      for (const auto &error : errors)
        if (error)
          std::rethrow_exception(error);
    }

  private:
    void call(const std::size_t t)
    {
      try
        {
          (*task)(t);
        }
      catch (...)
        {
          errors[t] = std::current_exception();
        }
    }

    void work(const std::size_t t)
    {
      std::uint64_t seen = 0;
      while (true)
        {
          for (int spin = 0; spin < n_spins && generation.load(std::memory_order_acquire) == seen &&
                             !stopping.load(std::memory_order_acquire);
               ++spin)
            relax();
          {
            std::unique_lock<std::mutex> lock(mutex);
            wake.wait(lock, [&] { return generation.load() != seen || stopping.load(); });
            if (stopping.load())
              return;
            seen = generation.load();
          }
          call(t);
          n_pending.fetch_sub(1, std::memory_order_acq_rel);
        }
    }

    std::vector<std::thread>              threads;
    std::vector<std::exception_ptr>       errors;
    const FunctionRef<void(std::size_t)> *task;
    std::mutex                            mutex;
    std::condition_variable               wake;
    std::atomic<std::uint64_t>            generation{0};
    std::atomic<std::size_t>              n_pending{0};
    std::atomic<bool>                     stopping{false};
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
    const std::size_t n_units   = (n + unit - 1) / unit;
    const std::size_t n_threads = workers->size();
    if (n_units <= 1 || n_threads == 1)
      {
        if (n > 0)
          body(0, n);
        return;
      }
    workers->run([&](const std::size_t t) {
      const std::size_t begin = n_units * t / n_threads * unit;
      const std::size_t end   = std::min(n, n_units * (t + 1) / n_threads * unit);
      if (begin < end)
        body(begin, end);
    });
  }

  void ThreadPool::parallel_for_balanced(const std::size_t n, const std::size_t grain, const std::size_t *prefix,
                                         const FunctionRef<void(std::size_t, std::size_t)> body)
  {
    const std::size_t unit      = std::max<std::size_t>(grain, 1);
    const std::size_t n_threads = workers->size();
    if (n <= unit || n_threads == 1)
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
