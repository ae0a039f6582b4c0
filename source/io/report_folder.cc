#include <birdstrike/core/errors.h>
#include <birdstrike/io/report_folder.h>

#include <sys/file.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr auto marker_of_a_run = ".birdstrike";

    std::string marker_of(const ReportKind &kind)
    {
      return std::string(marker_of_a_run) + "-" + kind.name;
    }

    constexpr auto action = "\n  Action: choose another folder with --output DIR.";
  } // namespace

  void ReportFolder::require_usable(const fs::path &directory, const ReportKind &kind)
  {
    std::error_code error;
    const bool      is_there = fs::exists(directory, error);
    if (error) // a name that is too long, a folder above it that is closed
      throw InputError("The folder of the " + kind.name + ", '" + directory.string() +
                       "', cannot be: " + error.message() + "." + action);
    if (is_there && !fs::is_directory(directory, error))
      throw InputError("The folder of the " + kind.name + ", '" + directory.string() + "', is a file." + action);
    if (fs::exists(directory / marker_of_a_run, error))
      throw InputError("The folder of the " + kind.name + ", '" + directory.string() +
                       "', is the folder of a run, whose files would mix with its own." + action);
    if (fs::is_directory(directory, error) && !fs::exists(directory / marker_of(kind), error) &&
        !fs::is_empty(directory, error))
      throw InputError("The folder '" + directory.string() + "' holds files that no " + kind.name +
                       " has written.\n  Allowed: a new or empty folder, or that of an "
                       "earlier comparison, which is written over." +
                       action);
  }

  ReportFolder::ReportFolder(const fs::path &directory, const ReportKind &kind, const bool keeps_results)
    : directory(directory), kind(kind)
  {
    require_usable(directory, kind);
    std::error_code error;
    fs::create_directories(directory, error);
    lock = error ? -1 : ::open((directory / marker_of(kind)).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0)
      throw InputError("Cannot write into the folder of the " + kind.name + ", '" + directory.string() +
                       "': " + (error ? error.message() : std::strerror(errno)) + "." + action);
    // Some network file systems know no locks: there, nothing stops a second comparison.
    if (::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      {
        ::close(lock);
        throw InputError("Another " + kind.name + " is writing into the folder '" + directory.string() + "'." + action);
      }
    if (!keeps_results)
      drop_results();
  }

  void ReportFolder::drop_results() const
  {
    std::error_code error;
    for (const std::string &stem : kind.stems) // other files are somebody's own
      for (const char *ending : {".csv", ".svg"})
        fs::remove(directory / (stem + ending), error);
    for (const std::string &name : kind.others)
      fs::remove(directory / name, error);
  }

  ReportFolder::~ReportFolder()
  {
    ::close(lock);
  }

  const fs::path &ReportFolder::path() const
  {
    return directory;
  }

  fs::path ReportFolder::file(const std::string &name) const
  {
    return directory / name;
  }

  void ReportFolder::write_text(const std::string &name, const std::string &text) const
  {
    std::ofstream out(directory / name, std::ios::binary);
    out << text;
    out.flush();
    if (!out)
      throw std::runtime_error("Cannot write " + (directory / name).string() + ": is the disk full?");
  }

  fs::path ReportFolder::run_folder(const fs::path &directory, const std::string &name)
  {
    std::string plain = name;
    for (char &letter : plain)
      if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.' && letter != '_' && letter != '-')
        letter = '-';
    if (plain.find_first_not_of('.') == std::string::npos)
      plain = "case" + plain; // "." and ".." are other folders
    return directory / plain;
  }
} // namespace birdstrike
