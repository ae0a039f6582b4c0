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
