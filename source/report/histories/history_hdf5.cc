#include "report/histories/history_hdf5.h"

#include <birdstrike/io/hdf5_handle.h>
#include <birdstrike/io/whole_file.h>

#include <cstdint>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
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

  /// In memory: deal.II's HDF5 objects abort the process when an exception unwinds past them, and HDF5 itself dumps its
  /// stack where the disk is full.
  struct ResultsFile::InMemory
  {
    InMemory() : access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), file(create(access), H5Fclose)
    {
      require(file);
    }

    static hid_t create(const hid_t access)
    {
      constexpr std::size_t increment = 1 << 20;
      H5Pset_fapl_core(access, increment, false);
      require(set_format(access) ? 0 : -1);
      return H5Fcreate("results", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    }

    static std::int64_t require(const std::int64_t result)
    {
      if (result < 0)
        throw std::runtime_error("HDF5 refuses to make results.h5: is the memory exhausted?");
      return result;
    }

    static void set_attribute(const hid_t data, const char *name, const std::string &value)
    {
      const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
      H5Tset_size(type, H5T_VARIABLE);
      H5Tset_cset(type, H5T_CSET_UTF8);
      const Hdf5Handle attribute(H5Acreate2(data, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      const char      *text = value.c_str();
      require(H5Awrite(attribute, type, &text));
    }

    QuietHdf5  quiet;
    Hdf5Handle access, file;
  };

  ResultsFile::ResultsFile(const std::filesystem::path &path) : path(path), in_memory(new InMemory)
  {
  }

  ResultsFile::~ResultsFile() = default;

  void ResultsFile::write(const std::string &group, const std::string &name, const Column &what,
                          const std::vector<std::size_t> &shape, const std::vector<double> &values)
  {
    const std::vector<hsize_t> n(shape.begin(), shape.end());
    const Hdf5Handle           make(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(make, 1);
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(n.size()), n.data(), nullptr), H5Sclose);
    const Hdf5Handle data(H5Dcreate2(in_memory->file, (group + '/' + name).c_str(), H5T_NATIVE_DOUBLE, space, make,
                                     H5P_DEFAULT, H5P_DEFAULT),
                          H5Dclose);
    InMemory::require(data);
    InMemory::require(H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    InMemory::set_attribute(data, "name", what.name);
    InMemory::set_attribute(data, "unit", what.unit);
    InMemory::set_attribute(data, "description", what.meaning);
  }

  void ResultsFile::close()
  {
    InMemory::require(H5Fflush(in_memory->file, H5F_SCOPE_GLOBAL));
    std::string bytes(static_cast<std::size_t>(InMemory::require(H5Fget_file_image(in_memory->file, nullptr, 0))), 0);
    InMemory::require(H5Fget_file_image(in_memory->file, bytes.data(), bytes.size()));
    in_memory.reset();
    write_whole_file(path, {bytes});
  }

  std::vector<double> read_result(const std::filesystem::path &path, const std::string &dataset)
  {
    if (!std::filesystem::exists(path))
      return {};
    const auto refuse = [&] {
      return std::runtime_error("Cannot read " + dataset + " of " + path.string() + ": is the file damaged?");
    };
    const QuietHdf5 quiet;
    if (H5Fis_hdf5(path.c_str()) <= 0)
      throw refuse();
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (file < 0)
      throw refuse();
    if (!has_link(file, dataset))
      return {};
    const Hdf5Handle data(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space(data < 0 ? -1 : H5Dget_space(data), H5Sclose);
    const auto       n = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
    if (n < 0)
      throw refuse();
    std::vector<double> values(static_cast<std::size_t>(n));
    if (n > 0 && H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      throw refuse();
    return values;
  }
} // namespace birdstrike
