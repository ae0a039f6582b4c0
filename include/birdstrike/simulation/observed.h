#pragma once

#include <birdstrike/blade/mid_chord.h>
#include <birdstrike/blade/reports.h>
#include <birdstrike/time_control/peak.h>

#include <array>
#include <optional>
#include <vector>

namespace birdstrike
{
  class Balance;
  struct Scene;

  /// What is watched of a run between its steps: present values and peaks. Peaks of root and tip are taken at every
  /// observation, not only where a row of the history is due.
  struct Observed
  {
    RootSectionReport        root;
    TipDeflection            tip;
    PeakPlasticStrain        plastic;
    FailureReport            failure;
    std::vector<ProbeValues> probes;
    std::array<double, 3>    force{}; ///< N, of contact on the blade

    Peak         tip_peak; ///< m, mid-chord
    FirstMaximum first_tip_peak;
    Peak         root_stress, root_moment; ///< Pa, N m, absolute values
    Peak         root_force;               ///< N, norm of normal and transverse force
    Peak         contact_force;            ///< N, norm
    Peak         hourglass_share;          ///< hourglass over internal energy of the blade

    RootSectionReport root_at_peak_stress; ///< the distribution along the chord when the stress peaks

    std::optional<MidChord> mid_chord;         ///< of a blade that has such a line
    std::vector<double>     mid_chord_at_peak; ///< m, per station, when the tip peaks

    double max_penetration = 0.; ///< m

    /// Before the first step, while the blade is undeformed.
    void start(const Scene &scene);

    void update(const Scene &scene, const Balance &balance, double time);
  };
} // namespace birdstrike
