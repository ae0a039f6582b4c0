#include "command_line.h"
#include "file_commands.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/option_number.h>
#include <birdstrike/report/target_error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <vector>

namespace birdstrike
{
  namespace
  {
    CLI::Option *declare_overrides(CLI::App *command, std::vector<std::string> &overrides)
    {
      return command->add_option("--set", overrides, "Override an entry: \"Section/Entry=value\" (repeatable)")
        ->allow_extra_args(false);
    }

    /// An option whose word `read` turns into a number; what it refuses is an error of the command line.
    template <class Number, class Read>
    CLI::Option *declare_number(CLI::App *command, const std::string &name, Number &number, const std::string &text,
                                const Read &read)
    {
      const auto take = [name, &number, read](const std::string &word) {
        try
          {
            number = read(name, word);
          }
        catch (const InputError &error)
          {
            throw CLI::ValidationError(error.what());
          }
      };
      CLI::Option *option = command->add_option_function<std::string>(name, take, text)->type_name("NUMBER");
      return number == Number() ? option : option->default_str(fmt::format("{}", number));
    }

    CLI::Option *declare_count(CLI::App *command, const std::string &name, std::size_t &count, const std::string &text,
                               const int smallest, const int largest)
    {
      return declare_number(command, name, count, text, [=](const std::string &option, const std::string &word) {
        return read_option_count(option, word, smallest, largest);
      });
    }

    void declare_jobs(CLI::App *command, std::size_t &n_jobs, const std::string &what)
    {
      declare_count(command, "--jobs", n_jobs, what + " side by side, instead of one a core", 1, int(most_children));
    }

    void declare_verbose(CLI::App *command, bool &is_verbose)
    {
      command->add_flag("--verbose", is_verbose, "Show on the screen all that log.txt keeps");
    }

    /// Of reports on several runs, which protect what is there as 'run' does.
    CLI::Option *declare_force(CLI::App *command, bool &is_forced, const std::string &same)
    {
      return command->add_flag("--force", is_forced,
                               "Replace finished runs of other entries in the folder, and its tables. Without it " +
                                 same + " is taken, anything else is refused");
    }
    /// The number of places of a lattice, and of levels and modes: far beyond what anybody computes.
    constexpr int most = 1000;

    void declare_study(CLI::App &app, StudyRequest &request, std::function<void()> &action)
    {
      CLI::App *study = app.add_subcommand("study", "Run a case for each point of a grid of values, side by side");
      study->add_option("FILE", request.prm_file, "Parameter file")->required();
      study
        ->add_option(
          "--vary", request.vary,
          "An entry and its values: \"Section/Entry=v1, v2\" or \"Section/Entry=a:b:n\" or \"Section/Entry=v1 | "
          "v2\" (repeatable: each with each); else section Study of the file")
        ->allow_extra_args(false);
      study->add_flag("--pairs", request.are_pairs, "Values go together one by one instead of each with each");
      declare_overrides(study, request.overrides);
      study->add_option("--output", request.output,
                        "Folder of the study, instead of runs/study/FILE; one folder holds one table");
      declare_force(study, request.is_forced, "the same study again, or with more values,");
      declare_jobs(study, request.n_jobs, "Points");
      study->add_option("--launcher", request.launcher, "Words before each run's command: \"srun -n 1\"");
      study->add_option("--task-list", request.task_list,
                        "Write a command line for each point that is to run into this file, and run none");
      study->add_flag("--collect", request.only_collects, "Run nothing: make the table of what is there");
      study->callback([&] { action = [&] { run_study(request); }; });
    }

