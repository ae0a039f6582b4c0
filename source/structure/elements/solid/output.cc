#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/elements.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  std::array<double, 6> SolidGroup::point_stress(const std::size_t element, const std::size_t point) const
  {
    const auto           &s = points[element / n_lanes * n_points() + point].stress;
    std::array<double, 6> result;
    for (int c = 0; c < 6; ++c)
      result[c] = lane(s[c], element % n_lanes);
    return result;
  }

  double SolidGroup::compute_volume_ratio(const std::size_t element, const std::size_t point) const
  {
    const SolidModes<double> x = modes(element);
    const std::size_t        b = element / n_lanes, k = element % n_lanes;
    const double             ratio = section.formulation == SolidFormulation::b_bar
                                       ? b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(point))).det /
                               lane(rest_det[b * n_points() + point], k)
                                       : SolidGeometry<double>(x).det / lane(batches[b].rest_det, k);
    return ratio > 0. ? ratio : 1.; // of what has failed and is turned inside out: no stress
  }

  std::array<double, 6> SolidGroup::stabilised_stress(const std::size_t element, const std::array<double, 3> &xi) const
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

  bool SolidGroup::has_points(const std::size_t batch) const
  {
    return layers.empty() || !layers[batch].empty();
  }

  std::size_t SolidGroup::count_yielded(const std::size_t batch) const
  {
    if (layers.empty() || layers[batch].empty())
      return n_elements_of(batch);
    return count_positive(layers[batch].front().plastic_strain + layers[batch].back().plastic_strain, batch);
  }

  double SolidGroup::largest_plastic_strain(const std::size_t element) const
  {
    const std::size_t b = element / n_lanes, k = element % n_lanes;
    double            largest = 0.;
    for (std::size_t p = 0; p < n_points(); ++p)
      largest = std::max(largest, lane(points[b * n_points() + p].plastic_strain, k));
    if (!layers.empty())
      for (const LayerPoint &point : layers[b])
        largest = std::max(largest, lane(point.plastic_strain, k));
    return largest;
  }

  std::size_t SolidGroup::bytes() const
  {
    std::size_t sum = bytes_of_group() + bytes_of(mass_factors) + bytes_of(points) + bytes_of(layers) +
                      bytes_of(thickness_axis) + bytes_of(rest_det) + bytes_of(stabilisation) + bytes_of(corner_shares);
    for (const auto &of_batch : layers)
      sum += bytes_of(of_batch);
    return sum;
  }

  SolidState SolidElements::state(const std::size_t element) const
  {
    const auto [group, e]         = find(element);
    const SolidModes<double>    x = group.modes(e);
    const SolidGeometry<double> g(x);
    SolidState                  state{{}, 0., group.largest_plastic_strain(e), g.volume()};
    for (std::size_t p = 0; p < group.n_points(); ++p)
      {
        double share = 1.;
        if (group.n_points() > 1)
          share = b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(p))).det / (8. * g.det);
        const double strain = lane(group.points[e / n_lanes * group.n_points() + p].plastic_strain, e % n_lanes);
        const auto   stress = group.point_stress(e, p);
        const double ratio  = group.compute_volume_ratio(e, p);
        for (int c = 0; c < 6; ++c)
          state.stress[c] += share / ratio * stress[c];
        state.plastic_strain += share * strain;
      }
    return state;
  }

  std::array<double, 6> SolidElements::corner_stress(const std::size_t element, const unsigned corner) const
  {
    const auto [group, e]          = find(element);
    const std::array<double, 3> xi = {corner & 1 ? 1. : -1., corner & 2 ? 1. : -1., corner & 4 ? 1. : -1.};
    std::array<double, 6>       result{};
    if (group.section.formulation != SolidFormulation::b_bar)
      return group.stabilised_stress(e, xi);
    // the trilinear field through the points, which lie at 1/sqrt(3)
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      {
        double shape = 1.;
        for (int k = 0; k < 3; ++k)
          shape *= 0.5 * (1. + 3. * xi[k] * b_bar_solid::coordinate(p, k));
        const auto stress = group.point_stress(e, std::size_t(p));
        for (int c = 0; c < 6; ++c)
          result[c] += shape / group.compute_volume_ratio(e, std::size_t(p)) * stress[c];
      }
    return result;
  }
} // namespace birdstrike
