#pragma once

#include <filesystem>
#include <string>

namespace birdstrike
{
  struct CaseParameters;

  /// Whether the run in a folder can stand for a run of these parameters by this program: it is complete, with its
  /// histories, neither a signal nor the clock ended it, this very build made it, its parameters.prm has the same value
  /// in every entry but Output/Directory, and the files that entries name (meshes) have the same contents. Results do
  /// not depend on the machine's number of cores, so that is not asked.
  ///
  /// Empty if so, else why not, in words that follow "because".
  std::string reason_not_to_reuse(const std::filesystem::path &folder, const CaseParameters &wanted);
} // namespace birdstrike
