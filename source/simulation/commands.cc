#include "simulation/bird_strike.h"
#include "simulation/explain.h"
#include "simulation/read_case.h"
#include "simulation/run_size.h"
#include "simulation/warnings/case_warnings.h"
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/columns.h>
#include <birdstrike/report/text.h>
#include <birdstrike/simulation/commands.h>

#include <spdlog/logger.h>

#include <iostream>

namespace birdstrike
{
  void explain_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    read_case(parameters, request);
    Scene scene(parameters);
    require_bounded_run(parameters, scene);
    std::cout << explain(parameters, scene);
    show(find_scene_warnings(parameters, scene));
  }

  void validate_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    read_case(parameters, request);
    Scene scene(parameters);
    require_bounded_run(parameters, scene);
    explain(parameters, scene);
    show(find_scene_warnings(parameters, scene));
    std::cout << request.prm_file << ": valid\n";
  }

  double forecast_run_time(const std::string &prm_file, const std::vector<std::string> &overrides)
  {
    CaseParameters parameters;
    parameters.read(prm_file, overrides);
    const Scene scene(parameters);
    return compute_run_time(parameters, scene);
  }

  void print_columns(const CaseRequest &request)
  {
    if (request.prm_file.empty())
      {
        std::cout << describe_columns(nullptr);
        return;
      }
    CaseParameters parameters;
    read_case(parameters, request);
    Scene      scene(parameters);
    BirdStrike strike(parameters, scene);
    std::cout << strike.describe_columns();
  }

  void print_parameters(const bool as_json)
  {
    const CaseParameters parameters;
    std::cout << (as_json ? parameters.file.as_json() : parameters.file.as_prm(true));
  }
} // namespace birdstrike
