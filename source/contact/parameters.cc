#include <birdstrike/contact/parameters.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/parameter_handler.h>

#include <numbers>

namespace birdstrike
{
  using namespace dealii;

  void ContactParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("Enabled", is_enabled,
                      "Contact between bird and blade. false: they pass through one another. [-]");
    prm.add_parameter(
      "Self-contact", self_contact,
      "Frictionless contact between parts of a deformable blade. false: they pass through one another. [-]");
    prm.add_parameter("Stiffness scale", stiffness_scale,
                      "Factor on the penalty stiffness, which is that of a cell of the undeformed bird. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Damping scale", damping_scale,
                      "Factor on the acoustic damper, which gives the shock pressure of first contact. [-]",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Step stability share", stability_share,
      "Upper bound of the contact stiffness of a full layer of particles on a light (thin) blade. Its unit is blade "
      "mass over the squared time step. The bound keeps contact from limiting the step (as SOFT = 1 of LS-DYNA). [-]",
      Patterns::Double(0., 2.));
    prm.add_parameter("Friction", friction, "Coefficient of Coulomb friction between bird and blade. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Search margin", search_margin,
                      "Distance beyond contact, in particle spacings, within which the search collects candidates. "
                      "They serve until the relative motion has used it up. [-]",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Largest penetration", largest_penetration,
      "Largest penetration in particle spacings below the surface that the particle met. A deeper particle counts as "
      "stuck in the blade or through it, and the run ends. LS-DYNA's PENMAX releases such nodes instead. [-]",
      Patterns::Double(0.));
    prm.add_parameter(
      "Pressure patches", patches,
      "Discs over which the contact pressure is averaged: 'name: x y z radius', separated by semicolons. The pressure "
      "counts where the closest point lies in the disc. The disc's centre moves with the surface from its place at the "
      "start. Parts of a disc beyond an edge do not count. [m]");
    prm.leave_subsection();
  }

  void ContactParameters::check() const
  {
    if (is_enabled && !(stability_share > 0.))
      throw InputError(
        "Contact/Step stability share is 0, so contact with a deformable blade would have no stiffness.\n"
        "Allowed: more than 0, at most 2.\nGive 0.4, or set Enabled = false.");
    if (is_enabled && !(stiffness_scale > 0.))
      throw InputError("Contact/Stiffness scale is 0, so points would pass through the surface.\n"
                       "Allowed: more than 0.\nGive 1, or set Enabled = false.");
    if (is_enabled && !(largest_penetration > 0.))
      throw InputError("Contact/Largest penetration is 0, so first contact would end the run.\nAllowed: more than "
                       "0.\nGive 1, or 1e9 for no limit.");
    pressure_patches();
  }

  std::vector<PressurePatch> ContactParameters::pressure_patches() const
  {
    const std::string          entry = "Contact/Pressure patches";
    std::vector<PressurePatch> result;
    for (const auto &[name, disc] : parse_pairs(patches, entry))
      {
        const auto x = parse_numbers(disc, 4, entry);
        if (!(x[3] > 0.) || name.find(' ') != std::string::npos)
          throw InputError(entry + " holds '" + name + ": " + disc +
                           "'.\nAllowed: 'name: x y z radius', names without blanks, a radius of more than 0.");
        for (const PressurePatch &other : result)
          if (other.name == name)
            throw InputError(entry + ": two are called '" + name +
                             "'.\nGive each a name of its own: it names their curves.");
        result.push_back({name, {x[0], x[1], x[2]}, x[3], std::numbers::pi * x[3] * x[3]});
      }
    return result;
  }
} // namespace birdstrike
