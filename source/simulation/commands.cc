#include "simulation/bird_strike.h"
#include "simulation/explain.h"
#include "simulation/read_case.h"
#include "simulation/run_size.h"
#include "simulation/warnings/case_warnings.h"
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/entry_search.h>
#include <birdstrike/material/known_materials.h>
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
    std::cout << explain(parameters, scene).whole;
    const Warnings warnings = find_scene_warnings(parameters, scene);
    refuse_if_strict(warnings, request);
    show(warnings);
  }

  void validate_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    read_case(parameters, request);
    Scene scene(parameters);
    require_bounded_run(parameters, scene);
    explain(parameters, scene);
    const Warnings warnings = find_scene_warnings(parameters, scene);
    refuse_if_strict(warnings, request);
    show(warnings);
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

  void print_parameters(const ParametersRequest &request)
  {
    const CaseParameters parameters;
    if (request.word.empty())
      std::cout << (request.as_json ? parameters.file.as_json() : parameters.file.as_prm(true));
    else
      std::cout << describe_entries(parameters.file.tree(), request.word);
  }

  void print_materials()
  {
    std::cout << list_metals();
  }

  void print_liquids()
  {
    const CaseParameters parameters;
    std::cout << list_liquids(parameters.bird.density);
  }
} // namespace birdstrike
