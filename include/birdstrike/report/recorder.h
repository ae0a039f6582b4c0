#pragma once

#include <birdstrike/core/fields.h>
#include <birdstrike/io/field_writer.h>
#include <birdstrike/io/fields.h>
#include <birdstrike/report/history.h>
#include <birdstrike/report/run_view.h>
#include <birdstrike/time_control/ticks.h>

#include <memory>
#include <optional>
#include <vector>

namespace birdstrike
{
  class HistoryTable;

  /// Turns a run into curves and fields: history.csv, filtered.csv and results.h5, blade.pvd and bird.pvd. It looks at
  /// parts and never acts on them. Columns of parts that the scene lacks do not exist.
  class Recorder
  {
  public:
    /// Opens the files in `folder`. What the view refers to must outlive the recorder, parts apart.
    Recorder(const RunView &run, const std::filesystem::path &folder);
    ~Recorder();

    /// Whether a row of the history or a field file is due.
    bool is_due(double time) const;

    /// Writes what is due; whether that was a row of the history.
    bool record(const RunView &run);

    /// Writes the last state whatever the intervals say, and waits until all is on disk.
    void finish(const RunView &run);

    /// Which rows and fields have been written.
    void archive(Archive &archive);

    /// Brings history.csv up to date where the flush interval has passed on the clock.
    void flush_when_due(double wall);

    /// For a run that ends badly: what is known so far. Fields that are queued are written by the destructor.
    void flush();

  private:
    void add_root_profile(const RunView &run);
    void append_row(const RunView &run);
    void set_mid_chord_lines(const Observed &observed);
    void write_filtered(const FilteredForce &force);
    void write_fields(const RunView &run);
    void add_table(const HistoryTable &source);
    void flush_tables();

    const RunView        *present = nullptr; ///< while a row is made
    std::filesystem::path folder;
    struct Table;
    std::vector<std::unique_ptr<Table>> tables; ///< of what the case asks for; the history writes them to results.h5
    History                             history;
    std::optional<FieldSeries>          blade_fields, bird_fields;
    FieldSnapshot                       no_bird;               ///< its fields without a particle
    bool                                has_left_bird = false; ///< and this has been written
    FieldWriter                         writer;                // after what it writes to: it ends first
    Ticks                               history_ticks, field_ticks;
    double                              last_row = -1., last_field = -1.;
    double                              flush_interval, last_flush = 0.; // s, on the clock
  };
} // namespace birdstrike
