#pragma once

#include <hdf5.h>

#include <cstddef>

/// HDF5 that goes into an open file as it is made, and that a full disk does not trouble.
namespace birdstrike::hdf5_on_disk
{
  /// The file that HDF5 writes to. What the disk refuses is kept here and HDF5 hears nothing of it: a file that it
  /// cannot write it cannot close either, and it tries again, with a stack of messages, when the process ends. What is
  /// written after an error is lost, so that whoever made the target asks for it.
  struct Target
  {
    int         descriptor = -1; ///< open for reading and writing
    std::size_t offset     = 0;  ///< bytes of the file that stand before HDF5's
    int         error      = 0;  ///< errno of the first call that failed
  };

  /// Files that are made with this access property go to the target, which outlives them; their name means nothing.
  /// Returns whether the library has taken it.
  bool set_target(hid_t access, Target &target);
} // namespace birdstrike::hdf5_on_disk
