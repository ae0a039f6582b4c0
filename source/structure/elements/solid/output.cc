#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/implementation.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  std::array<double, 6> SolidElements::Implementation::point_stress(const std::size_t element,
                                                                    const std::size_t point) const
  {
    const auto           &s = points[element / n_lanes * n_points() + point].stress;
    std::array<double, 6> result;
    for (int c = 0; c < 6; ++c)
      result[c] = lane(s[c], element % n_lanes);
    return result;
  }

  double SolidElements::Implementation::compute_volume_ratio(const std::size_t element, const std::size_t point) const
  {
    const SolidModes<double> x = modes(element);
    const std::size_t        b = element / n_lanes, k = element % n_lanes;
    const double             ratio = section.formulation == SolidFormulation::b_bar
                                       ? b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(point))).det /
                               lane(rest_det[b * n_points() + point], k)
                                       : SolidGeometry<double>(x).det / lane(batches[b].rest_det, k);
    return ratio > 0. ? ratio : 1.; // of what has failed and is turned inside out: no stress
  }

  std::array<double, 6> SolidElements::Implementation::stabilised_stress(const std::size_t            element,
                                                                         const std::array<double, 3> &xi) const
  {
    const std::size_t                      b = element / n_lanes, lane_of = element % n_lanes;
    const SolidModes<double>               x = modes(element);
    one_point_solid::Stabilisation<double> s;
    for (int k = 0; k < 3; ++k)
      {
        s.last[k] = lane(stabilisation[b].last[k], lane_of);
        for (int c = 0; c < 3; ++c)
          s.linear[k][c] = lane(stabilisation[b].linear[k][c], lane_of);
      }
    double                residual[5]{}, stress[6]{};
    std::array<double, 3> at = xi;
    if (!thickness_axis.empty())
      {
        const int axis    = thickness_axis[element];
        const auto [i, j] = following(axis);
        at                = {xi[i], xi[j], xi[axis]};
        if (!layers[b].empty()) // at the outermost point
          {
            const unsigned int k = at[2] < 0. ? 0 : rule.n - 1;
            for (double &component : s.linear[2])
              component *= std::abs(rule.position[k]);
            for (int c = 0; c < 5; ++c)
              residual[c] = lane(layers[b][k].residual[c], lane_of);
          }
        solid_shell::Frame<double>(x, one_point_solid::Axes<double>(x)).add_to(residual, 0., stress);
      }
    std::array<double, 6> result      = point_stress(element, 0);
    const Matrix3<double> rest        = one_point_solid::compute_stress_at(x, s, at);
    constexpr int         pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
    const double          ratio       = compute_volume_ratio(element, 0);
    for (int c = 0; c < 6; ++c)
      result[c] = (result[c] + rest(pairs[c][0], pairs[c][1]) + stress[c]) / ratio;
    return result;
  }

  SolidState SolidElements::state(const std::size_t element) const
  {
    const Implementation       &my = *implementation;
    const SolidModes<double>    x  = my.modes(element);
    const SolidGeometry<double> g(x);
    SolidState                  state{{}, 0., 0., g.volume()};
    for (std::size_t p = 0; p < my.n_points(); ++p)
      {
        double share = 1.;
        if (my.n_points() > 1)
          share = b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(p))).det / (8. * g.det);
        const double strain = lane(my.points[element / n_lanes * my.n_points() + p].plastic_strain, element % n_lanes);
        const auto   stress = my.point_stress(element, p);
        const double ratio  = my.compute_volume_ratio(element, p);
        for (int c = 0; c < 6; ++c)
          state.stress[c] += share / ratio * stress[c];
        state.plastic_strain += share * strain;
        state.max_plastic_strain = std::max(state.max_plastic_strain, strain);
      }
    if (!my.layers.empty())
      for (const auto &point : my.layers[element / n_lanes])
        state.max_plastic_strain = std::max(state.max_plastic_strain, lane(point.plastic_strain, element % n_lanes));
    return state;
  }

  std::array<double, 6> SolidElements::corner_stress(const std::size_t element, const unsigned corner) const
  {
    const Implementation       &my = *implementation;
    const std::array<double, 3> xi = {corner & 1 ? 1. : -1., corner & 2 ? 1. : -1., corner & 4 ? 1. : -1.};
    std::array<double, 6>       result{};
    if (my.section.formulation != SolidFormulation::b_bar)
      return my.stabilised_stress(element, xi);
    // the trilinear field through the points, which lie at 1/sqrt(3)
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      {
        double shape = 1.;
        for (int k = 0; k < 3; ++k)
          shape *= 0.5 * (1. + 3. * xi[k] * b_bar_solid::coordinate(p, k));
        const auto stress = my.point_stress(element, std::size_t(p));
        for (int c = 0; c < 6; ++c)
          result[c] += shape / my.compute_volume_ratio(element, std::size_t(p)) * stress[c];
      }
    return result;
  }

  SolidElements::MaxPlasticStrain SolidElements::max_plastic_strain() const
  {
    const Implementation &my = *implementation;
    MaxPlasticStrain      result;
    for (std::size_t e = 0; e < n_elements(); ++e)
      {
        const auto look = [&](const auto &point) {
          if (const double strain = lane(point.plastic_strain, e % n_lanes); strain > result.value)
            result = {strain, e};
        };
        std::for_each_n(my.points.begin() + std::ptrdiff_t(e / n_lanes * my.n_points()), my.n_points(), look);
        if (!my.layers.empty())
          std::for_each(my.layers[e / n_lanes].begin(), my.layers[e / n_lanes].end(), look);
      }
    return result;
  }
} // namespace birdstrike
