#pragma once

#include <birdstrike/core/archive.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace birdstrike
{
  struct FieldSnapshot;

  /// A series of field files for ParaView: <folder>/<name>.pvd lists <folder>/fields/<name>_0000.vtu, ... with their
  /// times. The list is rewritten after every file, so that an unfinished run can be looked at.
  ///
  /// Raises NumericalFailure for a snapshot with a value that is no number, and leaves files and list as they are;
  /// std::logic_error for one whose arrays do not fit together, std::runtime_error where the disk refuses.
  class FieldSeries
  {
  public:
    FieldSeries(const std::filesystem::path &folder, const std::string &name);

    void write(const FieldSnapshot &snapshot, double time);

    /// The files so far; those written after an archive are overwritten by a run that goes on from it.
    void archive(Archive &archive);

    std::size_t n_files() const;
    std::size_t n_bytes() const; ///< on disk, so far

  private:
    std::string file_name(std::size_t k) const; ///< from the folder on

    std::filesystem::path                       folder;
    std::string                                 name;
    std::vector<std::pair<double, std::string>> times_and_names;
    std::size_t                                 bytes = 0;
  };

  /// Bytes of the numbers of one snapshot file before compression, for a forecast of disk space.
  std::size_t compute_field_file_bytes(const FieldSnapshot &snapshot);
} // namespace birdstrike
