#pragma once

#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/report_folder.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/report/compare.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// One case of a comparison: what it is called, what it is made of, and where its run is or will be.
  struct PlannedCase
  {
    std::string                     name; ///< of its column
    std::string                     prm_file;
    std::vector<std::string>        overrides;
    std::unique_ptr<CaseParameters> parameters;
    std::filesystem::path           folder;
    bool                            is_reused = false;
    std::unique_ptr<RunFolderInUse> in_use;  ///< from when its run is complete until the comparison is written
    std::string                     why_run; ///< where a run of the same name was found that cannot be reused
    std::optional<double>           goes_on_from = {}; ///< s, where a run of it that was stopped has a checkpoint
  };

  const ReportKind &comparison_kind();

  /// Reads every case, names it, refuses what cannot be compared (the same case twice, two cases of one name, a folder
  /// of another case) with an InputError, and looks for runs that can be reused. Runs nothing, writes nothing.
  std::vector<PlannedCase> plan_comparison(const CompareRequest &request);
} // namespace birdstrike
