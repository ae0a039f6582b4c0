#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace birdstrike
{
  /// What a progress line tells of one instant.
  struct ProgressState
  {
    double        time         = 0.; ///< s, simulated
    double        step         = 0.; ///< s, present macro step
    std::uint64_t n_steps      = 0;  ///< macro steps so far
    double        energy_error = 0.; ///< share of the initial energy
    std::string   limiter      = {}; ///< of the step (StepLimit::brief)
  };

  /// Prints a line at intervals of wall time: time, share, steps a second, step and what limits it, time left, energy
  /// error. On a terminal the line is written over the last one; elsewhere lines follow each other in the log. The time
  /// left is extrapolated from the last interval, smoothed, since the cost of a step changes when the bird has gone.
  class Progress
  {
  public:
    using Clock = std::function<double()>;                  ///< s of wall time
    using Sink  = std::function<void(const std::string &)>; ///< takes one line without its end

    /// Writes to the terminal or the log.
    Progress(double end_time, double wall_interval);
    Progress(double end_time, double wall_interval, Clock clock, Sink sink);

    /// True once the interval has passed since the last line; cheap enough to be asked every step.
    bool is_due() const;

    /// Prints a line now.
    void print(const ProgressState &state);

    /// Ends the line on a terminal, so that other output starts on its own line.
    void finish();

  private:
    double        end_time;
    double        wall_interval;
    Clock         clock;
    Sink          sink;
    bool          overwrites = false;
    std::size_t   width      = 0;
    double        last_wall  = 0.;
    double        last_time  = 0.;
    std::uint64_t last_steps = 0;
    double        rate       = 0.; ///< simulated s per s of wall time, smoothed
    bool          has_line   = false;

    std::string compose(const ProgressState &state, double steps_per_second) const;
  };
} // namespace birdstrike
