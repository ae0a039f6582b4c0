#include "file_commands.h"
#include "command_line.h"

#include <CLI/CLI.hpp>

namespace birdstrike
{
  namespace
  {
    void declare_lists(CLI::App &app, Requests &requests, std::function<void()> &action)
    {
      CLI::App *parameters = app.add_subcommand("parameters", "Entries with text, range, default and unit");
      auto     *word =
        parameters->add_option("WORD", requests.of_parameters.word,
                               "Only a section, an entry or those with this word: Bird, Bird/Speed, hourglass");
      parameters->add_flag("--json", requests.of_parameters.as_json, "All of them as JSON instead of prm")
        ->excludes(word);
      parameters->callback([&] { action = [&] { print_parameters(requests.of_parameters); }; });
      app.add_subcommand("materials", "Metals that are known by name: constants and sources")->callback([&] {
        action = print_materials;
      });
      app.add_subcommand("liquids", "Liquids of the bird: laws and constants")->callback([&] {
        action = print_liquids;
      });
    }

    void declare_new(CLI::App &app, NewCaseRequest &request, std::function<void()> &action)
    {
      CLI::App *command = app.add_subcommand("new", "Write a commented parameter file to begin with");
      command->add_option("FILE", request.file, "Parameter file that is written")->required();
      command->add_option("--blade", request.blade, "shell or solid");
      command->add_option("--mesh", request.mesh, "Mesh file of the blade; without it a flat plate");
      command->add_option("--spin", request.spin, "Speed of the hub, with its unit: \"4000 rpm\"");
      command->add_flag("--force", request.is_forced, "Replace the file");
      command->callback([&] { action = [&] { write_new_case(request); }; });
    }
  } // namespace

  void declare_file_commands(CLI::App &app, Requests &requests, std::function<void()> &action)
  {
    declare_lists(app, requests, action);
    declare_new(app, requests.of_new_case, action);
  }
} // namespace birdstrike
