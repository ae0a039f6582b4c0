#include "io/aim/aim.h"
#include "io/parameter_tree.h"
#include "io/scene_size.h"
#include "io/symmetry_check.h"
#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>
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

    void require_stable_bird_step(const BirdParameters &bird, const TimeParameters &time)
    {
      const double scale = time.bird_step_scale, limit = bird.largest_courant_number();
      if (bird.courant_number * scale > limit * (1. + 1e-9))
        throw InputError(fmt::format(
          "{}/Courant number {:g} with Time/Bird step scale {:g} makes steps of {:g} h/c: too "
          "long for Formulation = {}.\nAbove {:g} the rates, taken at velocities foretold "
          "by the last ones, must often be taken twice, and forces ring.\nGive a Courant "
          "number of at most {:g} (default {:g}).",
          bird.section, bird.courant_number, scale, bird.courant_number * scale,
          particle_formulations().name(bird.formulation), limit, limit / scale, BirdParameters().courant_number));
    }

    /// Entries that say 'table' get the values that are used: the file that a run leaves says what it was made of.
    void write_values_of_metals(const BladeParameters &blade, ParameterFile &file)
    {
      std::vector<std::string> values;
      for (const auto &[number, of_section] : blade.by_section())
        {
          const std::string where = "Blade/" + blade.section_path(number) + "Material/";
          if (of_section.is_laminate())
            continue; // nothing reads them, and what nobody has set is not to be told of as unused
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

  namespace
  {
    /// Section names of the further birds, which are not there unless the file says so.
    std::array<CaseParameters::FurtherBird, 3> make_further_birds()
    {
      std::array<CaseParameters::FurtherBird, 3> birds;
      for (std::size_t k = 0; k < birds.size(); ++k)
        {
          birds[k].bird.section = "Bird " + std::to_string(k + 2);
          birds[k].bird.enabled = false;
        }
      return birds;
    }

    /// What the first bird's section says of a further one.
    ParameterFile::Inheritance as_first_bird(const std::string &section)
    {
      const std::string velocity = "Velocity", speed = "Speed", angle = "Angle to surface", flight = "Flight direction",
                        aim = "Aim point", span = "Aim span fraction", chord = "Aim chord fraction",
                        between = "Slice/Between", normal = "Slice/Normal", blades = "Slice/Number of blades";
      return {section,
              "Bird",
              "Enabled",
              {{{velocity}, {speed, angle, flight}},
               {{speed, angle, flight}, {velocity}},
               {{angle}, {flight}},
               {{flight}, {angle}},
               {{aim}, {span, chord}},
               {{span, chord}, {aim}},
               {{blades}, {between, normal, chord}},
               {{between, normal}, {blades}}},
              {"Arrival time"}};
    }

    void check_liquid(const BirdCase &bird)
    {
      try
        {
          bird.liquid.check();
          const EquationOfState eos(bird.liquid, bird.bird.density); // refuses what contradicts the density
        }
      catch (const InputError &error)
        {
          throw InputError("Section '" + bird.bird.section + "': " + error.what());
        }
    }

    std::vector<ParameterGroup> groups_of(CaseParameters &parameters)
    {
      std::vector<ParameterGroup> groups{
        describe_case(parameters.name, parameters.description, parameters.has_symmetry_plane),
        ParameterGroup::of(parameters.blade, "Blade"), ParameterGroup::of(parameters.bird),
        ParameterGroup::of(parameters.equation_of_state, "Bird")};
      for (auto &further : parameters.further_birds)
        groups.push_back({[&further](dealii::ParameterHandler &prm) {
                            further.bird.declare(prm);
                            ParameterGroup::declare_in_section(
                              prm, further.bird.section,
                              [&](dealii::ParameterHandler &inner) { further.liquid.declare(inner); });
                          },
                          [] {}}); // checked where they are enabled
      for (const ParameterGroup &group :
           {ParameterGroup::of(parameters.contact), ParameterGroup::of(parameters.time),
            ParameterGroup::of(parameters.output),
            ParameterGroup{[&parameters](dealii::ParameterHandler &prm) { parameters.study.declare(prm); }, [] {}}})
        groups.push_back(group);
      return groups;
    }
  } // namespace

  CaseParameters::CaseParameters() : further_birds(make_further_birds()), file(groups_of(*this))
  {
    for (const FurtherBird &each : further_birds)
      file.inherit(as_first_bird(each.bird.section));
  }

  void CaseParameters::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    file.read(path, overrides);
    if (name.find('/') != std::string::npos || (!name.empty() && name.find_first_not_of('.') == std::string::npos))
      throw InputError("Case/Name = " + name +
                       ": a name is no path, for it names a folder in runs.\nGive a name without "
                       "'/', and the folder in Output/Directory.");
    check_further_birds(path);
    blade.mesh.row.axis   = blade.spin.axis;
    blade.mesh.row.centre = blade.spin.centre;
    blade.is_halved = bird.is_halved = has_symmetry_plane;
    for (FurtherBird &each : further_birds)
      each.bird.is_halved = has_symmetry_plane;
    resolve_aim(*this); // how a bird lies says what planes cut off it
    require_memory(*this, static_cast<double>(available_memory()));
    if (bird.enabled)
      blade.bird = {bird.target(), bird.velocity};
    if (has_symmetry_plane)
      require_symmetry(*this);
    for (const BirdCase &each : birds())
      require_stable_bird_step(each.bird, time);
    if (name.empty())
      file.set({"Case/Name=" + std::filesystem::path(path).stem().string()}); // so that the printed file knows it too
    if (blade.is_deformable())
      write_values_of_metals(blade, file);
  }

  void CaseParameters::check_further_birds(const std::string &path) const
  {
    for (const BirdCase &each : birds())
      if (each.number > 1)
        try
          {
            if (!bird.enabled)
              throw InputError("Section '" + each.bird.section +
                               "': there is no first bird.\nSet Bird/Enabled to true, or give this one its place.");
            each.bird.check();
            check_liquid(each);
          }
        catch (const InputError &error)
          {
            throw InputError(path + ": " + error.what());
          }
  }

  std::vector<BirdCase> CaseParameters::birds() const
  {
    std::vector<BirdCase> all;
    if (bird.enabled)
      all.push_back({1, bird, equation_of_state});
    for (unsigned int k = 0; k < further_birds.size(); ++k)
      if (further_birds[k].bird.enabled)
        all.push_back({k + 2, further_birds[k].bird, further_birds[k].liquid});
    return all;
  }

  std::string CaseParameters::run_directory() const
  {
    return output.directory.empty() ? "runs/" + name : output.directory;
  }

  std::string first_difference(const CaseParameters &a, const CaseParameters &b, const EntryNames &ignored)
  {
    const ParameterTree &tree_a = a.file.tree(), &tree_b = b.file.tree();
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
