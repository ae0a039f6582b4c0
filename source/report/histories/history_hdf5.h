#pragma once

#include <birdstrike/core/column.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Writes one HDF5 file whole, at close(): a reader never meets half a file, and an earlier one stays where the disk
  /// is full. Throws std::runtime_error where the disk refuses.
  class ResultsFile
  {
  public:
    explicit ResultsFile(const std::filesystem::path &path);
    ~ResultsFile();

    /// /<group>/<name>, row-major, with the attributes "name", "unit" and "description" that say what it is.
    void write(const std::string &group, const std::string &name, const Column &what,
               const std::vector<std::size_t> &shape, const std::vector<double> &values);

    void close();

  private:
    struct InMemory;
    std::filesystem::path     path;
    std::unique_ptr<InMemory> in_memory;
  };

  /// A dataset of such a file by its path, e.g. "history/time", row-major; empty if the file or the dataset does not
  /// exist. Throws std::runtime_error if it exists and cannot be read.
  std::vector<double> read_result(const std::filesystem::path &path, const std::string &dataset);
} // namespace birdstrike
