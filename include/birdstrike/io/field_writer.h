#pragma once

#include <birdstrike/core/fields.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace birdstrike
{
  class FieldSeries;

  /// Writes snapshots on a thread of its own, in the order in which they come: compression and disk (5-8 ms for 7000
  /// particles and 1100 shells) stay out of the loop. The thread starts with the first snapshot, owns what it writes
  /// and never sees a part.
  ///
  /// An error of the disk is thrown again by the next write() or flush(); what was queued behind it is dropped.
  class FieldWriter
  {
  public:
    explicit FieldWriter(std::size_t capacity = 4);
    ~FieldWriter(); ///< writes what is queued; an error is logged
    FieldWriter(const FieldWriter &)            = delete;
    FieldWriter &operator=(const FieldWriter &) = delete;

    /// Waits while `capacity` snapshots are queued, or what is queued makes more than 32 MiB of files: before a large
    /// one is made, lest two of them are in memory.
    void wait_for_room();

    /// Queues one snapshot, where there is room. The series must outlive the writer.
    void write(FieldSeries &series, FieldSnapshot snapshot, double time);

    /// Waits until all is on disk.
    void flush();

  private:
    struct Task
    {
      FieldSeries  *series;
      FieldSnapshot snapshot;
      double        time;
    };

    void work();
    bool has_room() const;
    void rethrow_error(std::unique_lock<std::mutex> &lock);

    std::size_t             capacity;
    std::deque<Task>        queue; // the front is being written
    std::mutex              mutex;
    std::condition_variable has_changed;
    std::exception_ptr      error;
    bool                    is_closing = false;
    std::thread             thread;
  };
} // namespace birdstrike
