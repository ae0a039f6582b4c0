#pragma once

#include <filesystem>
#include <string>

namespace birdstrike
{
  /// The folder of one run. It is recognised by a marker file, `.birdstrike`, that tells the state of the run
  /// ("running", "done", "failed: ..."), and it is locked while this object lives, so that two runs never write into
  /// one folder.
  ///
  /// A missing or empty folder is taken; a folder that holds the marker is emptied of the files that a run writes (and
  /// of nothing else); any other folder is refused with an InputError. `summary.json` is written last, by rename: where
  /// it stands, the run is complete.
  class RunFolder
  {
  public:
    explicit RunFolder(const std::filesystem::path &directory);

    /// The folder of a run that shall go on, locked, and left as it is until go_on(). Throws InputError where no run
    /// has been.
    static RunFolder of_resumed_run(const std::filesystem::path &directory);

    /// Marks it as running and removes summary.json and failure.json, for it is neither complete nor lost any more.
    void go_on();

    ~RunFolder(); ///< a run that was neither finished nor failed is marked "failed: interrupted"
    RunFolder(const RunFolder &)            = delete;
    RunFolder &operator=(const RunFolder &) = delete;

    const std::filesystem::path &path() const;
    std::filesystem::path        file(const std::string &name) const;

    /// Writes a whole file; the name appears only once the text is complete on disk. Throws std::runtime_error if the
    /// disk refuses.
    void write_text(const std::string &name, const std::string &text) const;

    /// Writes summary.json and marks the run as done: the last act of a run.
    void finish(const std::string &summary_json);

    /// Marks the run as failed, by the first line of the reason; the folder keeps its histories and gets no summary,
    /// but failure.json where there is a record.
    void fail(const std::string &reason, const std::string &failure_json = "") noexcept;

  private:
    std::filesystem::path directory;
    int                   lock     = -1;
    bool                  is_ended = false;

    enum class Contents
    {
      removed,
      kept
    };
    RunFolder(const std::filesystem::path &directory, Contents contents);
    void take(Contents contents);
    void mark(const std::string &state) const;
  };

  /// Whether a run has come to its end there.
  bool holds_finished_run(const std::filesystem::path &directory);

  /// Removes what could be taken for results of a run that is still to start in this folder: summary and histories of
  /// the one before. Its parameters stay, for they may be what that run is made of. A folder of no run is left alone,
  /// one in use refused with an InputError.
  void drop_results(const std::filesystem::path &directory);

  /// While this lives no run takes the folder; any number of readers may.
  class RunFolderInUse
  {
  public:
    explicit RunFolderInUse(const std::filesystem::path &directory); ///< of a run, or of nobody
    ~RunFolderInUse();
    RunFolderInUse(const RunFolderInUse &)            = delete;
    RunFolderInUse &operator=(const RunFolderInUse &) = delete;

    /// A run is writing into it: what is there will change.
    bool is_of_a_running_run() const;

  private:
    int  lock             = -1;
    bool is_being_written = false;
  };
} // namespace birdstrike
