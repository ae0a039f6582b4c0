#pragma once

#include "simulation/observed.h"
#include <birdstrike/io/field_writer.h>
#include <birdstrike/io/fields.h>
#include <birdstrike/report/balance.h>
#include <birdstrike/report/history.h>
#include <birdstrike/structure/reports.h>
#include <birdstrike/time_control/ticks.h>

#include <optional>

namespace birdstrike
{
  struct CaseParameters;
  struct ContactParameters;
  struct Scene;

  /// Turns a scene into curves and fields: history.csv and results.h5, blade.pvd and bird.pvd. It looks at parts and
  /// never acts on them. Columns of parts that the scene lacks do not exist.
  class Recorder
  {
  public:
    /// Opens the files in `folder`; `observed` and `balance` must outlive the recorder.
    Recorder(const Scene &scene, const CaseParameters &parameters, const std::filesystem::path &folder,
             const Observed &observed, const Balance &balance);

    /// Whether a row of the history or a field file is due.
    bool is_due(double time) const;

    /// Writes what is due at this time; whether that was a row of the history.
    bool record(double time, unsigned long n_steps);

    /// Writes the last state whatever the intervals say, and waits until all is on disk.
    void finish(double time, unsigned long n_steps);

    /// Brings history.csv up to date where the flush interval has passed on the clock.
    void flush_when_due(double wall);

    /// For a run that ends badly: what is known so far. Fields that are queued are written by the destructor.
    void flush();

  private:
    void add_clock_and_balance_columns();
    void add_bird_columns();
    void add_contact_columns(const ContactParameters &parameters);
    void add_blade_columns();
    void add_root_profile();
    void set_mid_chord_lines();
    void write_fields(double time);

    const Scene               &scene;
    const Observed            &observed;
    const Balance             &balance;
    History                    history;
    std::optional<FieldSeries> blade_fields, bird_fields;
    FieldWriter                writer; // after what it writes to: it ends first
    Ticks                      history_ticks, field_ticks;
    double                     now      = 0.;
    unsigned long              steps    = 0;
    double                     last_row = -1., last_field = -1.;
    double                     flush_interval, last_flush = 0.; // s, on the clock
  };
} // namespace birdstrike
