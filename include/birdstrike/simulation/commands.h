#pragma once

#include <string>
#include <vector>

/// The verbs of the command line. Each throws InputError for what the user must change and NumericalFailure for a lost
/// computation; `main` turns these into exit codes.
namespace birdstrike
{
  /// What the command line says about one case.
  struct CaseRequest
  {
    std::string              prm_file;
    std::vector<std::string> overrides;         ///< "Section/Sub section/Entry=value"
    std::string              output;            ///< run folder instead of the one in the prm; empty: as in the prm
    bool                     is_forced = false; ///< a finished run in the folder may be replaced
  };

  /// What the command line says about a run that shall go on.
  struct ResumeRequest
  {
    std::string              run;       ///< its folder
    std::vector<std::string> overrides; ///< as of a case, of what may change
  };

  /// Goes on from the newest checkpoint that can be read, in the same folder: rows, fields and log continue as if the
  /// run had never stopped.
  void resume_run(const ResumeRequest &request);

  /// Runs the case to its end and leaves a run folder.
  void run_case(const CaseRequest &request);

  /// Prints what would be computed: mass, energy, momentum, particles, elements, first step and who limits it, expected
  /// steps, memory and bytes. Builds the parts, takes no step, writes nothing.
  void explain_case(const CaseRequest &request);

  /// Reads and checks the case, mesh and first touch included. Builds the parts, takes no step, writes nothing.
  void validate_case(const CaseRequest &request);

  /// Static equilibrium of the blade under the spin of its hub and the loads of t = 0, without the bird: a table on the
  /// screen, static.json and a field file in a folder (runs/static/FILE).
  void run_static(const CaseRequest &request);

  /// What the command line says about modes.
  struct ModesRequest
  {
    CaseRequest of_case;
    std::size_t n_modes = 10;
    std::string speeds; ///< of the hub, values as a study takes them: "0:6000 rpm:5"; empty: that of the case
  };

  /// Natural frequencies and shapes about static equilibrium, at one speed or several: modes.csv, a field file with the
  /// shapes for each speed, and of several speeds the Campbell diagram, in a folder (runs/modes/FILE).
  void run_modes(const ModesRequest &request);

  /// Expected run time of a case on one core (s), as explain_case prints it.
  double forecast_run_time(const std::string &prm_file, const std::vector<std::string> &overrides);

  /// Prints what every column of a case's histories is; without a file, of any case's.
  void print_columns(const CaseRequest &request);

  /// Prints every parameter with text, range, default and unit, as prm or as JSON.
  void print_parameters(bool as_json);
} // namespace birdstrike
