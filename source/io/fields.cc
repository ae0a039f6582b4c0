#include "io/vtu.h"
#include <birdstrike/io/fields.h>
#include <birdstrike/io/whole_file.h>

#include <deal.II/base/data_out_base.h>

#include <cstdio>
#include <sstream>

namespace birdstrike
{
  namespace fs = std::filesystem;

  FieldSeries::FieldSeries(const fs::path &folder, const std::string &name) : folder(folder), name(name)
  {
    fs::create_directories(folder / "fields");
  }

  void FieldSeries::write(const FieldSnapshot &snapshot, const double time)
  {
    const std::string  file = file_name(times_and_names.size());
    std::ostringstream out, list;
    write_vtu(snapshot, time, out);
    write_whole_file(folder / file, {out.view()});
    times_and_names.emplace_back(time, file);
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
