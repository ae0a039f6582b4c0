#pragma once

#include <birdstrike/report/contact_watch.h>
#include <birdstrike/report/removed_particles.h>
#include <birdstrike/structure/probes/mid_chord.h>
#include <birdstrike/structure/reports.h>
#include <birdstrike/time_control/peak.h>

#include <array>
#include <optional>
#include <vector>

namespace birdstrike
{
  class Balance;
  class Blade;

  /// The peaks of an elastic blade of a row, over every macro step.
  struct BladePeaks
  {
    unsigned int place = 1;
    SignedPeak   tip;         ///< m, mid-chord
    Peak         root_moment; ///< N m, absolute value, as the next
    Peak         root_stress; ///< Pa
  };

  /// What is watched of a run between its steps: present values, for rows of the history, and peaks, for the summary.
  /// Peaks of the contact force are over every evaluation of contact, those of tip and root over every macro step,
  /// those of energies over a fixed stride of steps: none depends on when output is due.
  struct Observed
  {
    RootSectionReport              root;
    TipDeflection                  tip;
    std::vector<PeakPlasticStrain> plastic; // of sections
    FailureReport                  failure;
    std::vector<ProbeValues>       probes;
    std::array<double, 3>          force{}; ///< N, of contact on the blade

    SignedPeak   tip_peak; ///< m, mid-chord
    FirstMaximum first_tip_peak;
    Peak         root_stress, root_moment; ///< Pa, N m, absolute values
    Peak         root_force;               ///< N, norm of normal and transverse force
    Peak         hourglass_share;          ///< hourglass over internal energy of the blade
    ContactWatch contact;

    RemovedParticles removed_particles; ///< where Output/Removed particles asks for them

    FilteredForce filtered_force;   ///< at the end of a run, if Output/Channel class asks for one
    double        smooth_peak = 0.; ///< N, the filtered force's, also where none is asked for (ContactWatch)

    RootSectionReport root_at_peak_stress; ///< the distribution along the chord when the stress peaks

    std::vector<BladePeaks> row; ///< elastic blades of a row, by place

    std::optional<MidChord> mid_chord;         ///< of a blade that has such a line
    std::vector<double>     mid_chord_at_peak; ///< m, per station, when the tip peaks

    /// Before the first step, while the blade is undeformed.
    void start(const Blade &blade);

    /// After each macro step: what is cheap, a few nodes and elements.
    void update_peaks(const Blade &blade, bool has_contact, double time);

    /// After each update of the balance that judges the run.
    void update_shares(const Balance &balance, double time);

    /// The peaks, and what they are taken of.
    void archive(Archive &archive);

    /// At the end; `channel_class` (Hz) of what is asked for, 0: nothing.
    void filter_force(double channel_class);

    /// Before a row, and at the end: what asks all elements.
    void update_present(const Blade &blade);
  };
} // namespace birdstrike
