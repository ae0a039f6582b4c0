#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What a folder of reports on several runs is for.
  struct ReportKind
  {
    std::string              name;  ///< "comparison": in messages, and of the marker file, `.birdstrike-comparison`
    std::vector<std::string> stems; ///< of tables and figures: those of an earlier one must not be taken for this one's
    std::vector<std::string> others = {}; ///< further files, likewise
  };

  /// The folder of one comparison or study: its table, figures and data, and below it one run folder for each case that
  /// had to be run. It is recognised by a marker file. A missing or empty folder is taken, one with the marker is
  /// written over; a run folder, a folder of someone else's and one that another report is written into are refused
  /// with an InputError. It is locked while this object lives. Whether a report that is there may be lost is asked by
  /// whoever writes the new one.
  class ReportFolder
  {
  public:
    /// Drops the tables and figures of an earlier report of the kind, unless it keeps them until drop_results().
    ReportFolder(const std::filesystem::path &directory, const ReportKind &kind, bool keeps_results = false);
    ~ReportFolder();
    ReportFolder(const ReportFolder &)            = delete;
    ReportFolder &operator=(const ReportFolder &) = delete;

    void drop_results() const;

    const std::filesystem::path &path() const;

    std::filesystem::path file(const std::string &name) const;

    /// Writes a file; throws std::runtime_error if the disk refuses.
    void write_text(const std::string &name, const std::string &text) const;

    /// Where the run of a case belongs: its name as a folder's, blanks and separators as hyphens.
    static std::filesystem::path run_folder(const std::filesystem::path &directory, const std::string &name);

    /// Throws InputError as the constructor does; takes nothing.
    static void require_usable(const std::filesystem::path &directory, const ReportKind &kind);

  private:
    std::filesystem::path directory;
    ReportKind            kind;
    int                   lock = -1;
  };
} // namespace birdstrike