    void declare_converge(CLI::App &app, ConvergeRequest &request, std::function<void()> &action)
    {
      CLI::App *ladder = app.add_subcommand("converge", "Run a case on a ladder of refinements: orders and error bars");
      ladder->add_option("FILE", request.prm_file, "Parameter file: the finest level")->required();
      declare_count(ladder, "--levels", request.n_levels, "Number of levels, 3 to 12", 0, most);
      ladder
        ->add_option(
          "--vary", request.refinement,
          "What is refined: mesh, particles, both, step (finer than the case), points (through the thickness)")
        ->capture_default_str();
      declare_number(ladder, "--ratio", request.ratio, "Of sizes from level to level", read_option_number);
      declare_count(ladder, "--finer", request.n_finer, "So many of the levels are finer than the case", 0, most);
      ladder->add_option(
        "--order", request.order,
        "Of the method, if it is known, 1, or its bounds, 1:2: the value at h = 0 by it, with its 95 % interval");
      declare_count(ladder, "--places", request.n_places,
                    "Runs a level, each with the bird's lattice elsewhere across its axis (Lattice shift): values are "
                    "their means, and the scatter of one run is told",
                    0, most);
      declare_jobs(ladder, request.n_jobs, "Levels");
      declare_overrides(ladder, request.overrides);
      ladder->add_option("--output", request.output,
                         "Folder of the ladder, instead of runs/converge/FILE; one folder holds one table");
      declare_force(ladder, request.is_forced, "the same ladder again, or with more levels,");
      ladder->callback([&] { action = [&] { converge(request); }; });
    }

    void declare_modes(CLI::App &app, ModesRequest &request, std::function<void()> &action)
    {
      CLI::App *modes = app.add_subcommand("modes", "Natural frequencies and shapes of the blade, at rest or turning");
      modes->add_option("FILE", request.of_case.prm_file, "Parameter file")->required();
      declare_count(modes, "--number", request.n_modes, "How many, from the lowest on", 1, 1000);
      modes->add_option(
        "--speeds", request.speeds,
        "Speeds of the hub, as study takes values: \"0:900:4\" (rad/s), \"0, 3000 rpm, 6000 rpm\"; with "
        "several a Campbell diagram");
      declare_overrides(modes, request.of_case.overrides);
      modes->add_option("--output", request.of_case.output, "Folder, instead of runs/modes/FILE");
      modes->callback([&] { action = [&] { run_modes(request); }; });
    }

    /// Of runs that are there, to which nothing can be set.
    CLI::Option *declare_measurement(CLI::App *compare, MeasurementRequest &request)
    {
      auto *measured = compare
                         ->add_option("--measured", request.of_file,
                                      "A table (CSV) that was measured and pairs \"column: quantity\"; FILE are then "
                                      "folders of runs, which are rated against it")
                         ->type_name("TABLE \"COLUMN: QUANTITY\" ...");
      compare
        ->add_option("--time-column", request.time_column,
                     "The table's column of times, if not 'time', 't' or the first")
        ->needs(measured);
      compare->add_option("--time-offset", request.time_offset, "Added to the table's times: \"0.35 ms\"")
        ->needs(measured);
      return measured;
    }

    /// A variable of the shell that is not set makes an empty word, which would stand for a default or a zero.
    void refuse_empty_words(CLI::App &app)
    {
      const CLI::Validator is_a_word(
        [](const std::string &word) { return word.empty() ? std::string("the word is empty") : std::string(); }, "");
      for (CLI::App *command : app.get_subcommands({}))
        for (CLI::Option *option : command->get_options())
          if (option->get_items_expected_max() > 0)
            option->check(is_a_word);
    }

    /// The case as it is, or as fine as a target asks for.
    void run(const Requests &requests)
    {
      const CaseRequest &request = requests.of_case;
      if (requests.target_error.empty())
        run_case(request);
      else
        run_to_target_error({requests.target_error, request.prm_file, request.overrides, request.output,
                             requests.bird_order, requests.n_places, request.is_forced},
                            forecast_run_time);
    }

    /// What run has beyond the other commands of a case.
    void declare_run(CLI::App &command, Requests &requests, std::function<void()> &action)
    {
      command.callback([&] { action = [&] { run(requests); }; });
      declare_verbose(&command, requests.of_case.is_verbose);
      command.add_flag("--force", requests.of_case.is_forced,
                       "Replace a finished run in the folder, with --target-error the table of another "
                       "quantity");
      CLI::Option *target = command.add_option(
        "--target-error", requests.target_error,
        "Instead of the case as it is: the cheapest bird and mesh with this error, \"tip peak = 2 %\" "
        "(folder: runs/target/FILE)");
      command
        .add_option(
          "--bird-order", requests.bird_order,
          "Of the ladder of its particles, if it is known, 1, or its bounds, 1:2: values are taken to h = 0 by it")
        ->needs(target);
      declare_count(&command, "--places", requests.n_places,
                    "Runs per level, each with the bird's lattice of particles shifted across its axis (Bird/Lattice "
                    "shift): values are their means",
                    0, most)
        ->needs(target);
    }
  } // namespace

