#pragma once

#include "io/hdf5/hdf5_on_disk.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/hdf5_handle.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// HDF5 files of arrays of doubles, 64-bit integers and letters: written piece by piece, read in memory.
namespace birdstrike::hdf5_in_memory
{
  inline void require(const bool is_well, const char *what)
  {
    if (!is_well)
      throw std::runtime_error(std::string("HDF5 refuses to ") + what + ": is the memory exhausted?");
  }

  /// As the machine has it: HDF5 writes down which, and converts for a reader that has it otherwise.
  template <class T>
  hid_t native()
  {
    if constexpr (std::is_same_v<T, char>)
      return H5T_NATIVE_UINT8;
    else
      return std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64;
  }

  /// A data set with a place in it, for arrays that lie one behind the other.
  template <class T>
  class Column
  {
  public:
    Column(const hid_t id, const std::size_t n) : data(id, H5Dclose), n(n)
    {
    }

    bool is_open() const
    {
      return data >= 0;
    }
    std::size_t left() const
    {
      return n - at;
    }
    /// The next `length` values, at most left().
    bool read(T *const values, const hsize_t length)
    {
      return pass(length, [&](const hid_t memory, const hid_t file) {
        return H5Dread(data, native<T>(), memory, file, H5P_DEFAULT, values);
      });
    }
    bool write(const T *const values, const hsize_t length)
    {
      return pass(length, [&](const hid_t memory, const hid_t file) {
        return H5Dwrite(data, native<T>(), memory, file, H5P_DEFAULT, values);
      });
    }
    /// At another place, which moves on behind them.
    bool write(std::size_t &place, const std::vector<T> &values)
    {
      at    = place;
      place = at + values.size();
      return place <= n && write(values.data(), values.size());
    }

  private:
    template <class Transfer>
    bool pass(const hsize_t length, const Transfer &transfer)
    {
      if (length == 0)
        return true;
      const Hdf5Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose), file(H5Dget_space(data), H5Sclose);
      const hsize_t    begin = at;
      at += length;
      return H5Sselect_hyperslab(file, H5S_SELECT_SET, &begin, nullptr, &length, nullptr) >= 0 &&
             transfer(memory, file) >= 0;
    }

    Hdf5Handle  data;
    std::size_t n, at = 0;
  };

  /// A file that goes to the disk as it is made.
  class Writer
  {
  public:
    /// The target outlives it, and is asked for errors of the disk once this has gone.
    explicit Writer(hdf5_on_disk::Target &target)
      : access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), file(create(access, target), H5Fclose)
    {
      require(file >= 0, "make a file");
    }

    template <class T>
    Column<T> column(const std::string &path, const hsize_t n)
    {
      const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose), make(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
      H5Pset_create_intermediate_group(make, 1);
      return {H5Dcreate2(file, path.c_str(), native<T>(), space, make, H5P_DEFAULT, H5P_DEFAULT), n};
    }

    template <class Values> // a vector or a text
    void write(const std::string &path, const Values &values)
    {
      auto to = column<typename Values::value_type>(path, values.size());
      require(to.is_open() && to.write(values.data(), values.size()), "take values");
    }

    /// Hands over what HDF5 still holds.
    void finish()
    {
      require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "end a file");
    }

  private:
    static hid_t create(const hid_t access, hdf5_on_disk::Target &target)
    {
      require(hdf5_on_disk::set_target(access, target), "take a file of the system");
      require(set_format(access), "choose the format of a file");
      return H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    }

    QuietHdf5  quiet;
    Hdf5Handle access, file;
  };

  /// Of a file whose checksum is right: what is missing was written by another version.
  class Reader
  {
  public:
    Reader(const std::filesystem::path &name, std::string &&bytes)
      : name(name)
      , bytes(std::move(bytes))
      , access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose)
      , file(open(access, this->bytes), H5Fclose)
    {
      if (file < 0)
        refuse("/");
    }

    template <class T>
    Column<T> column(const std::string &path) const
    {
      const hid_t      id = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
      const Hdf5Handle space(id < 0 ? -1 : H5Dget_space(id), H5Sclose);
      const auto       n = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
      if (n < 0 || H5Sget_simple_extent_ndims(space) != 1 || static_cast<std::size_t>(n) > bytes.size() / sizeof(T))
        {
          H5Dclose(id);
          refuse(path);
        }
      return {id, static_cast<std::size_t>(n)};
    }

    template <class Values> // a vector or a text
    Values read(const std::string &path) const
    {
      auto   from = column<typename Values::value_type>(path);
      Values values(from.left(), {});
      if (!from.read(values.data(), values.size()))
        refuse(path);
      return values;
    }

    bool has(const std::string &path) const
    {
      return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
    }

    [[noreturn]] void refuse(const std::string &path) const
    {
      throw InputError("The checkpoint " + name.string() + " has no '" + path +
                       "' that this program can read: it was written by another version.");
    }

  private:
    static hid_t open(const hid_t access, std::string &bytes)
    {
      constexpr std::size_t increment = 1 << 16;
      H5Pset_fapl_core(access, increment, false);
      H5Pset_file_image(access, bytes.data(), bytes.size());
      return H5Fopen("checkpoint", H5F_ACC_RDONLY, access);
    }

    QuietHdf5             quiet;
    std::filesystem::path name;
    std::string           bytes;
    Hdf5Handle            access, file;
  };
} // namespace birdstrike::hdf5_in_memory
