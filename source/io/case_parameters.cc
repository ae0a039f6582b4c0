#include "io/aim.h"
#include "io/parameter_tree.h"
#include "io/scene_size.h"
#include "io/symmetry_check.h"
#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/memory.h>
#include <birdstrike/io/case_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace birdstrike
{
  namespace
  {
    ParameterGroup describe_case(std::string &name, std::string &description, bool &is_halved)
    {
      static const NamedChoices<bool> planes{{"none", false}, {"y", true}};
      const auto                      declare = [&](dealii::ParameterHandler &prm) {
        prm.enter_subsection("Case");
        prm.add_parameter("Name", name, "Name of the case; empty stands for the file's name without its ending. [-]");
        prm.add_parameter("Description", description, "One sentence that says what is computed. [-]");
        declare_choice(prm, "Symmetry plane", is_halved, planes,
                                            "Plane of symmetry, none or y: the scene is mirrored at the plane y = 0, and half of the "
                                                                 "bird and of the blade "
                                                                 "is computed. [-]");
        prm.leave_subsection();
      };
      return {declare, [] {}};
    }

    void require_stable_bird_step(const CaseParameters &parameters)
    {
      const BirdParameters &bird  = parameters.bird;
      const double          scale = parameters.time.bird_step_scale, limit = bird.largest_courant_number();
      if (bird.enabled && bird.courant_number * scale > limit * (1. + 1e-9))
        throw InputError(fmt::format(
          "Bird/Courant number {:g} with Time/Bird step scale {:g} makes steps of {:g} h/c: too "
          "long for Bird/Formulation = {}.\nAbove {:g} the rates, taken at velocities foretold "
          "by the last ones, must often be taken twice, and forces ring.\nGive a Courant "
          "number of at most {:g} (default {:g}).",
          bird.courant_number, scale, bird.courant_number * scale, particle_formulations().name(bird.formulation),
          limit, limit / scale, BirdParameters().courant_number));
    }

    /// Entries that say 'table' get the values that are used: the file that a run leaves says what it was made of.
    void write_values_of_metals(const BladeParameters &blade, ParameterFile &file)
    {
      std::vector<std::string> values;
      for (const auto &[number, of_section] : blade.by_section())
        {
          const std::string where = "Blade/" + blade.section_path(number) + "Material/";
          if (number > 0 && blade.sections[number - 1].material.name == BladeParameters::Section::same)
            {
              file.annotate(where + "Name",
                            "Here " + of_section.material.name + ", with what Blade/Material says of it.");
              continue;
            }
          file.annotate(where + "Name", "What its laws use is written out below, and stays if the name is changed.");
          for (const auto &used : of_section.material.used_values(where))
            {
              if (used.is_of_table)
                file.annotate(where + used.entry, "Of the table: " + of_section.material.name + ".");
              if (used.is_taken)
                values.push_back(where + used.entry + "=" + used.value);
            }
        }
      file.set(values);
    }

    std::string name_of(const KnownEntry &entry)
    {
      return (entry.section.empty() ? "" : to_string(entry.section) + "/") + entry.name;
    }

    /// False for what is no number as a whole.
    bool parse(const std::string &text, double &value)
    {
      char *end = nullptr;
      value     = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0';
    }

    bool are_equal(const std::string &a, const std::string &b)
    {
      double of_a = 0., of_b = 0.;
      return a == b || (parse(a, of_a) && parse(b, of_b) && of_a == of_b);
    }
  } // namespace

  CaseParameters::CaseParameters()
    : file({describe_case(name, description, has_symmetry_plane),
            ParameterGroup::of(blade, "Blade"),
            ParameterGroup::of(bird),
            ParameterGroup::of(equation_of_state, "Bird"),
            ParameterGroup::of(contact),
            ParameterGroup::of(time),
            ParameterGroup::of(output),
            {[this](dealii::ParameterHandler &prm) { study.declare(prm); }, [] {}}})
  {
  }

  void CaseParameters::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    file.read(path, overrides);
    if (name.find('/') != std::string::npos || (!name.empty() && name.find_first_not_of('.') == std::string::npos))
      throw InputError("Case/Name = " + name +
                       ": a name is no path, for it names a folder in runs.\nGive a name without "
                       "'/', and the folder in Output/Directory.");
    blade.is_halved = bird.is_halved = has_symmetry_plane;
    require_memory(*this, static_cast<double>(available_memory()));
    resolve_aim(*this);
    if (bird.enabled)
      blade.bird_velocity = bird.velocity;
    if (has_symmetry_plane)
      require_symmetry(*this);
    require_stable_bird_step(*this);
    if (name.empty())
      file.set({"Case/Name=" + std::filesystem::path(path).stem().string()}); // so that the printed file knows it too
    if (blade.is_deformable())
      write_values_of_metals(blade, file);
  }

  std::string CaseParameters::run_directory() const
  {
    return output.directory.empty() ? "runs/" + name : output.directory;
  }

  std::string first_difference(const CaseParameters &a, const CaseParameters &b, const EntryNames &ignored)
  {
    const ParameterTree tree_a = a.file.tree(), tree_b = b.file.tree();
    for (const KnownEntry &entry : tree_a.entries())
      {
        const std::string name = name_of(entry);
        if (std::find(ignored.begin(), ignored.end(), name) == ignored.end() &&
            !are_equal(entry.value, tree_b.find(entry.section, entry.name)->value))
          return name;
      }
    return "";
  }
} // namespace birdstrike
