#include "io/inputs/placed_copy.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/input_files.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Written aside and renamed: other processes see no half of it.
    void copy_whole(const fs::path &source, const fs::path &file)
    {
      const fs::path  aside = fmt::format("{}.{}.part", file.string(), ::getpid());
      std::error_code error;
      fs::copy_file(source, aside, fs::copy_options::overwrite_existing, error);
      if (!error)
        fs::rename(aside, file, error);
      if (!error)
        return;
      std::error_code none;
      fs::remove(aside, none);
      throw std::runtime_error("Cannot copy '" + source.string() + "' to '" + file.string() + "': " + error.message());
    }

    /// Whether a study, ladder or comparison has its runs in this folder: it is marked by ".birdstrike-NAME".
    bool is_of_several_runs(const fs::path &folder)
    {
      std::error_code error;
      return std::ranges::any_of(fs::directory_iterator(folder, error), [](const fs::directory_entry &entry) {
        return entry.path().filename().string().starts_with(".birdstrike-");
      });
    }

    /// Links to the copy that runs beside this one share, which nobody may write into. False where that cannot be.
    bool link_shared(const fs::path &source, const fs::path &file, const std::string &fingerprint)
    {
      const fs::path runs = file.parent_path().parent_path().parent_path(); // of runs/x/inputs/file
      if (!is_of_several_runs(runs))
        return false;
      const fs::path  shared = runs / "inputs" / (fingerprint + source.extension().string());
      std::error_code error;
      fs::create_directories(shared.parent_path(), error);
      if (!fs::exists(shared, error))
        {
          copy_whole(source, shared);
          fs::permissions(shared, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read, error);
        }
      fs::remove(file, error);
      fs::create_hard_link(shared, file, error);
      return !error;
    }
  } // namespace

  std::map<std::string, std::string> read_origins(const fs::path &folder)
  {
    std::map<std::string, std::string> origins;
    std::ifstream                      in(folder / origin_file);
    for (std::string line; std::getline(in, line);)
      if (const std::size_t first = line.find('\t'), second = line.find('\t', first + 1); second != std::string::npos)
        origins[line.substr(first + 1, second - first - 1)] = line.substr(second + 1);
    return origins;
  }

  std::string describe_origin(const std::string &fingerprint, const std::string &name, const std::string &origin)
  {
    return fingerprint + "\t" + name + "\t" + origin + "\n";
  }

  void place_copy(const fs::path &source, const fs::path &file, const std::string &fingerprint)
  {
    std::error_code error;
    if (!fs::equivalent(source, file, error) && !link_shared(source, file, fingerprint))
      copy_whole(source, file);
    if (fingerprint_of(file) != fingerprint)
      throw InputError("The file '" + source.string() +
                       "' has changed while the run was prepared.\n  Action: start the run again.");
  }
} // namespace birdstrike
