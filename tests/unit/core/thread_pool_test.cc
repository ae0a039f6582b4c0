#include <birdstrike/core/thread_pool.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using birdstrike::ThreadPool;

TEST(ThreadPool, CoversEveryEntityOnceOnGrainBorders)
{
  for (const std::size_t n_threads : {1, 2, 3, 5})
    for (const std::size_t n : {0, 1, 7, 8, 9, 1000, 1003})
      {
        ThreadPool       pool(n_threads);
        std::vector<int> visits(n, 0);
        pool.parallel_for(n, 8, [&](const std::size_t begin, const std::size_t end) {
          EXPECT_EQ(begin % 8, 0u);
          for (std::size_t i = begin; i < end; ++i)
            ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<int>(n, 1)) << n_threads << " threads, " << n << " entities";
      }
}

TEST(ThreadPool, BalancedRangesCoverEveryEntityOnce)
{
  std::vector<std::size_t> prefix(1001, 0);
  for (std::size_t i = 0; i < 1000; ++i)
    prefix[i + 1] = prefix[i] + (i < 100 ? 50 : 1);
  for (const std::size_t n_threads : {1, 2, 4})
    {
      ThreadPool       pool(n_threads);
      std::vector<int> visits(1000, 0);
      pool.parallel_for_balanced(1000, 8, prefix.data(), [&](const std::size_t begin, const std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(1000, 1));
    }
}

TEST(ThreadPool, OrderedSumIsBitwiseTheSameForAnyThreadCount)
{
  std::vector<double> values(100000);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(1. * i) * std::exp(10. * std::cos(3. * i));
  const auto sum_with = [&](const std::size_t n_threads) {
    ThreadPool pool(n_threads);
    return pool.ordered_sum(values.size(), [&](const std::size_t begin, const std::size_t end) {
      return std::accumulate(values.begin() + begin, values.begin() + end, 0.);
    });
  };
  const double reference = sum_with(1);
  for (const std::size_t n_threads : {2, 3, 4, 7})
    EXPECT_EQ(sum_with(n_threads), reference);
}

TEST(ThreadPool, RethrowsTheErrorOfTheLowestRange)
{
  ThreadPool pool(3);
  try
    {
      pool.parallel_for(
        300, 1, [](const std::size_t begin, std::size_t) { throw std::runtime_error(begin == 0 ? "first" : "later"); });
      FAIL() << "no exception";
    }
  catch (const std::runtime_error &error)
    {
      EXPECT_STREQ(error.what(), "first");
    }
  pool.parallel_for(10, 1, [](std::size_t, std::size_t) {});
}

TEST(ThreadPool, TakesTheRangesOfAThreadThatIsHeldUp)
{
  // The worker does not come back from its first range before all others are done, which only the caller can do.
  ThreadPool            pool(2);
  constexpr std::size_t n           = 16;
  const std::thread::id caller      = std::this_thread::get_id();
  std::atomic<int>      n_done      = 0;
  std::atomic<bool>     was_held_up = false, gave_up = false;
  for (int loop = 0; loop < 1000 && !was_held_up; ++loop)
    {
      n_done = 0;
      pool.parallel_for(n, 1, [&](const std::size_t begin, const std::size_t end) {
        if (std::this_thread::get_id() != caller)
          {
            was_held_up      = true;
            const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
            while (n_done < int(n - (end - begin)) && !gave_up)
              gave_up = std::chrono::steady_clock::now() > limit;
          }
        else
          std::this_thread::sleep_for(std::chrono::microseconds(100));
        n_done += int(end - begin);
      });
    }
  EXPECT_TRUE(was_held_up) << "the worker never took part";
  EXPECT_FALSE(gave_up);
}

TEST(ThreadPool, RefusesALoopWithinALoop)
{
  ThreadPool pool(2);
  const auto nothing = [](std::size_t, std::size_t) {};
  EXPECT_THROW(pool.parallel_for(16, 1, [&](std::size_t, std::size_t) { pool.parallel_for(16, 1, nothing); }),
               std::logic_error);
}

TEST(ThreadPool, EveryRangeIsDoneOnceByWhoeverIsAwake)
{
  // Many more threads than cores, and loops shorter than a wake-up: every range is done once, by whoever is awake.
  ThreadPool       pool(16);
  std::vector<int> visits(64, 0);
  for (int loop = 0; loop < 5000; ++loop)
    pool.parallel_for(visits.size(), 1, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        ++visits[i];
    });
  EXPECT_EQ(visits, std::vector<int>(64, 5000));
}

TEST(ThreadPool, GivesAThreadNoLessThanAGrain)
{
  ThreadPool pool(3);
  for (const std::size_t n : {8, 15, 16, 17, 23, 24, 1000})
    pool.parallel_for(n, 8, [&](const std::size_t begin, const std::size_t end) { EXPECT_GE(end - begin, 8u) << n; });
}
