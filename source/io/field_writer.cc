#include <birdstrike/core/allocation_guard.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/field_writer.h>
#include <birdstrike/io/fields.h>

#include <spdlog/logger.h>

#include <utility>

namespace birdstrike
{
  FieldWriter::FieldWriter(const std::size_t capacity) : capacity(capacity)
  {
  }

  FieldWriter::~FieldWriter()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      is_closing = true;
    }
    has_changed.notify_all();
    if (thread.joinable())
      thread.join();
    try
      {
        if (error)
          std::rethrow_exception(error);
      }
    catch (const std::exception &failure)
      {
        log().error("{}", failure.what());
      }
  }

  void FieldWriter::wait_for_room()
  {
    std::unique_lock<std::mutex> lock(mutex);
    has_changed.wait(lock, [&] { return has_room() || error; });
    rethrow_error(lock);
  }

  void FieldWriter::write(FieldSeries &series, FieldSnapshot snapshot, const double time)
  {
    wait_for_room();
    std::unique_lock<std::mutex> lock(mutex);
    queue.push_back({&series, std::move(snapshot), time});
    if (!thread.joinable())
      thread = std::thread([this] { work(); });
    lock.unlock();
    has_changed.notify_all();
  }

  void FieldWriter::flush()
  {
    std::unique_lock<std::mutex> lock(mutex);
    has_changed.wait(lock, [&] { return queue.empty(); });
    rethrow_error(lock);
  }

  bool FieldWriter::has_room() const
  {
    constexpr std::size_t most    = 32 << 20; // bytes
    std::size_t           n_bytes = 0;
    for (const Task &task : queue)
      n_bytes += compute_field_file_bytes(task.snapshot);
    return queue.size() < capacity && n_bytes <= most;
  }

  void FieldWriter::rethrow_error(std::unique_lock<std::mutex> &lock)
  {
    if (!error)
      return;
    const std::exception_ptr thrown = std::exchange(error, nullptr);
    lock.unlock();
    std::rethrow_exception(thrown);
  }

  void FieldWriter::work()
  {
    AllocationGuard::exempt_this_thread();
    std::unique_lock<std::mutex> lock(mutex);
    while (true)
      {
        has_changed.wait(lock, [&] { return !queue.empty() || is_closing; });
        if (queue.empty())
          return;
        Task &task = queue.front(); // others only append: a deque keeps its elements where they are
        lock.unlock();
        std::exception_ptr failure;
        try
          {
            task.series->write(task.snapshot, task.time);
          }
        catch (...)
          {
            failure = std::current_exception();
          }
        lock.lock();
        if (failure)
          {
            error = failure;
            queue.clear();
          }
        else
          queue.pop_front();
        has_changed.notify_all();
      }
  }
} // namespace birdstrike
