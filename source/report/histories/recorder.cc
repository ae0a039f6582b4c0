#include "report/histories/columns.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/recorder.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/histories.h>

#include <algorithm>
#include <utility>

namespace birdstrike
{
  namespace
  {
    /// Intervals of zero mean "first and last state only".
    Ticks field_ticks_of(const double interval)
    {
      return Ticks(interval > 0. ? interval : 1e300);
    }

    /// The points of a blade to where they are.
    void deform(FieldSnapshot &blade)
    {
      const auto displacement = std::ranges::find(blade.fields, std::string("displacement"), &Field::name);
      for (std::size_t k = 0; k < blade.points.size(); ++k)
        blade.points[k] += displacement->values[k];
      blade.is_deformed = true;
    }

    std::vector<History::Axis> root_axes(const RootSectionReport &root)
    {
      return {{axis("face"), {-1., 1.}}, {axis("chord"), root.chord_position}};
    }
  } // namespace

  Recorder::Recorder(const RunView &run, const std::filesystem::path &folder)
    : folder(folder)
    , history(folder, run.parameters.output.hdf5)
    , history_ticks(run.parameters.output.history_interval)
    , field_ticks(field_ticks_of(run.parameters.output.field_interval))
    , flush_interval(run.parameters.output.flush_interval)
  {
    for (HistoryColumn &column : history_columns(&run))
      history.add_column(column.what, [this, value = std::move(column.value)] { return value(*present); });
    if (run.blade)
      add_root_profile(run);
    if (run.histories)
      for (const auto &source : run.histories->tables)
        add_table(*source);
    if (run.blade && run.parameters.output.blade_fields)
      blade_fields.emplace(folder, "blade");
    if (run.has_bird() && run.parameters.output.bird_fields)
      {
        bird_fields.emplace(folder, "bird");
        no_bird        = run.bird_snapshot();
        no_bird.points = {}; // with its memory
        no_bird.cells  = {};
        for (Field &field : no_bird.fields)
          field.values = {};
      }
  }

  Recorder::~Recorder() = default;

  /// A file of its own: time, and what the source has.
  struct Recorder::Table
  {
    const HistoryTable &source;
    History             history;
    double              time = 0.;
    std::vector<double> row;

    Table(const HistoryTable &source, const std::filesystem::path &folder)
      : source(source), history(folder, false, source.name + ".csv"), row(source.columns.size())
    {
      history.add_column(axis("time"), [this] { return time; });
      for (std::size_t k = 0; k < row.size(); ++k)
        history.add_column(source.columns[k], [this, k] { return row[k]; });
    }
    void append_row(const double now)
    {
      time = now;
      source.fill(row);
      history.append_row();
    }
  };

  void Recorder::add_table(const HistoryTable &source)
  {
    tables.push_back(std::make_unique<Table>(source, folder));
    history.add_group(tables.back()->history);
  }

  void Recorder::add_root_profile(const RunView &run)
  {
    const RootSectionReport root = run.blade->root_section();
    const std::size_t       n    = root.chord_position.size();
    if (n > 0)
      history.add_profile(profile("root_normal_stress"), root_axes(root), [this, n](const std::span<double> values) {
        const RootSectionReport &now = present->observed.root;
        std::copy_n(now.stress_struck.begin(), n, values.begin());
        std::copy_n(now.stress_rear.begin(), n, values.begin() + n);
      });
  }

  void Recorder::append_row(const RunView &run)
  {
    present = &run;
    history.append_row();
    present = nullptr;
    for (const auto &table : tables)
      table->append_row(run.time);
    last_row = run.time;
  }

