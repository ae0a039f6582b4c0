#include "simulation/read_case.h"
#include "simulation/warnings/case_warnings.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace birdstrike
{
  namespace
  {
    bool is_error_if_strict(const Warning &warning)
    {
      constexpr std::array<std::string_view, 7> beginnings{
        {"unit/", "material/", "entry/", "case/", "bird/misses_in_part", "bird/late", "blade/thickness_not_given"}};
      return std::ranges::any_of(beginnings,
                                 [&](const std::string_view begin) { return warning.code.starts_with(begin); });
    }
  } // namespace

  void show(const Warnings &warnings)
  {
    for (const Warning &warning : warnings)
      log().warn("Warning: {} [{}]", warning.text, warning.code);
  }

  void refuse_if_strict(const Warnings &warnings, const CaseRequest &request)
  {
    Warnings                 refused;
    std::vector<std::string> codes;
    for (const Warning &warning : warnings)
      if (request.is_strict && is_error_if_strict(warning))
        {
          refused.push_back(warning);
          codes.push_back(warning.code);
        }
    if (refused.empty())
      return;
    show(refused);
    throw InputError(fmt::format("With --strict these warnings are errors: {}.\nCorrect the entries that they name, or "
                                 "leave --strict out.",
                                 fmt::join(codes, ", ")));
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
    refuse_if_strict(warnings, request);
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
