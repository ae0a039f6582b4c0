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

  void SolidGroup::suspend_flow(const bool is_suspended)
  {
    law.hardening = is_suspended ? hardening_without_flow() : section.material.hardening;
    for (SolidPoint<Lanes> &point : points)
      point.yield = law.initial_yield();
    for (auto &of_batch : layers)
      for (LayerPoint &point : of_batch)
        point.yield = law.initial_yield();
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

  one_point_solid::Stabilisation<double> SolidGroup::take_stabilisation(const std::size_t element) const
  {
    const Stabilisation                   &of_batch = stabilisation[element / n_lanes];
    one_point_solid::Stabilisation<double> s;
    for (int k = 0; k < 3; ++k)
      {
        s.last[k] = lane(of_batch.last[k], element % n_lanes);
        for (int c = 0; c < 3; ++c)
          s.linear[k][c] = lane(of_batch.linear[k][c], element % n_lanes);
      }
    return s;
  }

  std::array<double, 6> SolidGroup::stabilised_stress(const std::size_t element, const std::array<double, 3> &xi) const
  {
    const std::size_t                      b = element / n_lanes;
    const SolidModes<double>               x = modes(element);
    one_point_solid::Stabilisation<double> s = take_stabilisation(element);
    double                                 residual[5]{}, stress[6]{};
    std::array<double, 3>                  at = xi;
    if (!thickness_axis.empty())
      {
        const int axis    = thickness_axis[element];
        const auto [i, j] = following(axis);
        at                = {xi[i], xi[j], xi[axis]};
        if (!layers[b].empty() && at[2] != 0.) // at the outermost point; at 0 the mean over the thickness
          {
            const unsigned int k = at[2] < 0. ? 0 : rule.n - 1;
            for (double &component : s.linear[2])
              component *= std::abs(rule.position[k]);
            for (int c = 0; c < 5; ++c)
              residual[c] = lane(layers[b][k].residual[c], element % n_lanes);
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

  std::array<double, 6> SolidGroup::stress_at(const std::size_t element, const std::array<double, 3> &xi) const
  {
    if (section.formulation != SolidFormulation::b_bar)
      return stabilised_stress(element, xi);
    std::array<double, 6> result{}; // the trilinear field through the points, which lie at 1/sqrt(3)
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      {
        double shape = 1.;
        for (int k = 0; k < 3; ++k)
          shape *= 0.5 * (1. + 3. * xi[k] * b_bar_solid::coordinate(p, k));
        const auto stress = point_stress(element, std::size_t(p));
        for (int c = 0; c < 6; ++c)
          result[c] += shape / compute_volume_ratio(element, std::size_t(p)) * stress[c];
      }
    return result;
  }

  SolidStrength SolidGroup::compute_strength(const std::size_t element, const SolidFace &face) const
  {
    const std::size_t b = element / n_lanes, lane_of = element % n_lanes;
    SolidStrength     sum;
    const auto        add = [&](const double share, const double square, const double ratio, const auto &point) {
      sum.stress += share / ratio * std::max(std::sqrt(square), lane(point.yield, lane_of));
      sum.plastic_strain += share * lane(point.plastic_strain, lane_of);
    };
    const auto stress_of = [&](const std::size_t p, double(&stress)[6]) {
      const auto at = point_stress(element, p);
      std::copy(at.begin(), at.end(), stress);
    };
    double stress[6];
    if (section.formulation == SolidFormulation::b_bar)
      {
        for (std::size_t p = 0; p < n_points(); ++p)
          if (b_bar_solid::coordinate(int(p), int(face.axis)) * face.side > 0.)
            {
              stress_of(p, stress);
              add(0.25, von_mises_squared(stress), compute_volume_ratio(element, p), points[b * n_points() + p]);
            }
        return sum;
      }
    const auto   s     = take_stabilisation(element);
    const double ratio = compute_volume_ratio(element, 0);
    stress_of(0, stress);
    if (layers.empty() || layers[b].empty())
      {
        const one_point_solid::FlowSquares<double> varying(s);
        add(1., von_mises_squared(stress) + varying.trace + varying.shear + varying.last, ratio, points[b]);
        return sum;
      }
    const solid_shell::Squares<double> squares(s);
    const SolidModes<double>           x = modes(element);
    double                             mean[5];
    solid_shell::Frame<double>(x, one_point_solid::Axes<double>(x)).turn_in(stress, mean);
    const bool         is_skin   = axis_in_batch(element, face.axis) == 2;
    const unsigned int outermost = face.side < 0. ? 0 : rule.n - 1;
    for (unsigned int k = 0; k < rule.n; ++k)
      if (!is_skin || k == outermost)
        {
          const double z = rule.position[k];
          double       t[5];
          for (int c = 0; c < 5; ++c)
            t[c] = mean[c] + lane(layers[b][k].residual[c], lane_of) + (c < 3 ? z * s.linear[2][c] : 0.);
          const double square =
            0.25 * t[0] * t[0] + solid_shell::compute_rest(t) + squares.varying + z * z * squares.bent;
          add(is_skin ? 1. : 0.5 * rule.weight[k], square, ratio, layers[b][k]);
        }
    return sum;
  }

  Point3 SolidGroup::compute_normal(const std::size_t element, const SolidFace &face) const
  {
    const SolidModes<double> x = modes(element);
    const auto [i, j]          = following(int(axis_in_batch(element, face.axis)));
    return (x.linear[i] + face.side * x.twist[j]).cross(x.linear[j] + face.side * x.twist[i]).normalized();
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
    const auto [group, e] = find(element);
    return group.stress_at(e, {corner & 1 ? 1. : -1., corner & 2 ? 1. : -1., corner & 4 ? 1. : -1.});
  }

  SolidFaceState SolidElements::face_state(const std::size_t element, const SolidFace &face,
                                           const std::optional<double> given) const
  {
    const auto [group, e]       = find(element);
    std::array<double, 3> xi    = {0., 0., 0.};
    xi[face.axis]               = face.side;
    const SolidStrength carried = group.compute_strength(e, face);
    const auto          at      = group.stress_at(e, xi);
    const Point3        n       = group.compute_normal(e, face);
    const double        nn[6]   = {n[0] * n[0], n[1] * n[1], n[2] * n[2], n[0] * n[1], n[1] * n[2], n[2] * n[0]};
    double              stress[6], across = 0.;
    std::copy(at.begin(), at.end(), stress);
    for (int c = 0; c < 6; ++c)
      across += (c < 3 ? 1. : 2.) * nn[c] * stress[c];
    if (given)
      {
        for (int c = 0; c < 6; ++c)
          stress[c] += (*given - across) * nn[c];
        across = *given;
      }
    const double   q = von_mises(stress), f = q > carried.stress ? carried.stress / q : 1.;
    SolidFaceState state{{}, carried.plastic_strain};
    for (int c = 0; c < 6; ++c)
      state.stress[c] = f * stress[c] + (c < 3 ? (1. - f) * across : 0.);
    return state;
  }
} // namespace birdstrike
