#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/structure/laminate_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using dealii::Utilities::trim;
  } // namespace

  LaminateParameters LaminateParameters::of_blade()
  {
    LaminateParameters result;
    result.reference_direction = "1 0 0";
    result.n_per_ply           = 1;
    result.degradation_time    = 1e-4;
    result.failed_share        = 1.;

    result.matrix_failure_strain = 0.2;
    return result;
  }

  bool LaminateParameters::is_given() const
  {
    return !trim(plies).empty();
  }

  LaminateParameters LaminateParameters::with_others(const LaminateParameters &blade) const
  {
    LaminateParameters result = *this;
    result.ply                = birdstrike::with_others(ply, blade.ply);
    const auto fill           = [](auto &value, const auto &other) {
      if (value == std::decay_t<decltype(value)>())
        value = other;
    };
    fill(result.reference_direction, blade.reference_direction);
    fill(result.n_per_ply, blade.n_per_ply);
    fill(result.degradation_time, blade.degradation_time);
    fill(result.failed_share, blade.failed_share);
    fill(result.smallest_step, blade.smallest_step);
    fill(result.matrix_failure_strain, blade.matrix_failure_strain);
    fill(result.materials, blade.materials);
    return result;
  }

  void LaminateParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.add_parameter(
      "Plies", plies,
      "Angles of a laminate's plies in degrees, from the bottom (the side opposite to the normal) to the top. The "
      "entry makes shells a laminate. With thicknesses: '0: 0.125 mm; 45: 0.25 mm'. Equal plies by a stacking code: "
      "'[0/45/-45/90]2s', '[0_2/+-45]s'. Only the ratios of the thicknesses count: Thickness sets the sum, and tapered "
      "blades have tapered plies. A third part names the material of a ply (Material k/Name): '0: 0.125 mm: carbon; 0: "
      "5 mm: foam', or with equal plies '0: carbon'. A ply without a name has the constants of this section. Empty: "
      "the blade is a metal. [m]",
      Patterns::Anything());
    prm.add_parameter("Reference direction", reference_direction,
                      "Global direction 'x y z' from which the angles count, counter-clockwise about the normal. It is "
                      "projected on each element at the start. Empty: the blade's direction. [-]",
                      Patterns::Anything());
    prm.add_parameter("Points per ply", n_per_ply,
                      "Number of points through each ply at which its failure is checked. The stiffness is exact with "
                      "one. 0: the blade's number. [-]",
                      Patterns::Integer(0, 20));
    declare_ply(prm, ply);
    prm.add_parameter(
      "Degradation time", degradation_time,
      "Time over which a failed ply loses the stiffness of its failure mode. The loss has a constant rate, whatever "
      "the time steps. A time below one step means at once. 0: the blade's time, and 100 us for the blade itself. [s]",
      Patterns::Double(0., 1.));
    prm.add_parameter("Failed share", failed_share,
                      "Share of an element's thickness in which plies must have broken before the element is removed. "
                      "Plies break by their fibres or by Matrix failure strain. 0: the blade's share. [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Matrix failure strain", matrix_failure_strain,
                      "Strain at which a ply breaks once its matrix has failed completely. It counts across the "
                      "fibres, in tension or compression, and in shear along them. Coupons that fail by the matrix "
                      "alone break there. 0: never; in a section, the blade's strain. [-]",
                      Patterns::Double(0., 10.));
    prm.add_parameter(
      "Smallest step", smallest_step,
      "Smallest stable step of an element whose plies can fail, as a share of its first one. An element with a smaller "
      "step is removed, and so is one that is turned inside out. 0: never; in a section, the blade's share. [-]",
      Patterns::Double(0., 0.9));
  }

  std::array<double, 3> LaminateParameters::reference(const std::string &where) const
  {
    const auto numbers = parse_numbers(reference_direction, 3, where + "Reference direction");
    if (!(std::hypot(numbers[0], numbers[1], numbers[2]) > 0.))
      throw InputError(where + "Reference direction: it has no length.\nAllowed: any three numbers that are not all "
                               "zero, '1 0 0' along the span of built-in blades.");
    return {{numbers[0], numbers[1], numbers[2]}};
  }

  void LaminateParameters::declare_materials(dealii::ParameterHandler &prm)
  {
    for (std::size_t k = 0; k < materials.size(); ++k)
      {
        prm.enter_subsection("Material " + std::to_string(k + 1));
        prm.add_parameter("Name", materials[k].name,
                          "Name of a ply material, for the plies of Blade/Laminate and of sections. The material is "
                          "elastic until it fails. It takes no constants from elsewhere. Isotropic: equal moduli 1 and "
                          "2, and shear moduli E/(2 (1 + nu)). Empty: there is no such material. [-]",
                          dealii::Patterns::Anything());
        declare_ply(prm, materials[k].ply);
        prm.leave_subsection();
      }
  }

  void LaminateParameters::check(const std::string &where) const
  {
    check_materials();
    for (const PlyMaterial &material : stack(where).materials)
      check_ply(material.ply, material.name.empty() ? where : "Blade/Laminate/" + material.entries);
    reference(where);
    if (smallest_step > 0. && !can_fail())
      throw InputError(where + "Smallest step is given, but no strength: no element of such plies is removed.\nGive "
                               "the strengths, or set Smallest step = 0.");
  }

  void LaminateParameters::check_materials() const
  {
    for (std::size_t k = 0; k < materials.size(); ++k)
      {
        const std::string where = std::string("Blade/Laminate/") + "Material " + std::to_string(k + 1) + "/",
                          name  = trim(materials[k].name);
        if (name.empty() && materials[k].ply != Ply())
          throw InputError(where +
                           "Name is not given, but constants are.\nName the material, as plies call it, or leave "
                           "them out.");
        if (name.find_first_of(":;[]/") != std::string::npos || dealii::Patterns::Double().match(name))
          throw InputError(where + "Name: '" + name +
                           "' cannot be told from the numbers of Plies.\nChoose a word without ':', ';', '/' and "
                           "brackets.");
        for (std::size_t other = 0; other < k && !name.empty(); ++other)
          if (trim(materials[other].name) == name)
            throw InputError(where + "Name: '" + name + "' is the name of Material " + std::to_string(other + 1) +
                             " too.\nGive each its own.");
      }
  }

  bool LaminateParameters::can_fail() const
  {
    const PlyStack all = stack();
    return std::any_of(all.materials.begin(), all.materials.end(),
                       [](const PlyMaterial &material) { return material.ply.strength.can_fail(); });
  }

  double LaminateParameters::density() const
  {
    const PlyStack all = stack();
    double         sum = all.materials[0].ply.density;
    for (const PlyLayer &layer : all.layers) // of one material its own, to the last bit
      sum += layer.share * (all.materials[layer.material].ply.density - all.materials[0].ply.density);
    return sum;
  }

  double LaminateParameters::largest_young() const
  {
    double largest = 0.;
    for (const PlyMaterial &material : stack().materials)
      largest = std::max(largest, material.ply.young_1);
    return largest;
  }

  bool LaminateParameters::is_symmetric_about_y() const
  {
    const auto   d        = reference();
    const double in_plane = std::hypot(d[0], d[2]), along = std::abs(d[1]), small = 1e-9 * (in_plane + along);
    const auto   all = layers();
    return (in_plane <= small || along <= small) && std::all_of(all.begin(), all.end(), [](const PlyLayer &layer) {
             return std::abs(std::remainder(layer.angle, 90.)) < 1e-9;
           });
  }

  std::string describe(const LaminateParameters &laminate)
  {
    const std::string code  = trim(laminate.plies);
    const PlyStack    stack = laminate.stack();
    std::string       text  = fmt::format("{} plies{}", stack.layers.size(), code.starts_with('[') ? ", " + code : "");
    for (std::size_t k = 0; k < stack.materials.size(); ++k)
      {
        const PlyMaterial &material = stack.materials[k];
        double             share    = 0.;
        for (const PlyLayer &layer : stack.layers)
          share += layer.material == k ? layer.share : 0.;
        if (stack.materials.size() > 1 || !material.name.empty())
          text += fmt::format("; {:.4g} % of the thickness {}", 100. * share,
                              material.name.empty() ? "without a name" : material.name);
        text += (stack.materials.size() > 1 || !material.name.empty() ? ": " : ", ") + describe(material.ply);
      }
    if (laminate.can_fail())
      text += fmt::format("; what fails does so over {:.4g} us", 1e6 * laminate.degradation_time);
    return text;
  }
} // namespace birdstrike
