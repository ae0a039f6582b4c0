#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/symmetry_check.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

namespace birdstrike
{
  namespace
  {
    ParameterGroup describe_case(std::string &name, std::string &description, std::string &plane)
    {
      const auto declare = [&](dealii::ParameterHandler &prm) {
        prm.enter_subsection("Case");
        prm.add_parameter("Name", name, "Name of the case; empty stands for the file's name without its ending. [-]");
        prm.add_parameter("Description", description, "One sentence that says what is computed. [-]");
        prm.add_parameter("Symmetry plane", plane,
                          "Plane of symmetry, none or y: the scene is mirrored at the plane y = 0, and half of the "
                          "bird and of the blade "
                          "is computed. [-]",
                          dealii::Patterns::Selection("none|y"));
        prm.leave_subsection();
      };
      return {declare, [] {}};
    }
  } // namespace

  CaseParameters::CaseParameters()
    : file({describe_case(name, description, symmetry_plane), ParameterGroup::of(blade, "Blade"),
            ParameterGroup::of(bird), ParameterGroup::of(equation_of_state, "Bird"), ParameterGroup::of(contact),
            ParameterGroup::of(time), ParameterGroup::of(output)})
  {
  }

  void CaseParameters::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    file.read(path, overrides);
    blade.is_halved = bird.is_halved = has_symmetry_plane();
    if (bird.enabled)
      blade.bird_velocity = bird.velocity;
    if (has_symmetry_plane())
      require_symmetry(*this);
    if (name.empty())
      file.set("Case/Name=" + std::filesystem::path(path).stem().string()); // so that the printed file knows it too
  }

  bool CaseParameters::has_symmetry_plane() const
  {
    return symmetry_plane == "y";
  }

  std::string CaseParameters::run_directory() const
  {
    return output.directory.empty() ? "runs/" + name : output.directory;
  }
} // namespace birdstrike
