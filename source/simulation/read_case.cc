#include "simulation/read_case.h"
#include "simulation/warnings/case_warnings.h"
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>

#include <spdlog/logger.h>

namespace birdstrike
{
  void show(const Warnings &warnings)
  {
    for (const Warning &warning : warnings)
      log().warn("Warning: {}", warning.text);
  }

  std::string set_directory(const std::string &directory)
  {
    const std::string its_own = "default"; // which gives an entry its own value back
    return "Output/Directory=" + (directory == its_own ? "./" + directory : directory);
  }

  Warnings read_case(CaseParameters &parameters, const CaseRequest &request)
  {
    std::vector<std::string> overrides = request.overrides;
    if (!request.output.empty())
      overrides.push_back(set_directory(request.output));
    parameters.read(request.prm_file, overrides);
    Warnings warnings = find_input_warnings(parameters);
    show(warnings);
    return warnings;
  }

  std::string read_blade(CaseParameters &parameters, const CaseRequest &request)
  {
    std::string why_unknown = parameters.read_blade(request.prm_file, request.overrides);
    show(find_input_warnings(parameters));
    return why_unknown;
  }
} // namespace birdstrike
