#pragma once

#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/output_parameters.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  class BirdStrike;

  /// The checkpoints of one run: when one is due, and which are kept.
  class Checkpoints
  {
  public:
    /// `of_run`: what every checkpoint of it says, without time, step and state.
    Checkpoints(const OutputParameters::Checkpoints &when, const std::filesystem::path &run_folder, Checkpoint of_run,
                const BirdStrike &strike);

    /// Between two steps: writes one that is due by steps, time or clock, or that a signal has asked for. Of a state
    /// that is no good there is none: throws NumericalFailure.
    void write_when_due(BirdStrike &strike, bool is_over);

    /// The newest file, also of the run that this one goes on with; empty where there is none.
    const std::string &last() const
    {
      return last_file;
    }
    /// "checkpoints/checkpoint_000000001234.h5 at t = 1 ms"
    std::string describe_last() const;

    /// Asks for one after the present step, e.g. from a signal handler.
    static void request();

  private:
    bool is_due(const BirdStrike &strike, bool is_over) const;
    void write(BirdStrike &strike, bool is_wanted); ///< wanted: by a signal, which is answered

    OutputParameters::Checkpoints         when;
    std::filesystem::path                 folder;
    Checkpoint                            next;
    std::string                           last_file;
    double                                last_file_time;
    std::optional<std::uint64_t>          last_step; ///< that is on the disk
    double                                last_time;
    std::chrono::steady_clock::time_point last_clock;
  };

  /// Of time steps after this one: they must not count among those that are kept.
  void remove_later_checkpoints(const std::filesystem::path &run_folder, std::uint64_t step);
} // namespace birdstrike
