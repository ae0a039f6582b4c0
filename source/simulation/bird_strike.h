#pragma once

#include "simulation/guards.h"
#include "simulation/scene.h"
#include "simulation/stepper.h"
#include <birdstrike/core/timing.h>
#include <birdstrike/report/progress.h>
#include <birdstrike/report/recorder.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>
#include <birdstrike/time_control/step_limiters.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>

namespace birdstrike
{
  struct CaseParameters;

  /// One strike from first touch to its end, on a scene that it is given. The members are the architecture: the scene
  /// (parts), the stepper (order of the step), the balance (ledger), what is observed, the recorder (files), the clock.
  ///
  /// Raises NumericalFailure when a part loses its state or the ledger its energy; InputError from the scene.
  class BirdStrike
  {
  public:
    /// Without a folder nothing is written: for tests and for callers that look at the parts themselves. The summary
    /// has the warnings known beforehand, and adds its own.
    BirdStrike(const CaseParameters &parameters, Scene &scene, const std::filesystem::path &folder = {},
               Warnings case_warnings = {});

    /// Steps until a stop criterion is met; goes on from where the strike stands. `between_steps` is called after each
    /// step, and once more when the last one is done, with true: the state is whole then, and may be archived.
    void run(const std::function<void(bool is_over)> &between_steps = {});

    double        time() const; ///< s since first touch
    unsigned long n_steps_done() const;
    std::string   describe_step() const; ///< the present one, and what limits it

    /// Forces of the first step, once; run() and advance() call it unless a state has been read.
    void start();
    /// One macro step.
    void advance();

    /// Writes or reads all that the run needs to go on, between steps. Reading takes a strike of the same case that has
    /// not been started.
    void archive(Archive &archive);

    /// Throws NumericalFailure for a state that is no good to go on from: what a step in `observation_stride` is asked.
    void require_sound_state() const;

    /// Asks the loop, running or still to come, to end after its present step, e.g. from a signal handler.
    static void request_stop();
    static void forget_stop_requests();

    bool is_interrupted() const ///< ended by such a request
    {
      return why_ended == EndReason::signal;
    }
    Summary     compute_summary() const;
    ToldText    closing_report() const;
    std::string describe_columns() const; ///< of what it writes

  private:
    void      plan();
    void      step();    ///< one macro step of the parts; a debug build asserts that it allocates nothing
    void      observe(); ///< peaks after each step; balance and rows when they are due
    void      record(const SystemState &state);
    void      retire_particles();
    void      retire_particles(Projectile &projectile, double horizon);
    bool      is_bird_phase_over(Projectile &projectile, double horizon);
    void      end_phase_of(Projectile &projectile);
    void      finish();
    void      end_badly();            ///< what is known so far goes to the files
    RunView   view() const;           ///< the present
    RunView   view_whole_run() const; ///< with its costs and what it skipped
    EndReason reason_to_stop() const;

    /// Measured in this run, s.
    struct UnitCosts
    {
      double particle_step = 0., element_step = 0., contact_step = 0.;
    };
    UnitCosts                compute_unit_costs() const;
    double                   n_elements() const;                ///< that are computed
    double                   estimate_seconds_per_time() const; ///< run time per simulated second, as things stand
    std::vector<SkippedWork> compute_skipped() const;
    void                     add_parts_never_built(std::vector<SkippedWork> &skipped) const;

    const CaseParameters &parameters;
    Timings               timings;
    Scene                &scene;
    Warnings              case_warnings;
    Stepper               stepper;
    struct Sections
    {
      std::size_t retirement, votes, output;
    } sections;
    Guards                  guards;
    Balance                 balance;     ///< judges the run, at a fixed stride of steps
    Balance                 row_balance; ///< what rows show: wherever one is due, so that none moves a maximum
    Observed                observed;
    std::optional<Recorder> recorder;
    Progress                progress;

    bool          is_started = false;
    double        now        = 0.; ///< s since first touch
    unsigned long n_steps    = 0;
#ifndef NDEBUG
    unsigned long n_allocated_steps = 0; // in a row, of those that made no list
#endif
    Schedule     schedule;
    StepLimiters limiters;
    EndReason    why_ended = EndReason::none;

    bool has_contact = false;
  };
} // namespace birdstrike
