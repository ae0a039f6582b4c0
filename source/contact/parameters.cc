#include <birdstrike/contact/parameters.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace birdstrike
{
  using namespace dealii;

  void ContactParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("Enabled", is_enabled, "Whether bird and blade push one another; off, they pass through. [-]");
    prm.add_parameter("Self-contact", self_contact,
                      "Whether parts of a deformable blade push one another where they meet, without friction; off, "
                      "they pass through. [-]");
    prm.add_parameter("Stiffness scale", stiffness_scale,
                      "Factor on the penalty stiffness, which is that of a cell of the undeformed bird. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Damping scale", damping_scale,
                      "Factor on the acoustic damper, which gives the shock pressure of the first touch. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Step stability share", stability_share,
                      "Largest stiffness of a full layer of particles on a light blade, in units of the blade's mass "
                      "over the square of the bird's longest step; it softens contact with thin skins. [-]",
                      Patterns::Double(0., 2.));
    prm.add_parameter("Friction", friction, "Coefficient of Coulomb friction between bird and blade. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Search margin", search_margin,
                      "Distance in particle spacings by which candidates are collected beyond touch; they serve until "
                      "the relative motion has used it up. [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Pressure patches", patches,
                      "Discs over which the contact pressure is averaged, given as 'name: x y z radius' and separated "
                      "by semicolons; the pressure is taken where the closest point lies in the disc. [m]");
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
    pressure_patches();
  }

  std::vector<PressurePatch> ContactParameters::pressure_patches() const
  {
    std::vector<PressurePatch> result;
    std::istringstream         list(patches);
    for (std::string item; std::getline(list, item, ';');)
      {
        if (item.find_first_not_of(" \t\n") == std::string::npos)
          continue;
        const auto         colon = item.find(':');
        PressurePatch      patch;
        std::istringstream name(item.substr(0, colon));
        std::istringstream numbers(colon == std::string::npos ? std::string() : item.substr(colon + 1));
        std::string        rest;
        const bool         is_read = bool(name >> patch.name) &&
                             bool(numbers >> patch.centre[0] >> patch.centre[1] >> patch.centre[2] >> patch.radius);
        if (!is_read || name >> rest || numbers >> rest || !(patch.radius > 0.))
          throw InputError("Contact/Pressure patches holds '" + item +
                           "'.\nAllowed: 'name: x y z radius', numbers in m, radius more than 0, patches separated by "
                           "semicolons.\nExample: centre: 0 0 0 0.005");
        result.push_back(patch);
      }
    return result;
  }
} // namespace birdstrike
