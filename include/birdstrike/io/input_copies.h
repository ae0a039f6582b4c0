#pragma once

#include <birdstrike/io/input_files.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;

  /// What makes a run folder stand by itself: copies of all files that the case reads, in its folder `inputs`, and
  /// parameter files that name these copies. Paths in them are relative, so that the folder may be moved.
  ///
  /// Two files of one name get two names, "blade.msh" and "blade-2.msh". Meshes and tables are copied byte by byte;
  /// included parameter files with other paths in the lines that name files. `inputs/origin.txt` tells where each came
  /// from. Runs below one study or comparison share one copy by hard links, where the file system has them, in the
  /// folder `inputs` of the study. With Output/Copy inputs = false nothing is copied, and paths are absolute.
  class InputCopies
  {
  public:
    /// Plans names and takes fingerprints; writes nothing. `parameters` must outlive this.
    explicit InputCopies(const CaseParameters &parameters);

    /// Copies, and removes what an earlier run has left there. Throws InputError for a file that has changed meanwhile
    /// or does not fit on the disk, std::runtime_error where the disk refuses.
    void write(const std::filesystem::path &run_folder) const;

    std::string original() const;   ///< what was typed, with the copies' paths: original.prm
    std::string parameters() const; ///< every entry at its present value: parameters.prm

    /// As list_input_files, with their copies.
    const std::vector<InputFile> &inputs() const
    {
      return all_inputs;
    }

  private:
    struct Copy
    {
      std::filesystem::path source;
      std::string           name;        ///< in the folder `inputs`
      std::string           fingerprint; ///< empty: an included parameter file
      std::size_t           of_scan = 0; ///< of those, its place among the files that were read
    };

    void                  add(const std::filesystem::path &source, const std::string &fingerprint, std::size_t of_scan);
    const Copy           *find(const std::filesystem::path &source) const;
    std::string           path_of(const std::filesystem::path &source, const std::string &prefix) const;
    std::string           rewritten(std::size_t of_scan, const std::string &prefix) const;
    void                  require_room(const std::filesystem::path &run_folder) const;
    const CaseParameters &of_case;
    std::map<std::string, std::string> names; ///< lower case, that are taken
    std::vector<Copy>                  copies;
    std::vector<InputFile>             all_inputs;
  };

  /// parameters.prm of a run that goes on: files of its folder by relative paths, all others by absolute ones.
  std::string parameters_seen_from(const std::filesystem::path &run_folder, const CaseParameters &parameters);

  /// Fills in the copies that the case reads from the run folder.
  void find_copies(std::vector<InputFile> &inputs, const std::filesystem::path &run_folder,
                   const CaseParameters &parameters);
} // namespace birdstrike