  void Recorder::write_fields(const RunView &run)
  {
    if (blade_fields)
      {
        FieldSnapshot blade = run.blade->snapshot();
        if (run.parameters.output.is_deformed)
          deform(blade);
        writer.write(*blade_fields, std::move(blade), run.time);
      }
    const bool has_bird = run.has_bird() || run.parameters.output.removed_fly_on;
    if (bird_fields && (has_bird || !std::exchange(has_left_bird, true))) // ParaView shows the last file from there on
      {
        writer.wait_for_room();
        FieldSnapshot bird = run.has_bird() ? run.bird_snapshot() : no_bird;
        if (run.parameters.output.removed_fly_on)
          run.observed.removed_particles.add_to(bird, run.time);
        writer.write(*bird_fields, std::move(bird), run.time);
      }
    last_field = run.time;
  }

  bool Recorder::is_due(const double time) const
  {
    return history_ticks.would_be_due(time) || field_ticks.would_be_due(time);
  }

  bool Recorder::record(const RunView &run)
  {
    const bool is_row = history_ticks.is_due(run.time);
    if (is_row)
      append_row(run);
    if (field_ticks.is_due(run.time))
      write_fields(run);
    return is_row;
  }

  void Recorder::finish(const RunView &run)
  {
    if (last_row < run.time)
      append_row(run);
    if (last_field < run.time)
      write_fields(run);
    const RootSectionReport &root = run.observed.root_at_peak_stress;
    if (!root.chord_position.empty())
      {
        std::vector<double> values = root.stress_struck;
        values.insert(values.end(), root.stress_rear.begin(), root.stress_rear.end());
        history.set_constant(profile("root_normal_stress_at_peak"), root_axes(root), std::move(values));
      }
    set_mid_chord_lines(run.observed);
    if (!run.observed.filtered_force.values.empty())
      write_filtered(run.observed.filtered_force);
    flush();
    writer.flush();
  }

  void Recorder::set_mid_chord_lines(const Observed &observed)
  {
    if (!observed.mid_chord)
      return;
    const std::vector<History::Axis> span{{axis("span"), observed.mid_chord->span_position()}};
    if (!observed.mid_chord_at_peak.empty())
      history.set_constant(profile("mid_chord_deflection_at_peak"), span, observed.mid_chord_at_peak);
    std::vector<double> now_deflected;
    observed.mid_chord->compute_deflection(now_deflected);
    history.set_constant(profile("mid_chord_deflection_at_end"), span, std::move(now_deflected));
  }

  void Recorder::write_filtered(const FilteredForce &force)
  {
    std::size_t         row = 0;
    std::vector<double> times, values;
    History             table(folder, false, "filtered.csv");
    for (unsigned int k = 0; k < 4; ++k)
      table.add_column(filtered_columns()[k], [&, k] { return k == 0 ? force.time(row) : force.values[row][k - 1]; });
    for (; row < force.values.size(); ++row)
      {
        table.append_row();
        times.push_back(force.time(row));
        values.insert(values.end(), force.values[row].begin(), force.values[row].end());
      }
    history.set_constant(profile("filtered"), {{axis("time"), std::move(times)}, {axis("component"), {0., 1., 2.}}},
                         std::move(values));
  }

  void Recorder::flush_when_due(const double wall)
  {
    if (wall - last_flush < flush_interval)
      return;
    flush_tables();
    last_flush = wall;
  }

  void Recorder::flush_tables()
  {
    history.flush_table();
    for (const auto &table : tables)
      table->history.flush_table();
  }

  void Recorder::flush()
  {
    for (const auto &table : tables)
      table->history.flush();
    history.flush();
  }

  void Recorder::archive(Archive &archive)
  {
    const auto group = archive.group("output");
    if (!archive.is_reading())
      {
        writer.flush(); // what the lists name is on the disk
        flush_tables();
      }
    history.archive(archive);
    for (const auto &table : tables)
      table->history.archive(archive);
    archive("bird has left", has_left_bird);
    for (auto *series : {&blade_fields, &bird_fields})
      if (*series)
        (*series)->archive(archive);
    history_ticks.archive(archive, "rows due");
    field_ticks.archive(archive, "fields due");
    archive("last", last_row, last_field);
    if (archive.is_reading())
      flush_tables();
  }
} // namespace birdstrike
