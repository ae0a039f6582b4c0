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
    char number[16];
    std::snprintf(number, sizeof(number), "%04zu", times_and_names.size());
    const std::string file = "fields/" + name + "_" + number + ".vtu";
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

  std::size_t FieldSeries::n_files() const
  {
    return times_and_names.size();
  }

  std::size_t FieldSeries::n_bytes() const
  {
    return bytes;
  }
} // namespace birdstrike
