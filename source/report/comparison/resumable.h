#pragma once

#include <filesystem>
#include <optional>

namespace birdstrike
{
  struct CaseParameters;

  /// Where a run that has not come to its end can be gone on with by 'resume': the time (s) of its newest checkpoint.
  /// None without a checkpoint of this very build and these entries (but Output/Directory and those of Study), or where
  /// the run was lost, which it would be again. Whether `resume` takes it, input files and all, it says itself.
  std::optional<double> find_resumable_time(const std::filesystem::path &folder, const CaseParameters &wanted);
} // namespace birdstrike
