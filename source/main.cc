#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/simulation/commands.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>

namespace
{
  using birdstrike::CaseRequest;
  using birdstrike::ExitCode;

  /// The command line: every subcommand binds what it will do to `action`.
  void declare_commands(CLI::App &app, CaseRequest &request, bool &as_json, std::function<void()> &action)
  {
    app.set_version_flag("--version", "birdstrike " BIRDSTRIKE_VERSION);
    app.require_subcommand(1);

    const auto case_command = [&](const char *name, const char *text, void (*verb)(const CaseRequest &)) {
      CLI::App *command = app.add_subcommand(name, text);
      command->add_option("FILE", request.prm_file, "Parameter file")->required();
      command->add_option("--set", request.overrides, "Override an entry: \"Section/Entry=value\" (repeatable)")
        ->allow_extra_args(false);
      command->add_option("--output", request.output, "Run folder, instead of the one in the parameter file");
      command->callback([&, verb] { action = [&, verb] { verb(request); }; });
    };
    case_command("run", "Run a case to its end", birdstrike::run_case);
    case_command("explain", "Say what would be computed, before it is", birdstrike::explain_case);
    case_command("validate", "Read and check a case, compute nothing", birdstrike::validate_case);

    CLI::App *parameters = app.add_subcommand("parameters", "All entries with text, range, default and unit");
    parameters->add_flag("--json", as_json, "As JSON instead of prm");
    parameters->callback([&] { action = [&] { birdstrike::print_parameters(as_json); }; });
  }

  /// Whether one of the usual launchers (Open MPI, MPICH and Intel MPI, PMIx, Slurm) says that this process may be one
  /// of several. One that was started by itself needs no MPI: its start and end cost 0.3 s, as much as loading the
  /// program.
  bool is_started_by_launcher()
  {
    for (const char *variable : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK", "SLURM_PROCID"})
      if (std::getenv(variable))
        return true;
    return false;
  }

  int exit_code(const ExitCode code)
  {
    return static_cast<int>(code);
  }

  /// Runs the chosen action; every way to fail ends here, with its exit code and without a stack trace.
  int run_guarded(const std::function<void()> &action)
  {
    try
      {
        if (dealii::Utilities::MPI::job_supports_mpi() && dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
          throw birdstrike::InputError("birdstrike runs on one MPI rank for now; it was started on " +
                                       std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
                                       ".\nStart it without mpirun; threads are set by Time/Threads.");
        action();
        return exit_code(ExitCode::done);
      }
    catch (const birdstrike::InputError &error)
      {
        birdstrike::log().error("{}", error.what());
        return exit_code(ExitCode::bad_input);
      }
    catch (const birdstrike::NumericalFailure &error)
      {
        birdstrike::log().error("{}", error.what());
        return exit_code(ExitCode::numerical_failure);
      }
    catch (const std::exception &error)
      {
        birdstrike::log().error("Internal error: {}", error.what());
        return exit_code(ExitCode::internal_error);
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  CLI::App              app{"Bird strike on aircraft-engine blades", "birdstrike"};
  CaseRequest           request;
  bool                  as_json = false;
  std::function<void()> action;
  declare_commands(app, request, as_json, action);
  try
    {
      app.parse(argc, argv);
    }
  catch (const CLI::ParseError &error)
    {
      const bool is_asked = app.exit(error) == 0; // --help and --version
      return exit_code(is_asked ? ExitCode::done : ExitCode::bad_input);
    }
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  if (!is_started_by_launcher())
    dealii::MultithreadInfo::set_thread_limit(1);
  else if (mpi.emplace(argc, argv, 1u); dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    birdstrike::set_console_level("off"); // one rank speaks for all
  return run_guarded(action);
}
