#include "simulation/bird_strike.h"
#include "simulation/case_warnings.h"
#include "simulation/explain.h"
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/report/columns.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>
#include <birdstrike/simulation/commands.h>

#include <spdlog/logger.h>

#include <csignal>
#include <iostream>

namespace birdstrike
{
  namespace
  {
    void show(const Warnings &warnings)
    {
      for (const Warning &warning : warnings)
        log().warn("Warning: {}", warning.text);
    }

    /// Reads and checks a case; the command line's folder wins over the file's. Warnings of the entries are shown at
    /// once, for what is built of a wrong unit may take long, and returned.
    Warnings read(CaseParameters &parameters, const CaseRequest &request)
    {
      std::vector<std::string> overrides = request.overrides;
      if (!request.output.empty())
        overrides.push_back("Output/Directory=" + request.output);
      parameters.read(request.prm_file, overrides);
      Warnings warnings = find_input_warnings(parameters);
      show(warnings);
      return warnings;
    }

    void stop_on_signal(int)
    {
      BirdStrike::request_stop();
    }
  } // namespace

  void run_case(const CaseRequest &request)
  {
    CaseParameters    parameters;
    Warnings          warnings = read(parameters, request);
    const auto        inputs   = list_input_files(parameters);
    Scene             scene(parameters); // refuses a bad case before a folder is touched
    const std::string forecast = explain(parameters, scene);

    // From the moment that there is a folder on, a run that is stopped ends in order.
    BirdStrike::forget_stop_requests();
    std::signal(SIGINT, stop_on_signal);
    std::signal(SIGTERM, stop_on_signal);
    RunFolder folder(parameters.run_directory());
    log_to_file(folder.file("log.txt").string());
    folder.write_text("original.prm", parameters.file.original());
    folder.write_text("parameters.prm", parameters.file.as_prm());
    log().info("{}", forecast);
    const Warnings of_scene = find_scene_warnings(parameters, scene);
    show(of_scene);
    warnings.insert(warnings.end(), of_scene.begin(), of_scene.end());
    bool is_interrupted = false;
    try
      {
        BirdStrike strike(parameters, scene, folder.path(), warnings);
        strike.run();
        log().info("{}", strike.closing_report());
        Summary summary = strike.compute_summary();
        summary.set_inputs(inputs);
        show(summary.warnings()); // those of the beginning once more: they are far up by now
        folder.finish(to_text(summary));
        is_interrupted = strike.is_interrupted();
        log().info("Results in {}", folder.path().string());
      }
    catch (const std::exception &error)
      {
        folder.fail(error.what());
        throw;
      }
    if (is_interrupted)
      throw Interrupted(
        "Interrupted by a signal before Time/End time; what stands in the folder goes as far as it came.");
  }

  void explain_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    read(parameters, request);
    Scene scene(parameters);
    std::cout << explain(parameters, scene);
    show(find_scene_warnings(parameters, scene));
  }

  void validate_case(const CaseRequest &request)
  {
    CaseParameters parameters;
    read(parameters, request);
    Scene scene(parameters);
    explain(parameters, scene);
    show(find_scene_warnings(parameters, scene));
    std::cout << request.prm_file << ": valid\n";
  }

  void print_columns(const CaseRequest &request)
  {
    if (request.prm_file.empty())
      {
        std::cout << describe_columns(nullptr);
        return;
      }
    CaseParameters parameters;
    read(parameters, request);
    Scene      scene(parameters);
    BirdStrike strike(parameters, scene);
    std::cout << strike.describe_columns();
  }

  void print_parameters(const bool as_json)
  {
    const CaseParameters parameters;
    std::cout << (as_json ? parameters.file.as_json() : parameters.file.as_prm());
  }
} // namespace birdstrike
