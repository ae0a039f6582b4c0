#pragma once

#include <birdstrike/core/warning.h>
#include <birdstrike/report/balance.h>
#include <birdstrike/report/observed.h>
#include <birdstrike/time_control/end_reason.h>
#include <birdstrike/time_control/step_limiters.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;
  class Bird;
  class Blade;
  struct BladeHistories;
  struct ContactReport;
  struct FieldSnapshot;

  /// Work that a run did not do: what, how much of it, and the share of the run time that it would have been (NaN: no
  /// estimate).
  struct SkippedWork
  {
    std::string what;
    double      count = 0.;
    std::string unit;
    double      saved = 0.;
  };

  /// What the bird was when the clock started.
  struct BirdAtStart
  {
    std::size_t           particles = 0;
    double                mass = 0., kinetic_energy = 0.; ///< kg, J
    std::array<double, 3> momentum{};                     ///< N s
  };

  /// How the bird meets the blade; of a scene without contact all is NaN.
  struct StrikeAim
  {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::array<double, 3> point{{none, none, none}}; ///< m, that the bird's axis goes through
    double span = none, chord = none; ///< share of the span from the root, of the chord from its leading edge
    std::array<double, 3> velocity{{none, none, none}};      ///< m/s, relative to the blade there
    double                speed = none, normal_speed = none; ///< m/s
    double                angle               = none;        ///< degrees, between velocity and surface
    double                hugoniot_pressure   = none;        ///< Pa, of the normal speed
    double                stagnation_pressure = none;        ///< Pa
    std::array<double, 3> position{{none, none, none}};      ///< m, of its centre at time 0, where the case gives it,
    double                arrival  = none;                   ///< s, and of the first touch then
    double                duration = none; ///< s, length (of a slice: along the velocity) over speed; none of a slab
  };

  /// One bird of a run.
  struct BirdOfRun
  {
    unsigned int          number   = 1;       ///< 1: section Bird, k: Bird k
    std::size_t           first_id = 0;       ///< of its particles in files
    const Bird           *bird     = nullptr; ///< none once it has gone
    BirdAtStart           at_start;
    StrikeAim             aim;
    double                arrival = 0.;  ///< s
    std::array<double, 3> impulse{};     ///< N s, on the blade
    std::size_t           n_retired = 0; ///< particles that the computation has let go

    double retired_mass() const; ///< kg; particles of one bird have one mass
  };

  /// All that is known of a run at one instant: what every quantity (source/report/quantities.h) is taken from. Parts
  /// that the case lacks, or that have gone, are null. What is said of the whole run is known at its end only.
  struct RunView
  {
    const CaseParameters &parameters;
    const Observed       &observed;
    const Balance        &balance; ///< that judges the run
    const Balance        &shown;   ///< of the present state
    const Blade          *blade;
    const ContactReport  *contact; ///< of all birds together
    bool                  has_self_contact;
    const BladeHistories *histories = nullptr; ///< none: nothing is asked for

    double        time      = 0.; ///< s, since first touch
    unsigned long n_steps   = 0;
    double        bird_step = 0., blade_step = 0.; ///< s

    std::vector<BirdOfRun> birds = {};

    BirdAtStart bird_at_start = {}; ///< of all together
    StrikeAim   aim           = {}; ///< of the first

    EndReason   end_reason    = EndReason::none;
    std::size_t n_blade_steps = 0, n_bird_steps = 0;
    double      wall = 0., particle_step = 0., element_step = 0.; ///< s of run time: in all, per step of an entity

    std::vector<SkippedWork>           skipped       = {};
    std::vector<StepLimiters::Limiter> limiters      = {}; ///< of macro steps
    Warnings                           case_warnings = {}; ///< known before the first step

    bool        has_bird() const;      ///< that is computed still
    double      closing_force() const; ///< N, of contact on the mean of the last 0.25 ms: a drop may touch any instant
    bool        is_pushed() const;     ///< at the end, by a closing force of more than 1 % of the filtered peak
    bool        may_deflect_further() const; ///< is pushed, or has only swung back against the push so far
    std::size_t n_particles() const;
    std::size_t n_retired() const;       ///< of all together, as the next
    double      retired_mass() const;    ///< kg
    FieldSnapshot bird_snapshot() const; ///< of all together, empty if all have gone
  };
} // namespace birdstrike
