#pragma once

#include <hdf5.h>

namespace birdstrike
{
  /// An HDF5 identifier with the function that gives it back.
  class Hdf5Handle
  {
  public:
    Hdf5Handle(const hid_t id, herr_t (*close)(hid_t)) : id(id), close(close)
    {
    }
    ~Hdf5Handle()
    {
      if (id >= 0)
        close(id);
    }
    Hdf5Handle(const Hdf5Handle &)            = delete;
    Hdf5Handle &operator=(const Hdf5Handle &) = delete;

    operator hid_t() const
    {
      return id;
    }

  private:
    hid_t id;
    herr_t (*close)(hid_t);
  };

  /// Gives a file that is to be made the oldest format that holds its contents: superblock 0 and the objects of HDF5
  /// 1.0 to 1.8, whatever library writes. HDF5 1 does so by itself; HDF5 2 takes superblock 2 and later objects unless
  /// it is told, and small readers lose attributes from the ninth on in these (The HDF Group, "HDF5 File Format
  /// Specification", sections II.A and IV.A.2.v). Returns whether the library has taken it.
  inline bool set_format(const hid_t file_access)
  {
    return H5Pset_libver_bounds(file_access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18) >= 0;
  }

  /// HDF5 prints its stack of errors unless it is told not to; while this lives it does not.
  class QuietHdf5
  {
  public:
    QuietHdf5()
    {
      H5Eget_auto2(H5E_DEFAULT, &function, &data);
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~QuietHdf5()
    {
      H5Eset_auto2(H5E_DEFAULT, function, data);
    }
    QuietHdf5(const QuietHdf5 &)            = delete;
    QuietHdf5 &operator=(const QuietHdf5 &) = delete;

  private:
    H5E_auto2_t function = nullptr;
    void       *data     = nullptr;
  };
} // namespace birdstrike
