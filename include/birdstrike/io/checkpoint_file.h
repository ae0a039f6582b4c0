#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/io/input_files.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  // Of a run folder: checkpoints/checkpoint_000000001234.h5, by time step.
  constexpr const char *checkpoint_folder = "checkpoints", *checkpoint_stem = "checkpoint_";

  /// A run between two of its steps, and what it takes to know that it is this run.
  struct Checkpoint
  {
    std::string            parameters; ///< every entry with its value, as parameters.prm
    std::vector<InputFile> inputs;     ///< as they were when the run began
    std::string            program;    ///< version and build that wrote it
    double                 time = 0.;  ///< s since first touch
    std::uint64_t          step = 0;   ///< time steps so far
    ArchivedState          state;
    /// Of time steps that a resumed run has changed: "Time/Step scale from 0.9 to 0.2 at 0.3 ms".
    std::vector<std::string> changes = {};
  };

  /// One file: a line of text, padded to 512 bytes, that says format, length and CRC-32 of the rest; then HDF5 (any
  /// reader of HDF5 from 1.8 on opens the whole, the line is its user block; its superblock is of version 0, see
  /// set_format). /state holds the quantities one behind the other:
  /// their `names` (each ends with a zero byte) and `shapes` (four numbers each: components, 1 for doubles and 0 for
  /// 64-bit integers, how many values, how many lengths of lists), then all values, `real` and `whole`, and all
  /// `lengths`. /parameters and /inputs are texts.
  ///
  /// The file is written aside, flushed to the disk and renamed: under its name it is complete, whatever happens to the
  /// process. Throws std::runtime_error where the disk refuses; nothing is left behind then.
  ///
  /// `describe` writes the state, whose sizes are those of `sizes`, and each piece goes to the disk: no copy of the
  /// state stands in memory. `checkpoint.state` is not looked at.
  void write_checkpoint(const std::filesystem::path &file, const Checkpoint &checkpoint, const StateInventory &sizes,
                        FunctionRef<void(StateSink &)> describe);

  /// The same of a state in memory, `checkpoint.state`.
  void write_checkpoint(const std::filesystem::path &file, const Checkpoint &checkpoint);

  /// Those of a run folder, newest first.
  std::vector<std::filesystem::path> find_checkpoints(const std::filesystem::path &run_folder);

  /// Throws InputError, in a sentence, for a file that is not there, no checkpoint, of a later format, cut off or
  /// damaged: length and checksum are compared before HDF5 sees a byte.
  Checkpoint read_checkpoint(const std::filesystem::path &file);
} // namespace birdstrike
