#pragma once

#include <optional>
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
    std::vector<std::string> overrides;          ///< "Section/Sub section/Entry=value"
    std::string              output;             ///< run folder instead of the one in the prm; empty: as in the prm
    bool                     is_forced  = false; ///< a finished run in the folder may be replaced
    bool                     is_verbose = false; ///< the screen shows what log.txt keeps
    bool is_strict = false; ///< warnings of units, of entries without effect and of misses are errors
  };

  /// What the command line says about a run that shall go on.
  struct ResumeRequest
  {
    std::string              run;                ///< its folder
    std::vector<std::string> overrides;          ///< as of a case, of what may change
    bool                     is_verbose = false; ///< as of a case
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

  /// What the command line says about the list of entries.
  struct ParametersRequest
  {
    std::string word;            ///< a section, an entry or a word; empty: all
    bool        as_json = false; ///< all of them
  };

  /// Prints entries with text, range, default and unit: all as prm or JSON, those of a word as a list.
  void print_parameters(const ParametersRequest &request);

  /// What the command line says about a new parameter file; what is not given is asked for if somebody types.
  struct NewCaseRequest
  {
    std::string                file;
    std::optional<std::string> blade;             ///< shell or solid
    std::optional<std::string> mesh;              ///< a file; empty: a flat plate
    std::optional<std::string> spin;              ///< of the hub, with its unit; 0: at rest
    bool                       is_forced = false; ///< an existing file may be replaced
  };

  /// Writes a commented parameter file that runs as it is, and says what to do next. Throws InputError for a file that
  /// exists, a kind of blade that there is none, and a mesh that cannot be read.
  void write_new_case(const NewCaseRequest &request);

  /// Prints the metals that Material/Name knows, with their constants and sources.
  void print_materials();

  /// Prints the liquids of Equation of state/Type at their default constants, with what they do in a strike.
  void print_liquids();
} // namespace birdstrike
