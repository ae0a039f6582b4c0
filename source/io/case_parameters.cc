#include "io/aim/aim.h"
#include "io/inputs/file_entries.h"
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
        prm.add_parameter("Name", name, "Name of the case. Empty: the file's name without its ending. [-]");
        prm.add_parameter("Description", description, "Description of the case in one sentence. [-]");
        declare_choice(prm, "Symmetry plane", is_halved, planes,
                                            "Plane of symmetry. none: the whole scene is computed. "
                                                                 "y: the scene is mirrored at the plane y = 0, "
                                                                 "and half of the bird and half of the blade are computed. [-]");
        prm.leave_subsection();
      };
      return {declare, [] {}};
    }

    void require_stable_bird_step(const BirdParameters &bird, const TimeParameters &time)
    {
      const double scale = time.bird_step_scale, limit = bird.largest_courant_number();
      if (bird.courant_number * scale > limit * (1. + 1e-9))
        throw InputError(fmt::format(
          "{}/Courant number {:g} with Time/Bird step scale {:g} makes steps of {:g} h/c: too long for Formulation = "
          "{}.\nAbove {:g} the rates at predicted velocities must often be computed twice, and forces ring.\nGive a "
          "Courant number of at most {:g} (default {:g}).",
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
                            "Here " + of_section.material.name + ", with its data from Blade/Material.");
              continue;
            }
          file.annotate(where + "Name",
                        "The constants of its laws are written out below. They stay if the name is changed.");
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

    /// Files by their contents, wherever they lie.
    bool are_equal(const KnownEntry &entry, const std::string &other)
    {
      double of_a = 0., of_b = 0.;
      return entry.value == other || (parse(entry.value, of_a) && parse(other, of_b) && of_a == of_b) ||
             (names_file(entry) && have_same_contents(entry.value, other));
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
                        aim = "Aim point", position = "Position", span = "Aim span fraction",
                        chord = "Aim chord fraction", between = "Slice/Between", normal = "Slice/Normal",
                        blades = "Slice/Number of blades";
      return {section,
              "Bird",
              "Enabled",
              {{{velocity}, {speed, angle, flight}},
               {{speed, angle, flight}, {velocity}},
               {{angle}, {flight}},
               {{flight}, {angle}},
               {{aim}, {span, chord, position}},
               {{span, chord}, {aim, position}},
               {{position}, {aim, span, chord}},
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

    /// Checked where a bird flies.
    ParameterGroup of_bird(const CaseParameters &parameters, ParameterGroup group)
    {
      group.check = [&parameters, check = group.check] {
        if (!parameters.is_blade_alone)
          check();
      };
      return group;
    }

    std::vector<ParameterGroup> groups_of(CaseParameters &parameters)
    {
      std::vector<ParameterGroup> groups{
        describe_case(parameters.name, parameters.description, parameters.has_symmetry_plane),
        ParameterGroup::of(parameters.blade, "Blade"), of_bird(parameters, ParameterGroup::of(parameters.bird)),
        of_bird(parameters, ParameterGroup::of(parameters.equation_of_state, "Bird"))};
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

  void CaseParameters::read_entries(const std::string &path, const std::vector<std::string> &overrides)
  {
    file.read(path, overrides);
    if (name.find('/') != std::string::npos || (!name.empty() && name.find_first_not_of('.') == std::string::npos))
      throw InputError("Case/Name = " + name +
                       ": a name must not be a path, because it names a folder in runs.\nGive a name without '/', and "
                       "the folder in Output/Directory.");
    blade.mesh.row.axis   = blade.spin.axis;
    blade.mesh.row.centre = blade.spin.centre;
    blade.is_halved       = has_symmetry_plane;
  }

  void CaseParameters::read(const std::string &path, const std::vector<std::string> &overrides)
  {
    is_blade_alone = false;
    read_entries(path, overrides);
    check_further_birds(path);
    bird.is_halved = has_symmetry_plane;
    for (FurtherBird &each : further_birds)
      each.bird.is_halved = has_symmetry_plane;
    resolve_aim(*this); // how a bird lies says what planes cut off it
    if (bird.enabled)
      blade.bird = {bird.target(), bird.velocity};
    complete(path);
  }

  std::string CaseParameters::read_blade(const std::string &path, const std::vector<std::string> &overrides)
  {
    is_blade_alone = true;
    read_entries(path, overrides);
    std::string why_unknown;
    blade.bird   = find_struck_side(*this, why_unknown);
    bird.enabled = false;
    for (FurtherBird &each : further_birds)
      each.bird.enabled = false;
    complete(path);
    return why_unknown;
  }

  /// What is asked of the whole case, and what its printed file knows beyond the one that was read.
  void CaseParameters::complete(const std::string &path)
  {
    require_memory(*this, static_cast<double>(available_memory()));
    if (has_symmetry_plane)
      require_symmetry(*this);
    for (const BirdCase &each : birds())
      require_stable_bird_step(each.bird, time);
    if (name.empty())
      file.set({"Case/Name=" + std::filesystem::path(path).stem().string()});
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

  EntryNames file_entries(const CaseParameters &parameters)
  {
    EntryNames names;
    for (const KnownEntry &entry : parameters.file.tree().entries())
      if (names_file(entry))
        names.push_back(name_of(entry));
    return names;
  }

  std::string first_difference(const CaseParameters &a, const CaseParameters &b, const EntryNames &ignored)
  {
    const ParameterTree &tree_a = a.file.tree(), &tree_b = b.file.tree();
    for (const KnownEntry &entry : tree_a.entries())
      {
        const std::string name = name_of(entry);
        if (std::find(ignored.begin(), ignored.end(), name) == ignored.end() &&
            !are_equal(entry, tree_b.find(entry.section, entry.name)->value))
          return name;
      }
    return "";
  }
} // namespace birdstrike
