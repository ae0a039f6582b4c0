#include <birdstrike/io/case_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

namespace birdstrike
{
  namespace
  {
    ParameterGroup describe_case(std::string &name, std::string &description)
    {
      const auto declare = [&](dealii::ParameterHandler &prm) {
        prm.enter_subsection("Case");
        prm.add_parameter("Name", name, "Name of the case; empty stands for the file's name without its ending. [-]");
        prm.add_parameter("Description", description, "One sentence that says what is computed. [-]");
        prm.leave_subsection();
      };
      return {declare, [] {}};
    }
  } // namespace

  CaseParameters::CaseParameters()
    : file({describe_case(name, description), ParameterGroup::of(blade, "Blade"), ParameterGroup::of(bird),
            ParameterGroup::of(equation_of_state, "Bird"), ParameterGroup::of(contact), ParameterGroup::of(time),
            ParameterGroup::of(output)})
  {
  }

  void CaseParameters::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    file.read(path, overrides);
    if (name.empty())
      file.set("Case/Name=" + std::filesystem::path(path).stem().string()); // so that the printed file knows it too
  }

  std::string CaseParameters::run_directory() const
  {
    return output.directory.empty() ? "runs/" + name : output.directory;
  }
} // namespace birdstrike
