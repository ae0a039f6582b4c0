#include "report/histories/history_hdf5.h"

#include <deal.II/base/hdf5.h>

#include <fstream>
#include <map>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    /// An HDF5 identifier with the function that gives it back. deal.II's reader only asserts that what it opens is
    /// there, and its objects abort the process when an exception unwinds past them: reading is done without it.
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t)) : id(id), close(close)
      {
      }
      ~Handle()
      {
        if (id >= 0)
          close(id);
      }
      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id;
      }

    private:
      hid_t id;
      herr_t (*close)(hid_t);
    };

    /// Whether every part of the path exists; HDF5 itself asks for one after the other.
    bool has_link(const hid_t file, const std::string &path)
    {
      for (std::size_t end = 0; end != std::string::npos;)
        {
          end = path.find('/', end + 1);
          if (H5Lexists(file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
            return false;
        }
      return true;
    }
  } // namespace

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

  void ResultsFile::write(const std::string &group, const std::string &name, const Column &what,
                          const std::vector<std::size_t> &shape, const std::vector<double> &values)
  {
    auto found = open->groups.find(group);
    if (found == open->groups.end())
      found = open->groups.emplace(group, open->file.create_group(group)).first;
    const std::vector<hsize_t> dimensions(shape.begin(), shape.end());
    auto                       dataset = found->second.create_dataset<double>(name, dimensions);
    dataset.write(values);
    dataset.set_attribute("name", what.name);
    dataset.set_attribute("unit", what.unit);
    dataset.set_attribute("description", what.meaning);
    n_bytes += values.size() * sizeof(double);
  }

  void ResultsFile::close()
  {
    open.reset();
    if (std::filesystem::file_size(part) < n_bytes)
      throw std::runtime_error("Cannot write " + part.string() + ": is the disk full?");
    std::filesystem::rename(part, path);
  }

  std::vector<double> read_result(const std::filesystem::path &path, const std::string &dataset)
  {
    if (!std::filesystem::exists(path))
      return {};
    const auto refuse = [&] {
      return std::runtime_error("Cannot read " + dataset + " of " + path.string() + ": is the file damaged?");
    };
    if (H5Fis_hdf5(path.c_str()) <= 0)
      throw refuse();
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (file < 0)
      throw refuse();
    if (!has_link(file, dataset))
      return {};
    const Handle data(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle space(data < 0 ? -1 : H5Dget_space(data), H5Sclose);
    const auto   n = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
    if (n < 0)
      throw refuse();
    std::vector<double> values(static_cast<std::size_t>(n));
    if (n > 0 && H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      throw refuse();
    return values;
  }
} // namespace birdstrike
