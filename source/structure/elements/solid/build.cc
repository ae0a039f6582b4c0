#include "structure/elements/element_failure.h"
#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/group.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    const SolidSection &checked(const SolidSection &section)
    {
      const auto       &m  = section.material;
      const double      nu = m.elasticity.poisson;
      const std::string bad =
        !(m.density > 0.)            ? "density " + text_of(m.density) + " kg/m^3, must be positive"
        : !(m.elasticity.young > 0.) ? "Young's modulus " + text_of(m.elasticity.young) + " Pa, must be positive"
        : !(nu > -1. && nu < 0.5)    ? "Poisson's ratio " + text_of(nu) + ", must lie between -1 and 0.5"
        : !(section.linear_viscosity >= 0.)
          ? "linear viscosity " + text_of(section.linear_viscosity) + ", must not be negative"
        : !(section.quadratic_viscosity >= 0.)
          ? "quadratic viscosity " + text_of(section.quadratic_viscosity) + ", must not be negative"
        : section.formulation == SolidFormulation::solid_shell && m.failure.can_fail()
          ? "solid-shells of a metal that fails"
          : "";
      if (!bad.empty())
        throw InputError("Solid elements: " + bad + ".");
      return section;
    }
  } // namespace

  SolidGroup::SolidGroup(const SolidSection &of_group, Place elements, const std::vector<std::uint8_t> &axis,
                         const ElementBlocks &blocks)
    : ElementGroup(std::move(elements), blocks)
    , section(checked(of_group))
    , law(section)
    , thickness_axis(section.formulation == SolidFormulation::solid_shell ? axis : std::vector<std::uint8_t>())
  {
    for (std::size_t e = 0; e < n_elements(); ++e)
      check_shape(e);
    build_points();
    build_corners();
    if (section.material.failure.can_fail())
      build_erosion();
  }

  SolidModes<double> SolidGroup::modes(const std::size_t element) const
  {
    Vector3<double> x[8];
    for (int i = 0; i < 8; ++i)
      x[i] = Point3(place.records[place.cells[element][i]].position);
    return SolidModes<double>(x);
  }

  void SolidGroup::check_shape(const std::size_t e)
  {
    const SolidModes<double>    x = modes(e);
    const SolidGeometry<double> g(x);
    double                      smallest = g.volume();
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      smallest = std::min(smallest, b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, p)).det / 64.);
    // a brick of the same edges has this volume
    const double box =
      std::sqrt(x.linear[0].squaredNorm() * x.linear[1].squaredNorm() * x.linear[2].squaredNorm()) / 64.;
    if (!(smallest > 1e-7 * box))
      throw InputError("Solid " + where(e).text() + ": volume " + text_of(g.volume()) +
                       " m^3, smallest volume at a point " + text_of(smallest) +
                       " m^3; both must be positive.\nCorners are numbered (0,0,0), (1,0,0), (0,1,0), "
                       "(1,1,0), then the same at z = 1, right-handed.");
    mass.push_back(section.material.density * g.volume());
  }

  void SolidGroup::build_points()
  {
    const std::size_t n_batches = batches.size();
    SolidPoint<Lanes> point{};
    for (Lanes &s : point.stress)
      s = 0.;
    point.plastic_strain = point.plastic_work = 0.;
    point.yield                               = law.initial_yield();
    points.assign(n_batches * n_points(), point);
    if (section.formulation == SolidFormulation::b_bar)
      rest_det.resize(n_batches * n_points());
    if (section.formulation == SolidFormulation::solid_shell)
      {
        rule = make_thickness_points(section.rule, section.n_points);
        layers.resize(n_batches);
      }
    if (section.formulation != SolidFormulation::b_bar)
      {
        stabilisation.resize(n_batches);
        for (auto &s : stabilisation)
          for (int k = 0; k < 3; ++k)
            s.last[k] = s.linear[k][0] = s.linear[k][1] = s.linear[k][2] = 0.;
      }
    for (std::size_t slot = 0; slot < n_batches * n_lanes; ++slot)
      {
        const std::size_t        b = slot / n_lanes, k = slot % n_lanes;
        const SolidModes<double> x  = modes(element_of(slot));
        batches[b].viscous_pressure = 0.;
        batches[b].rest_det[k]      = SolidGeometry<double>(x).det;
        for (std::size_t p = 0; p < n_points() && !rest_det.empty(); ++p)
          rest_det[b * n_points() + p][k] =
            b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(p))).det;
      }
  }

  double SolidGroup::compute_frequency_at_rest(const std::size_t element, const double inverse_mass) const
  {
    const SolidModes<double>    x = modes(element);
    const SolidGeometry<double> g(x);
    double                      drag;
    law.compute_viscous_pressure(0., g.compute_height(), drag);
    return compute_frequency_bound(g, g.det, inverse_mass, drag, law, section.formulation);
  }

  void SolidGroup::update_bounds_at_rest()
  {
    update_bounds([this](const std::size_t b) {
      Lanes bound;
      for (std::size_t k = 0; k < n_lanes; ++k)
        bound[k] = compute_frequency_at_rest(element_of(b * n_lanes + k), batches[b].inverse_mass[k]);
      if (erosion)
        erosion->batches[b].allowed = bound / section.material.failure.smallest_step;
      return mass_factors.empty() ? bound : compute_frequency_at_rest(b, mass_factors[b]);
    });
  }

  std::size_t SolidGroup::n_points() const
  {
    return section.formulation == SolidFormulation::b_bar ? b_bar_solid::n_points : 1;
  }

  void SolidGroup::report_failure(const std::size_t b) const
  {
    const auto smallest_volume = [this](const std::size_t element) {
      const SolidModes<double> x      = modes(element);
      double                   volume = SolidGeometry<double>(x).volume();
      if (section.formulation == SolidFormulation::b_bar)
        for (int p = 0; p < b_bar_solid::n_points; ++p)
          volume = std::min(volume, b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, p)).det / 64.);
      return std::min(volume, smallest_corner(element));
    };
    const auto is_sound = [&](const std::size_t element) {
      double sum = 0.;
      for (const auto &corner : batches[element / n_lanes].corner)
        for (const double f : place.corner_force[corner[element % n_lanes]].value)
          sum += f;
      return std::isfinite(sum) && smallest_volume(element) > 0.;
    };
    std::size_t e = b * n_lanes;
    for (std::size_t k = n_elements_of(b); k-- > 0;)
      if (!is_failed(b * n_lanes + k) && !is_sound(b * n_lanes + k))
        e = b * n_lanes + k;
    throw make_element_failure("brick", where(e), "volume by its worst point", smallest_volume(e), "m^3",
                               bool(erosion));
  }
} // namespace birdstrike
