#include "io/hdf5/hdf5_on_disk.h"

#if defined(H5_VERSION_GE) && H5_VERSION_GE(1, 13, 0)
#  include <H5FDdevelop.h>
#endif

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

/// A virtual file driver (The HDF Group, "HDF5 Virtual File Layer", 2022) on a descriptor of the system.
namespace birdstrike::hdf5_on_disk
{
  namespace
  {
    struct File
    {
      H5FD_t  common; // HDF5's own; the first member
      Target *target;
      haddr_t end_of_space, end_of_file;
    };

    File &as_file(H5FD_t *const file)
    {
      return *reinterpret_cast<File *>(file);
    }
    const File &as_file(const H5FD_t *const file)
    {
      return *reinterpret_cast<const File *>(file);
    }

    H5FD_t *open_file(const char *, unsigned, const hid_t access, haddr_t)
    {
      Target *target = nullptr;
      std::memcpy(&target, H5Pget_driver_info(access), sizeof target);
      return &(new File{{}, target, 0, 0})->common;
    }

    herr_t close_file(H5FD_t *const file)
    {
      delete &as_file(file);
      return 0;
    }

    herr_t query(const H5FD_t *, unsigned long *const flags)
    {
      if (flags)
        *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
                 H5FD_FEAT_AGGREGATE_SMALLDATA;
      return 0;
    }

    haddr_t end_of_space(const H5FD_t *const file, H5FD_mem_t)
    {
      return as_file(file).end_of_space;
    }

    herr_t set_end_of_space(H5FD_t *const file, H5FD_mem_t, const haddr_t address)
    {
      as_file(file).end_of_space = address;
      return 0;
    }

    haddr_t end_of_file(const H5FD_t *const file, H5FD_mem_t)
    {
      return as_file(file).end_of_file;
    }

    /// Calls transfer(done) for the number of bytes that follow those that are done, until all are, none follows or the
    /// system refuses; an interrupted call is made again.
    template <class Transfer>
    std::size_t repeat(const std::size_t size, Target &target, const Transfer &transfer)
    {
      std::size_t done = 0;
      while (done < size && target.error == 0)
        {
          const ssize_t n = transfer(done);
          if (n == 0)
            break;
          if (n > 0)
            done += static_cast<std::size_t>(n);
          else if (errno != EINTR)
            target.error = errno;
        }
      return done;
    }

    /// Beyond the end of the file there are zeros.
    herr_t read(H5FD_t *const file, H5FD_mem_t, hid_t, const haddr_t address, const std::size_t size,
                void *const buffer)
    {
      Target           &target = *as_file(file).target;
      char *const       bytes  = static_cast<char *>(buffer);
      const auto        place  = static_cast<off_t>(address + target.offset);
      const std::size_t n      = repeat(size, target, [&](const std::size_t done) {
        return ::pread(target.descriptor, bytes + done, size - done, place + static_cast<off_t>(done));
      });
      std::fill(bytes + n, bytes + size, '\0');
      return 0;
    }

    herr_t write(H5FD_t *const file, H5FD_mem_t, hid_t, const haddr_t address, const std::size_t size,
                 const void *const buffer)
    {
      Target           &target = *as_file(file).target;
      const char *const bytes  = static_cast<const char *>(buffer);
      const auto        place  = static_cast<off_t>(address + target.offset);
      repeat(size, target, [&](const std::size_t done) {
        return ::pwrite(target.descriptor, bytes + done, size - done, place + static_cast<off_t>(done));
      });
      as_file(file).end_of_file = std::max<haddr_t>(as_file(file).end_of_file, address + size);
      return 0;
    }

    herr_t truncate(H5FD_t *const file, hid_t, hbool_t)
    {
      File   &own    = as_file(file);
      Target &target = *own.target;
      if (own.end_of_file != own.end_of_space && target.error == 0 &&
          ::ftruncate(target.descriptor, static_cast<off_t>(own.end_of_space + target.offset)) != 0)
        target.error = errno;
      own.end_of_file = own.end_of_space;
      return 0;
    }

    H5FD_class_t describe_driver()
    {
      H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION
      driver.version = H5FD_CLASS_VERSION;
      driver.value   = static_cast<H5FD_class_value_t>(700); // beyond those that are reserved
#endif
      driver.name      = "birdstrike";
      driver.maxaddr   = HADDR_MAX >> 1;
      driver.fc_degree = H5F_CLOSE_WEAK;
      driver.fapl_size = sizeof(Target *);
      driver.open      = open_file;
      driver.close     = close_file;
      driver.query     = query;
      driver.get_eoa   = end_of_space;
      driver.set_eoa   = set_end_of_space;
      driver.get_eof   = end_of_file;
      driver.read      = read;
      driver.write     = write;
      driver.truncate  = truncate;
      return driver;
    }
  } // namespace

  bool set_target(const hid_t access, Target &target)
  {
    static const H5FD_class_t driver        = describe_driver();
    static const hid_t        number        = H5FDregister(&driver);
    const Target *const       of_properties = &target;
    return number >= 0 && H5Pset_driver(access, number, &of_properties) >= 0;
  }
} // namespace birdstrike::hdf5_on_disk
