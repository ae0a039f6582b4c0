#include "io/vtu.h"
#include <birdstrike/io/fields.h>

#include <deal.II/base/data_out_base.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace birdstrike
{
  namespace fs = std::filesystem;

  FieldSeries::FieldSeries(const fs::path &folder, const std::string &name) : folder(folder), name(name)
  {
    fs::create_directories(folder / "fields");
  }

  void FieldSeries::write(const FieldSnapshot &snapshot, const double time)
  {
    const std::string file = file_name(times_and_names.size());
    std::ofstream     out(folder / file, std::ios::binary);
    if (!out)
      throw std::runtime_error("Cannot write " + (folder / file).string());
    write_vtu(snapshot, time, out);
    times_and_names.emplace_back(time, file);
    std::ofstream list(folder / (name + ".pvd"));
    dealii::DataOutBase::write_pvd_record(list, times_and_names);
    out.flush();
    list.flush();
    if (!out || !list)
      throw std::runtime_error("Cannot write " + (folder / file).string() + ": is the disk full?");
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
