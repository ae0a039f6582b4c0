#include <birdstrike/core/errors.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/io/whole_file.h>

#include <sys/file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr auto marker = ".birdstrike";

    /// What a run writes of results but for field files.
    constexpr std::array results{"summary.json", "failure.json", "history.csv",  "filtered.csv",
                                 "blades.csv",   "nodes.csv",    "elements.csv", "gauges.csv",
                                 "sections.csv", "patches.csv",  "results.h5"};

    /// stem, digits, ending: blade_0012.vtu
    bool is_numbered(const std::string &name, const std::string &stem, const std::string &ending)
    {
      const std::size_t n = stem.size() + ending.size();
      return name.size() > n && name.starts_with(stem) && name.ends_with(ending) &&
             name.find_first_not_of("0123456789", stem.size()) == name.size() - ending.size();
    }

    /// By the very names that a run gives: whatever else lies in its folder is somebody's own.
    bool is_written_by_a_run(const fs::path &path)
    {
      std::string name = path.filename().string();
      if (name.ends_with(".part"))
        name.erase(name.size() - 5);
      for (const char *known : {"original.prm", "parameters.prm", "resumed.prm", "log.txt", "blade.pvd", "bird.pvd"})
        if (name == known)
          return true;
      return std::ranges::find(results, name) != results.end() || is_numbered(name, "blade_", ".vtu") ||
             is_numbered(name, "bird_", ".vtu") || is_numbered(name, checkpoint_stem, ".h5");
    }

    /// Throws InputError where somebody else holds the folder.
    void lock_alone(const int lock, const fs::path &directory)
    {
      // Some network file systems know no locks: there, nothing stops a second run.
      if (::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw InputError("The folder '" + directory.string() +
                         "' is in use: another run writes into it, or a comparison reads it.\n  Action: wait for it, "
                         "or choose another folder with --output DIR.");
    }

    void write_state(const int lock, const fs::path &directory, const std::string &state)
    {
      // In place, not by rename: the lock belongs to this very file.
      const std::string line = state + "\n";
      if (::ftruncate(lock, 0) != 0 || ::pwrite(lock, line.data(), line.size(), 0) != static_cast<ssize_t>(line.size()))
        throw std::runtime_error("Cannot write " + (directory / marker).string() + ": " + std::strerror(errno));
    }

    /// Removes the files of an earlier run and folders that this leaves empty.
    void remove_results(const fs::path &folder)
    {
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && is_written_by_a_run(entry.path()))
          fs::remove(entry.path());
      for (const char *below : {"fields", checkpoint_folder})
        {
          const fs::path inner = folder / below;
          if (!fs::is_directory(fs::symlink_status(inner)))
            continue;
          remove_results(inner);
          if (fs::is_empty(inner))
            fs::remove(inner);
        }
    }
  } // namespace

  RunFolder::RunFolder(const fs::path &directory) : RunFolder(directory, Contents::removed)
  {
  }

  RunFolder RunFolder::of_resumed_run(const fs::path &directory)
  {
    if (!fs::exists(directory / marker))
      throw InputError("'" + directory.string() +
                       "' is no folder of a run.\n  Allowed: the folder of a run that has left a checkpoint.");
    return {directory, Contents::kept};
  }

  RunFolder::RunFolder(const fs::path &directory, const Contents contents) : directory(directory)
  {
    try
      {
        take(contents);
      }
    catch (const fs::filesystem_error &error)
      {
        if (lock >= 0)
          ::close(lock);
        throw InputError("Cannot write into the run folder '" + directory.string() + "': " + error.code().message() +
                         ".\n  Action: choose another folder with --output DIR.");
      }
    catch (...)
      {
        if (lock >= 0)
          ::close(lock);
        throw;
      }
  }

  RunFolder::~RunFolder()
  {
    if (!is_ended)
      fail("interrupted");
    ::close(lock);
  }

  void RunFolder::take(const Contents contents)
  {
    if (fs::exists(directory) && !fs::is_directory(directory))
      throw InputError("The run folder '" + directory.string() +
                       "' is a file.\n  Action: choose another folder with --output DIR.");
    fs::create_directories(directory);
    if (!fs::exists(file(marker)) && !fs::is_empty(directory))
      throw InputError("The folder '" + directory.string() +
                       "' holds files that no run has written.\n  Allowed: a new or empty folder, or that of an "
                       "earlier run, which is replaced.\n  Action: choose another folder with --output DIR.");
    lock = ::open(file(marker).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0)
      throw fs::filesystem_error("marker", file(marker), std::error_code(errno, std::generic_category()));
    lock_alone(lock, directory);
    // In this order: whoever kills the program in between leaves nothing that looks like a complete run.
    if (contents == Contents::kept)
      is_ended = true; // as it is
    else
      {
        go_on();
        remove_results(directory);
      }
  }

  void RunFolder::go_on()
  {
    is_ended = false;
    mark("running");
    for (const char *name : {"summary.json", "failure.json"})
      fs::remove(file(name));
  }

  void RunFolder::mark(const std::string &state) const
  {
    write_state(lock, directory, state);
  }

  bool holds_finished_run(const fs::path &directory)
  {
    return fs::exists(directory / marker) && fs::exists(directory / "summary.json"); // written last, by rename
  }

  void drop_results(const fs::path &directory)
  {
    const int lock = ::open((directory / marker).c_str(), O_RDWR | O_CLOEXEC);
    if (lock < 0)
      return; // no run's folder
    try
      {
        lock_alone(lock, directory);
        write_state(lock, directory, "failed: it never started");
        for (const char *name : results)
          fs::remove(directory / name);
      }
    catch (...)
      {
        ::close(lock);
        throw;
      }
    ::close(lock);
  }

  const fs::path &RunFolder::path() const
  {
    return directory;
  }

  fs::path RunFolder::file(const std::string &name) const
  {
    return directory / name;
  }

  void RunFolder::write_text(const std::string &name, const std::string &text) const
  {
    write_whole_file(file(name), {text});
  }

  void RunFolder::finish(const std::string &summary_json)
  {
    write_text("summary.json", summary_json);
    is_ended = true;
    mark("done");
  }

  RunFolderInUse::RunFolderInUse(const fs::path &directory)
    : lock(::open((directory / marker).c_str(), O_RDONLY | O_CLOEXEC))
  {
    // Some network file systems know no locks: there, nothing stops a run.
    is_being_written = lock >= 0 && ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }

  RunFolderInUse::~RunFolderInUse()
  {
    if (lock >= 0)
      ::close(lock);
  }

  bool RunFolderInUse::is_of_a_running_run() const
  {
    return is_being_written;
  }

  void RunFolder::fail(const std::string &reason, const std::string &failure_json) noexcept
  {
    is_ended = true;
    try
      {
        if (!failure_json.empty())
          write_text("failure.json", failure_json);
        mark("failed: " + reason.substr(0, reason.find('\n')));
      }
    catch (const std::exception &)
      {
        // The marker still says "running" and there is no summary: nobody takes this for a result.
      }
  }
} // namespace birdstrike
