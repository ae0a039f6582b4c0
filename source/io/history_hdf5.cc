#include "history_hdf5.h"

#include <deal.II/base/hdf5.h>

#include <fstream>
#include <map>
#include <stdexcept>

namespace birdstrike
{
  struct ResultsFile::Open
  {
    dealii::HDF5::File                         file;
    std::map<std::string, dealii::HDF5::Group> groups;
  };

  ResultsFile::ResultsFile(const std::filesystem::path &path) : path(path), part(path.string() + ".part")
  {
    // deal.II 9.4 only asserts that the file could be made, and asserts vanish in release builds.
    if (!std::ofstream(part))
      throw std::runtime_error("Cannot write " + part.string());
    open.reset(new Open{dealii::HDF5::File(part.string(), dealii::HDF5::File::FileAccessMode::create), {}});
  }

  ResultsFile::~ResultsFile() = default;

  void ResultsFile::write(const std::string &group, const std::string &name, const std::string &unit,
                          const std::vector<std::size_t> &shape, const std::vector<double> &values)
  {
    auto found = open->groups.find(group);
    if (found == open->groups.end())
      found = open->groups.emplace(group, open->file.create_group(group)).first;
    const std::vector<hsize_t> dimensions(shape.begin(), shape.end());
    auto                       dataset = found->second.create_dataset<double>(name, dimensions);
    dataset.write(values);
    dataset.set_attribute("unit", unit);
    n_bytes += values.size() * sizeof(double);
  }

  void ResultsFile::close()
  {
    open.reset();
    if (std::filesystem::file_size(part) < n_bytes)
      throw std::runtime_error("Cannot write " + part.string() + ": is the disk full?");
    std::filesystem::rename(part, path);
  }
} // namespace birdstrike
