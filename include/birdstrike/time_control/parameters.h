#pragma once

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// The clock: how long a run lasts, what share of the stable step it takes, and when it ends early. Section `Time`.
  /// Raises InputError from check(); computes no step itself.
  struct TimeParameters
  {
    double       end_time         = 10e-3;    ///< s, counted from first contact (or from the start where nothing flies)
    double       step_scale       = 0.9;      ///< -, share of the blade's stable step
    double       bird_step_scale  = 1.;       ///< -, share of the bird's and the contact's step
    bool         multirate        = true;     ///< bird and blade each at their own limit
    unsigned int maximum_ratio    = 50;       ///< -, largest number of sub-steps within one macro step
    bool         stop_at_tip_peak = false;    ///< end once the tip has passed its first peak
    double       tip_peak_wait    = 1e-3;     ///< s, without a higher value before the peak counts as passed
    double       bird_phase_tolerance = 1e-3; ///< -, of the impulse: what the bird may still give when it is dropped
    double       smallest_step        = 1e-3; ///< -, of a part's first stable step: below it the run ends
    double       energy_error_limit   = 0.05; ///< -, share of the initial energy
    double       maximum_wall_time    = 0.;   ///< s, 0: no limit
    unsigned int threads              = 0;    ///< -, 0: one for each core this process may use
    bool         forces_threads       = false; ///< also more than there are cores

    void declare(dealii::ParameterHandler &prm);
    void check() const;

    /// `threads`, with 0 replaced by the number of cores that this process may use, and no more than those unless
    /// forced: threads that take turns on a core wait for each other in every loop.
    unsigned int n_threads() const;
  };
} // namespace birdstrike
