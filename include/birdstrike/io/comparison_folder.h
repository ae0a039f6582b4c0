#pragma once

#include <filesystem>
#include <string>

namespace birdstrike
{
  /// The folder of one comparison: its table, figures and data, and below it one run folder for each case that had to
  /// be run. It is recognised by a marker file, `.birdstrike-comparison`. A missing or empty folder is taken, one with
  /// the marker is written over; a run folder, a folder of someone else's and one that another comparison is writing
  /// into are refused with an InputError. It is locked while this object lives.
  class ComparisonFolder
  {
  public:
    explicit ComparisonFolder(const std::filesystem::path &directory);
    ~ComparisonFolder();
    ComparisonFolder(const ComparisonFolder &)            = delete;
    ComparisonFolder &operator=(const ComparisonFolder &) = delete;

    const std::filesystem::path &path() const;

    /// Writes a file; throws std::runtime_error if the disk refuses.
    void write_text(const std::string &name, const std::string &text) const;

    /// Where the run of a case belongs: its name as a folder's, blanks and separators as hyphens.
    static std::filesystem::path run_folder(const std::filesystem::path &directory, const std::string &name);

    /// Throws InputError as the constructor does; takes nothing.
    static void require_usable(const std::filesystem::path &directory);

  private:
    std::filesystem::path directory;
    int                   lock = -1;
  };
} // namespace birdstrike
