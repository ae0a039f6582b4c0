#include "structure/elements/shell/elements.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  void ShellGroup::promote(const std::size_t k)
  {
    points[k].resize(law.rule.n);
    law.promote(n_in_plane == 1 ? stress[k] : sections[k], points[k].data());
  }

  void ShellGroup::suspend_flow(const bool is_suspended)
  {
    law.hardening = is_suspended ? hardening_without_flow() : section.material.hardening;
    initial_yield = law.initial_yield();
    for (auto &of_section : points)
      for (ShellPoint<Lanes> &point : of_section)
        point.yield = initial_yield;
  }

  const SectionStress<Lanes> &ShellGroup::section_of(const std::size_t batch, const std::size_t k) const
  {
    return n_in_plane == 1 ? stress[batch] : sections[n_in_plane * batch + k];
  }

  const AlignedVector<ShellPoint<Lanes>> &ShellGroup::points_of(const std::size_t batch, const std::size_t k) const
  {
    return points[n_in_plane * batch + k];
  }

  bool ShellGroup::has_points(const std::size_t batch) const
  {
    bool has = bool(laminate); // they need none
    for (std::size_t k = 0; k < n_in_plane; ++k)
      has = has || !points_of(batch, k).empty();
    return has;
  }

  std::size_t ShellGroup::count_yielded(const std::size_t batch) const
  {
    if (laminate)
      return n_elements_of(batch);
    Lanes strain(0.);
    for (std::size_t k = 0; k < n_in_plane; ++k)
      if (const auto &of_section = points_of(batch, k); !of_section.empty())
        strain += of_section.front().plastic_strain + of_section.back().plastic_strain;
    return count_positive(strain, batch);
  }

  double ShellGroup::largest_thickness(const std::size_t element) const
  {
    double largest = 0.;
    for (std::size_t k = 0; k < n_in_plane; ++k)
      largest = std::max(largest, lane(section_of(element / n_lanes, k).thickness, element % n_lanes));
    return largest;
  }

  double ShellGroup::largest_plastic_strain(const std::size_t element) const
  {
    double largest = 0.;
    for (std::size_t i = 0; i < n_in_plane; ++i)
      for (const auto &point : points_of(element / n_lanes, i))
        largest = std::max(largest, lane(point.plastic_strain, element % n_lanes));
    return largest;
  }

  std::size_t ShellGroup::bytes() const
  {
    std::size_t sum =
      bytes_of_group() + bytes_of(points) + bytes_of(stress) + bytes_of(sections) + (laminate ? laminate->bytes() : 0);
    for (const auto &of_section : points)
      sum += bytes_of(of_section);
    return sum;
  }

  namespace
  {
    unsigned int point_of(const ShellLayer layer, const unsigned int n)
    {
      return layer == ShellLayer::bottom ? 0 : layer == ShellLayer::middle ? n / 2 : n - 1;
    }

    unsigned int nearest_point(const ThicknessPoints &rule, const double height)
    {
      unsigned int nearest = 0;
      for (unsigned int k = 1; k < rule.n; ++k)
        if (std::abs(rule.position[k] - height) < std::abs(rule.position[nearest] - height))
          nearest = k;
      return nearest;
    }
  } // namespace

  ShellState ShellElements::state(const std::size_t element) const
  {
    const auto [group, e] = find(element);
    const std::size_t b = e / n_lanes, k = e % n_lanes;
    const double      share = 1. / double(group.n_in_plane);
    ShellState        state{};
    if (group.is_failed(e)) // its nodes may lie anywhere
      state.axes.setIdentity();
    else
      {
        const ShellGeometry<double> g = group.geometry(e);
        state.axes << g.compute_e1(), g.compute_e2(), g.e3;
      }
    for (std::size_t i = 0; i < group.n_in_plane; ++i)
      {
        const auto &s = group.section_of(b, i);
        const auto  r = compute_resultants(s, group.contraction(b, i));
        for (int c = 0; c < 3; ++c)
          {
            state.membrane_force[c] += share * lane(r.membrane[c], k);
            state.moment[c] += share * lane(r.curvature[c], k);
          }
        for (int c = 0; c < 2; ++c)
          state.shear_force[c] += share * lane(r.shear[c], k);
        state.thickness += share * lane(s.thickness, k);
        for (const auto &point : group.points_of(b, i))
          state.max_plastic_strain = std::max(state.max_plastic_strain, lane(point.plastic_strain, k));
      }
    return state;
  }

  std::array<double, 3> ShellElements::layer_stress(const std::size_t element, const ShellLayer layer) const
  {
    const auto [group, e]   = find(element);
    const std::size_t     b = e / n_lanes, k = e % n_lanes;
    const double          share = 1. / double(group.n_in_plane);
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < group.n_in_plane; ++i)
      {
        const auto        &points = group.points_of(b, i);
        const auto        &s      = group.section_of(b, i);
        const unsigned int point  = point_of(layer, group.rule().n); // also of a section that keeps none yet
        const double       cauchy = share * lane(group.contraction(b, i), k);
        if (group.laminate)
          {
            const auto of_ply = group.ply_stress(e, i, int(layer) - 1.);
            for (int c = 0; c < 3; ++c)
              result[c] += cauchy * of_ply[c];
            continue;
          }
        for (int c = 0; c < 3; ++c)
          if (points.empty())
            result[c] += cauchy * (lane(s.mean[c], k) + group.rule().position[point] * lane(s.outer[c], k));
          else
            result[c] += cauchy * lane(points[point].stress[c], k);
      }
    return result;
  }

  std::array<double, 6> ShellElements::global_layer_stress(const std::size_t element, const ShellLayer layer) const
  {
    if (is_failed(element))
      return {};
    const auto s                   = layer_stress(element, layer);
    const auto [group, e]          = find(element);
    const ShellGeometry<double> g  = group.geometry(e);
    const Point3                e1 = g.compute_e1(), e2 = g.compute_e2();
    const Matrix3<double>       S =
      s[0] * e1 * e1.transpose() + s[1] * e2 * e2.transpose() + s[2] * (e1 * e2.transpose() + e2 * e1.transpose());
    return {S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0)};
  }

  std::array<double, 2> ShellElements::outer_stresses_along(const std::size_t element, const Point3 &direction) const
  {
    if (is_failed(element))
      return {};
    const auto [group, e]         = find(element);
    const ShellGeometry<double> g = group.geometry(e);
    const double                a = direction.dot(g.compute_e1()), b = direction.dot(g.compute_e2());
    std::array<double, 2>       result;
    for (const ShellLayer layer : {ShellLayer::bottom, ShellLayer::top})
      {
        const auto s                     = layer_stress(element, layer);
        result[layer == ShellLayer::top] = (s[0] * a * a + s[1] * b * b + 2. * s[2] * a * b) / (a * a + b * b);
      }
    return result;
  }

  const ThicknessPoints &ShellElements::thickness_points(const std::size_t element) const
  {
    return find(element).first.rule();
  }

  double ShellElements::nearest_height(const std::size_t element, const double layer) const
  {
    const ShellGroup &group = find(element).first;
    return group.laminate ? layer : group.rule().position[nearest_point(group.rule(), layer)];
  }

  const Laminate *ShellElements::laminate(const std::size_t element) const
  {
    const ShellGroup &group = find(element).first;
    return group.laminate ? group.laminate->law.get() : nullptr;
  }

  ShellPointState ShellElements::point_state(const std::size_t element, const double height) const
  {
    ShellPointState state{{}, 0., 0.};
    const auto [group, e] = find(element);
    const std::size_t  b = e / n_lanes, k = e % n_lanes;
    const double       share = 1. / double(group.n_in_plane);
    const unsigned int point = nearest_point(group.rule(), height);
    const Elasticity  &law   = group.section.material.elasticity;
    Matrix3<double>    s     = Matrix3<double>::Zero(); // in the element's axes
    for (std::size_t i = 0; i < group.n_in_plane; ++i)
      {
        const auto &points  = group.points_of(b, i);
        const auto &section = group.section_of(b, i);
        Point3      plane   = Point3::Zero(); // xx, yy, xy, Kirchhoff's
        if (group.laminate)
          plane = group.ply_stress(e, i, height);
        for (int c = 0; c < 3 && !group.laminate; ++c)
          plane[c] = points.empty() ? lane(section.mean[c], k) + height * lane(section.outer[c], k)
                                    : lane(points[point].stress[c], k);
        const double    shear[2] = {lane(section.shear[0], k), lane(section.shear[1], k)};
        Matrix3<double> of_section;
        of_section << plane[0], plane[2], shear[0], plane[2], plane[1], shear[1], shear[0], shear[1], 0.;
        s += share * lane(group.contraction(b, i), k) * of_section;
        if (!points.empty())
          state.plastic_strain += share * lane(points[point].plastic_strain, k);
        if (!group.laminate)
          state.volume_strain += share * (1. - 2. * law.poisson) / law.young * (plane[0] + plane[1]);
      }
    if (is_failed(element)) // its nodes may lie anywhere
      return state;
    const Matrix3<double> axes = this->state(element).axes, S = axes * s * axes.transpose();
    state.stress = {S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0)};
    return state;
  }

  double ShellElements::layer_plastic_strain(const std::size_t element, const ShellLayer layer) const
  {
    const auto [group, e] = find(element);
    double largest        = 0.;
    for (std::size_t i = 0; i < group.n_in_plane; ++i)
      if (const auto &points = group.points_of(e / n_lanes, i); !points.empty())
        largest = std::max(largest, lane(points[point_of(layer, group.rule().n)].plastic_strain, e % n_lanes));
    return largest;
  }
} // namespace birdstrike
