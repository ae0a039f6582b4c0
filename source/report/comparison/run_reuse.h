#pragma once

#include <birdstrike/io/run_folder.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;

  /// Where the run is, and of which others it is one.
  std::vector<std::string> entries_that_may_differ();

  /// Whether the run in a folder can stand for a run of these parameters by this program: it is complete, with its
  /// histories, neither a signal nor the clock ended it, this very build made it, its parameters.prm has the same value
  /// in every entry but Output/Directory and those of Study, and the files that entries name (meshes) have the same
  /// contents. Results do not depend on the machine's number of cores, so that is not asked.
  ///
  /// Empty if so, else why not, in words that follow "because".
  std::string reason_not_to_reuse(const std::filesystem::path &folder, const CaseParameters &wanted);

  /// Whether a run into this folder would lose what it cannot give back: a run of other entries or input files, or one
  /// that has come to its end by another build, or in other steps. Runs that stopped early or are damaged are not worth
  /// keeping beside the same run anew.
  ///
  /// Empty if nothing is lost, else why the folder's run is another one, in words that follow "because".
  std::string reason_to_keep(const std::filesystem::path &folder, const CaseParameters &wanted);

  /// Throws InputError where `why`, of the first folder and of `n` in all, is not empty.
  void refuse_loss_of_runs(const std::filesystem::path &folder, const std::string &why, std::size_t n);

  /// A run that can be taken for one's own, or why there is none.
  struct FoundRun
  {
    std::filesystem::path           folder;
    std::unique_ptr<RunFolderInUse> in_use;  ///< while this lives nobody changes it; none: no run was found
    std::string                     why_not; ///< of the first folder that holds another one; empty: there is none
  };

  /// Looks into the folders in this order.
  FoundRun find_run(const std::vector<std::filesystem::path> &folders, const CaseParameters &wanted);
} // namespace birdstrike
