#include "io/vtu.h"
#include <birdstrike/core/fields.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/fields.h>
#include <birdstrike/io/whole_file.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

namespace birdstrike
{
  namespace fs = std::filesystem;

  namespace
  {
    /// The entity of a value, by its own number where the snapshot has one.
    EntityPlace find_entity(const FieldSnapshot &snapshot, const bool on_cells, const std::size_t k)
    {
      const char       *kind      = on_cells ? "element" : snapshot.dim == 0 ? "particle" : "node";
      const auto        number    = std::ranges::find_if(snapshot.fields, [&](const Field &field) {
        return field.is_number && field.on_cells == on_cells && field.name == (snapshot.dim == 0 ? "id" : kind);
      });
      const std::size_t n_corners = on_cells ? std::size_t(1) << snapshot.dim : 1;
      EntityPlace       entity{kind, number == snapshot.fields.end() ? k : std::size_t(number->values[k]), {}};
      for (std::size_t c = 0; c < n_corners; ++c)
        for (std::size_t d = 0; d < 3; ++d)
          entity.position[d] +=
            snapshot.points[3 * (on_cells ? snapshot.cells[n_corners * k + c] : k) + d] / double(n_corners);
      return entity;
    }

    /// As the file would hold it: what single precision has no number for is none either.
    bool is_number(const double value)
    {
      return std::isfinite(static_cast<float>(value));
    }

    void require_numbers(const FieldSnapshot &snapshot, const std::string &file, const double time)
    {
      const auto fail = [&](const std::string &field, const std::string &unit, const double value, const bool on_cells,
                            const std::size_t entity) {
        FailureFacts facts{"A field has a value that is no number, and '" + file + "' is not written", field, value,
                           unit};
        facts.time   = time;
        facts.where  = find_entity(snapshot, on_cells, entity);
        facts.advice = "Reduce Time/Step scale and Time/Bird step scale, and check the file before.";
        throw NumericalFailure(std::move(facts));
      };
      for (std::size_t k = 0; k < snapshot.points.size(); ++k)
        if (!is_number(snapshot.points[k]))
          fail("position", "m", snapshot.points[k], false, k / 3);
      for (const Field &field : snapshot.fields)
        for (std::size_t k = 0; k < field.values.size(); ++k)
          if (!is_number(field.values[k]))
            fail(field.name, field.unit, field.values[k], field.on_cells, k / field.n_components);
    }
  } // namespace

  FieldSeries::FieldSeries(const fs::path &folder, const std::string &name) : folder(folder), name(name)
  {
    fs::create_directories(folder / "fields");
  }

  void FieldSeries::write(const FieldSnapshot &snapshot, const double time)
  {
    const std::string file = file_name(times_and_names.size());
    require_numbers(snapshot, file, time);
    stream_whole_file(folder / file, [&](std::ostream &out) { write_vtu(snapshot, time, out); });
    times_and_names.emplace_back(time, file);
    std::ostringstream list;
    dealii::DataOutBase::write_pvd_record(list, times_and_names);
    write_whole_file(folder / (name + ".pvd"), {list.view()}); // whose files are all whole
    bytes += fs::file_size(folder / file);
  }

  void FieldSeries::archive(Archive &archive)
  {
    const auto group = archive.group(name + " fields");
    archive("bytes", bytes);
    archive.records("files", times_and_names,
                    [](Archive::Row &row, std::pair<double, std::string> &entry) { row("time", entry.first); });
    for (std::size_t k = 0; k < times_and_names.size(); ++k)
      times_and_names[k].second = file_name(k);
  }

  std::string FieldSeries::file_name(const std::size_t k) const
  {
    char number[16];
    std::snprintf(number, sizeof(number), "%04zu", k);
    return "fields/" + name + "_" + number + ".vtu";
  }

  std::size_t FieldSeries::n_files() const
  {
    return times_and_names.size();
  }

  std::size_t FieldSeries::n_bytes() const
  {
    return bytes;
  }
} // namespace birdstrike
