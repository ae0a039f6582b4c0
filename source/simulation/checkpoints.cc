#include "simulation/checkpoints.h"
#include "simulation/bird_strike.h"
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace birdstrike
{
  namespace fs = std::filesystem;

  namespace
  {
    std::atomic<bool> is_requested{false};

    std::string file_name(const std::uint64_t step)
    {
      return fmt::format("{}{:012}.h5", checkpoint_stem, step);
    }

    /// Sizes of a state that is good to go on from. Infinite may be what is not limited yet; NaN is nothing.
    class SoundInventory : public StateInventory
    {
    public:
      void take(const std::string &name, const ArchivedQuantity &piece) override
      {
        StateInventory::take(name, piece);
        for (const double value : piece.real)
          if (std::isnan(value))
            {
              FailureFacts facts{"The state has a value that is no number, and no checkpoint is written of it", name,
                                 value};
              facts.advice = "Reduce Time/Step scale and Time/Bird step scale, and check the last fields.";
              throw NumericalFailure(std::move(facts));
            }
      }
    };

    double seconds_since(const std::chrono::steady_clock::time_point then)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
    }
  } // namespace

  Checkpoints::Checkpoints(const OutputParameters::Checkpoints &when, const fs::path &run_folder, Checkpoint of_run,
                           const BirdStrike &strike)
    : when(when)
    , folder(run_folder / checkpoint_folder)
    , next(std::move(of_run))
    , last_file_time(strike.time())
    , last_step(strike.n_steps_done() > 0 ? std::optional(strike.n_steps_done()) : std::nullopt)
    , last_time(strike.time())
    , last_clock(std::chrono::steady_clock::now())
  {
    if (last_step)
      last_file = (folder / file_name(*last_step)).string();
  }

  void Checkpoints::request()
  {
    is_requested = true;
  }

  std::string Checkpoints::describe_last() const
  {
    return last_file + " at t = " + format_quantity(last_file_time, "s");
  }

  bool Checkpoints::is_due(const BirdStrike &strike, const bool is_over) const
  {
    if (strike.n_steps_done() == last_step)
      return false;
    return (is_over && (when.at_the_end || strike.is_interrupted())) ||
           (when.step_interval > 0 && strike.n_steps_done() - last_step.value_or(0) >= when.step_interval) ||
           (when.time_interval > 0. && strike.time() - last_time >= when.time_interval) ||
           (when.wall_interval > 0. && seconds_since(last_clock) >= when.wall_interval);
  }

  void Checkpoints::write_when_due(BirdStrike &strike, const bool is_over)
  {
    if (const bool is_wanted = is_requested.exchange(false); is_wanted || is_due(strike, is_over))
      write(strike, is_wanted);
  }

  void Checkpoints::write(BirdStrike &strike, const bool is_wanted)
  {
    strike.require_sound_state();
    next.time           = strike.time();
    next.step           = strike.n_steps_done();
    const auto describe = [&](StateSink &to) {
      Archive archive = Archive::writing(to);
      strike.archive(archive);
    };
    SoundInventory sizes;
    describe(sizes);
    last_step           = next.step; // also of one that fails: the next is tried an interval later
    last_time           = next.time;
    last_clock          = std::chrono::steady_clock::now();
    const fs::path file = folder / file_name(next.step);
    try
      {
        fs::create_directories(folder);
        write_checkpoint(file, next, sizes, describe);
      }
    catch (const std::runtime_error &error) // a disk without room for it may have room for the results
      {
        log().warn("No checkpoint at t = {}: {}. The run continues.", format_quantity(next.time, "s"), error.what());
        return;
      }
    last_file      = file.string();
    last_file_time = next.time;
    log().log(is_wanted ? spdlog::level::info : spdlog::level::debug, "Checkpoint {}, {}", describe_last(),
              strike.describe_step());
    const auto all = find_checkpoints(folder.parent_path());
    for (std::size_t k = when.n_kept; k < all.size(); ++k)
      fs::remove(all[k]);
  }

  void remove_later_checkpoints(const fs::path &run_folder, const std::uint64_t step)
  {
    for (const fs::path &file : find_checkpoints(run_folder))
      if (file.filename().string() > file_name(step))
        fs::remove(file);
  }
} // namespace birdstrike
