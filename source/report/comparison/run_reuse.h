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
