#include "io/inputs/file_entries.h"
#include <birdstrike/io/input_files.h>

namespace birdstrike
{
  namespace fs = std::filesystem;

  namespace
  {
    bool is_file(const fs::path &path)
    {
      std::error_code error;
      return fs::exists(path, error) && !fs::is_directory(path, error); // a pipe is one, too
    }
  } // namespace

  bool names_file(const KnownEntry &entry)
  {
    return entry.pattern.starts_with("[FileName");
  }

  bool have_same_contents(const fs::path &a, const fs::path &b)
  {
    std::error_code error;
    if (fs::equivalent(a, b, error))
      return true;
    if (!fs::is_regular_file(a, error) || !fs::is_regular_file(b, error) ||
        fs::file_size(a, error) != fs::file_size(b, error))
      return false;
    const std::string of_a = fingerprint_of(a);
    return !of_a.empty() && of_a == fingerprint_of(b);
  }

  FoundFile find_beside(const std::string &name, const fs::path &folder)
  {
    if (name.empty() || folder.empty() || fs::path(name).is_absolute())
      return {name, ""};
    const fs::path beside = (folder / name).lexically_normal();
    if (is_file(beside))
      return {beside.string(), is_file(name) && !have_same_contents(beside, name)
                                 ? "the file '" + name + "' in the working directory is another one than '" +
                                     beside.string() +
                                     "'. The one beside the parameter file is taken. To take the other, give its whole "
                                     "path, or name it by --set."
                                 : ""};
    if (!is_file(name))
      return {name, ""};
    return {name,
            "the file '" + name + "' is in the working directory, and not beside the parameter file, in '" +
              folder.string() +
              "'. Paths are meant from the parameter file: elsewhere this case is refused. Put the file there, or "
              "give its whole path."};
  }

  FoundFile find_from_here(const std::string &name, const fs::path &folder)
  {
    if (name.empty() || folder.empty() || fs::path(name).is_absolute() || is_file(name))
      return {name, ""};
    const fs::path beside = (folder / name).lexically_normal();
    return {is_file(beside) ? beside.string() : name, ""};
  }
} // namespace birdstrike