  void declare_commands(CLI::App &app, Requests &requests, std::function<void()> &action)
  {
    app.set_version_flag("--version", describe_program());
    app.require_subcommand(1);
    app.footer("Exit codes: 0 done, 1 internal or system error (full disk), 2 bad input, 3 the computation was lost or "
               "a target error cannot be claimed, 130 interrupted");

    const auto case_command = [&](const char *name, const char *text, void (*verb)(const CaseRequest &)) {
      CLI::App    *command = app.add_subcommand(name, text);
      CaseRequest &request = requests.of_case;
      command->add_option("FILE", request.prm_file, "Parameter file")->required();
      declare_overrides(command, request.overrides);
      command->add_option("--output", request.output,
                          "Folder of the results, instead of the one in the parameter file");
      command->callback([&, verb] { action = [&, verb] { verb(requests.of_case); }; });
    };
    case_command("run", "Run a case to its end", run_case);
    declare_run(*app.get_subcommand("run"), requests, action);
    case_command("explain", "Say what would be computed, before it is", explain_case);
    case_command("validate", "Read and check a case, compute nothing", validate_case);
    for (const char *name : {"run", "explain", "validate"})
      app.get_subcommand(name)->add_flag("--strict", requests.of_case.is_strict,
                                         "Warnings of units, of entries without effect and of misses are errors");

    case_command("static", "Static equilibrium of the blade under spin and steady loads", run_static);
    declare_modes(app, requests.of_modes, action);

    CLI::App *resume = app.add_subcommand("resume", "Go on with a run from its newest checkpoint");
    resume->add_option("RUN", requests.of_resumption.run, "Run folder")->required();
    declare_overrides(resume, requests.of_resumption.overrides);
    declare_verbose(resume, requests.of_resumption.is_verbose);
    resume->callback([&] { action = [&] { resume_run(requests.of_resumption); }; });

    CLI::App       *compare = app.add_subcommand("compare", "Run cases, or take their runs, and set them side by side");
    CompareRequest &request = requests.of_comparison;
    compare->add_option("FILE", request.prm_files, "Parameter files or run folders; differences are to the first")
      ->required();
    auto *blades =
      compare
        ->add_option(
          "--blade", request.blade_kinds,
          "Each file once for each of these values of Blade/Kind, e.g. shell,solid; rigid: the same surface without "
          "elements")
        ->delimiter(',')
        ->allow_extra_args(false);
    declare_measurement(compare, requests.of_measurement)
      ->excludes(blades)
      ->excludes(declare_overrides(compare, request.overrides))
      ->excludes(declare_force(compare, request.is_forced, "the same comparison again, or with more cases,"));
    compare->add_option("--output", request.output, "Folder of the comparison; one folder holds one table")
      ->capture_default_str();
    compare->callback([&requests, &action, compare] {
      if (requests.of_measurement.of_file.empty())
        action = [&] { compare_cases(requests.of_comparison); };
      else
        action = [&requests, is_put = compare->count("--output") > 0] {
          requests.of_measurement.runs = requests.of_comparison.prm_files;
          if (is_put)
            requests.of_measurement.output = requests.of_comparison.output;
          compare_with_measurement(requests.of_measurement);
        };
    });

    declare_study(app, requests.of_study, action);
    declare_converge(app, requests.of_ladder, action);

    CLI::App *columns = app.add_subcommand("columns", "What every column of the histories is: unit, frame, sign");
    columns->add_option("FILE", requests.of_case.prm_file, "Parameter file: the columns of this case alone");
    declare_overrides(columns, requests.of_case.overrides);
    columns->callback([&] { action = [&] { print_columns(requests.of_case); }; });

    declare_file_commands(app, requests, action);
    refuse_empty_words(app);
  }
} // namespace birdstrike
