#include "command_line.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/program.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <spdlog/logger.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace
{
  using birdstrike::ExitCode;

  int exit_code(const ExitCode code)
  {
    return static_cast<int>(code);
  }

  void end_as_interrupted(int)
  {
    constexpr std::string_view  words     = "Interrupted by a signal.\n";
    [[maybe_unused]] const auto n_written = ::write(STDERR_FILENO, words.data(), words.size()); // safe in a handler
    ::_exit(birdstrike::Interrupted::exit_code);
  }

  /// Of every command, until a run or the parent of runs listens itself; what is ignored (nohup) stays ignored.
  void end_on_signals()
  {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
      if (std::signal(signal, end_as_interrupted) == SIG_IGN)
        std::signal(signal, SIG_IGN);
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
    catch (const birdstrike::Interrupted &error)
      {
        birdstrike::log().warn("{}", error.what());
        return birdstrike::Interrupted::exit_code;
      }
    catch (const std::runtime_error &error) // a disk that is full, a file that cannot be read: says so itself
      {
        birdstrike::log().error("{}", error.what());
        return exit_code(ExitCode::internal_error);
      }
    catch (const std::exception &error)
      {
        birdstrike::log().error("Internal error: {}", error.what());
        return exit_code(ExitCode::internal_error);
      }
  }

  /// The whole program, of which a comparison or a study makes one more for each of its runs.
  int run_program(int argc, char **argv)
  {
    end_on_signals();
    ::prctl(PR_SET_NAME, "birdstrike"); // for ps and pkill: the runs of a comparison are started by another name
    CLI::App              app{"Bird strike on aircraft-engine blades", "birdstrike"};
    birdstrike::Requests  requests;
    std::function<void()> action;
    birdstrike::declare_commands(app, requests, action);
    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::ParseError &error)
      {
        const std::string word     = argc > 1 ? argv[1] : "-";
        const auto        commands = app.get_subcommands({});
        if (!word.starts_with('-') && std::ranges::find(commands, word, &CLI::App::get_name) == commands.end())
          {
            std::cerr << "Unknown command '" << word << "'. Commands:";
            for (const CLI::App *each : commands)
              std::cerr << (each == commands.front() ? " " : ", ") << each->get_name();
            std::cerr << ".\nbirdstrike --help describes them.\n";
            return exit_code(ExitCode::bad_input);
          }
        const bool is_asked = app.exit(error) == 0; // --help and --version
        return exit_code(is_asked ? ExitCode::done : ExitCode::bad_input);
      }
    std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    if (!birdstrike::is_started_by_launcher())
      dealii::MultithreadInfo::set_thread_limit(1);
    else if (mpi.emplace(argc, argv, 1u); dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      birdstrike::set_console_level("off"); // one rank speaks for all
    const int  code     = run_guarded(action);
    const auto is_given = [&](const char *name) { return app.got_subcommand(name); };
    if (const std::array for_the_screen{"explain", "validate", "columns", "parameters", "materials", "liquids"};
        std::ranges::none_of(for_the_screen, is_given) || code != 0 ||
        (std::fflush(stdout) == 0 && std::ferror(stdout) == 0))
      return code;
    std::fputs("Cannot write to standard output: is the disk full?\n", stderr);
    return exit_code(ExitCode::internal_error);
  }
} // namespace

int main(int argc, char *argv[])
{
  while (true) // a closed screen's descriptor would go to the next file that is opened, and words into it
    if (const int descriptor = ::open("/dev/null", O_RDWR); descriptor > STDERR_FILENO || descriptor < 0)
      {
        ::close(descriptor);
        break;
      }
  birdstrike::begin_children_at(run_program);
  return run_program(argc, argv);
}
