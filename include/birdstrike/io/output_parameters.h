#pragma once

#include <birdstrike/core/named_choices.h>
#include <birdstrike/structure/histories.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// What a run leaves behind, and how often. Section `Output`. Intervals of simulated time are in s, of the console in
  /// s of wall time. Raises InputError from check().
  struct OutputParameters
  {
    std::string directory;                 ///< empty: runs/<case name>
    double      history_interval = 10e-6;  ///< s, between rows of history.csv
    double      field_interval   = 0.5e-3; ///< s, between field files; 0: only the first and the last state
    double      console_interval = 2.;     ///< s of wall time between progress lines
    double      flush_interval   = 30.;    ///< s of wall time between flushes of history.csv
    bool        blade_fields     = true;   ///< blade.pvd
    bool        bird_fields      = true;   ///< bird.pvd
    bool        hdf5             = true;   ///< results.h5 beside history.csv
    bool        copies_inputs    = true;   ///< into the run folder
    bool        is_deformed      = false;  ///< blade's points in its fields
    bool        removed_fly_on   = false;  ///< in the bird's fields

    /// Section `Output/Checkpoint`. An interval of 0: none by it.
    struct Checkpoints
    {
      unsigned int step_interval = 0;    ///< time steps
      double       time_interval = 0.;   ///< s, simulated
      double       wall_interval = 600.; ///< s, on the clock
      bool         at_the_end    = true;
      unsigned int n_kept        = 2;

      bool are_planned() const
      {
        return step_interval > 0 || time_interval > 0. || wall_interval > 0. || at_the_end;
      }
    } checkpoints;

    double channel_class = 1000.; ///< Hz, of the filtered contact force; 0: none

    HistoryRequests histories; ///< of the blade

    void declare(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// Channel frequency classes (Hz) of SAE J211-1.
  const NamedChoices<double> &channel_classes();

  // How they are spelt: "undeformed", "deformed"; "left out", "fly on".
  const NamedChoices<bool> &blade_geometries();
  const NamedChoices<bool> &removed_particle_choices();
} // namespace birdstrike
