#pragma once

#include <birdstrike/report/compare.h>
#include <birdstrike/report/converge.h>
#include <birdstrike/report/measurement.h>
#include <birdstrike/report/study.h>
#include <birdstrike/simulation/commands.h>

#include <cstddef>
#include <functional>
#include <string>

namespace CLI
{
  class App;
}

namespace birdstrike
{
  /// What the command line may ask for.
  struct Requests
  {
    CaseRequest        of_case;
    CompareRequest     of_comparison;
    ResumeRequest      of_resumption;
    StudyRequest       of_study;
    ConvergeRequest    of_ladder;
    MeasurementRequest of_measurement;
    ModesRequest       of_modes;
    ParametersRequest  of_parameters;
    NewCaseRequest     of_new_case;
    std::string        target_error; ///< of run
    std::string        bird_order;   ///< beside it
    std::size_t        n_places = 1; ///< beside it
  };

  /// Declares every command with its options, which are read into `requests`; the command that is given binds what it
  /// will do to `action`. All three must live until that is done.
  void declare_commands(CLI::App &app, Requests &requests, std::function<void()> &action);
} // namespace birdstrike
