#include <birdstrike/core/log.h>
#include <birdstrike/report/progress.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    double read_steady_clock()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
  } // namespace

  Progress::Progress(const double end_time, const double wall_interval)
    : Progress(end_time, wall_interval, read_steady_clock, {})
  {
    overwrites = ::isatty(STDOUT_FILENO) == 1;
  }

  Progress::Progress(const double end_time, const double wall_interval, Clock clock, Sink sink)
    : end_time(end_time)
    , wall_interval(wall_interval)
    , clock(std::move(clock))
    , sink(std::move(sink))
    , last_wall(this->clock())
  {
  }

  bool Progress::is_due() const
  {
    return clock() - last_wall >= wall_interval;
  }

  void Progress::print(const ProgressState &state)
  {
    const double now       = clock();
    const double wall      = std::max(now - last_wall, 1e-9);
    const double new_rate  = (state.time - last_time) / wall;
    rate                   = has_line ? 0.5 * (rate + new_rate) : new_rate;
    const std::string line = compose(state, (state.n_steps - last_steps) / wall);
    last_wall              = now;
    last_time              = state.time;
    last_steps             = state.n_steps;
    has_line               = true;
    if (sink)
      sink(line);
    else if (overwrites)
      {
        width = std::max(width, line.size());
        std::printf("\r%-*s", static_cast<int>(width), line.c_str());
        std::fflush(stdout);
        log().debug("{}", line); // the file's share; the console does not show this severity
      }
    else
      log().info("{}", line);
  }

  void Progress::finish()
  {
    if (overwrites && has_line)
      std::printf("\n");
    std::fflush(stdout);
    has_line = false;
  }

  std::string Progress::compose(const ProgressState &state, const double steps_per_second) const
  {
    const double left = rate > 0. ? std::max(end_time - state.time, 0.) / rate : -1.;
    return fmt::format("t = {:.4f} ms ({:5.1f} %)  {:.4g} steps/s  dt = {}{}  left {}  energy error {:.2g} %",
                       1e3 * state.time, 100. * state.time / end_time, steps_per_second,
                       format_quantity(state.step, "s"), state.limiter.empty() ? "" : " by " + state.limiter,
                       format_duration(left), 100. * state.energy_error);
  }
} // namespace birdstrike
