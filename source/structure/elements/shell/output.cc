#include "structure/elements/shell/implementation.h"

#include <algorithm>

namespace birdstrike
{
  std::size_t ShellElements::n_elements() const
  {
    return implementation->cells.size();
  }
  std::size_t ShellElements::n_promoted() const
  {
    std::size_t n = 0;
    for (std::size_t e = 0; e < n_elements(); ++e)
      n += implementation->has_points(e / n_lanes);
    return n;
  }

  namespace
  {
    template <class Vector>
    std::size_t bytes_of(const Vector &v)
    {
      return v.capacity() * sizeof(typename Vector::value_type);
    }
  } // namespace

  std::size_t ShellElements::bytes() const
  {
    const Implementation &my = *implementation;

    std::size_t sum = bytes_of(my.cells) + bytes_of(my.mass) + bytes_of(my.corner_begin) + bytes_of(my.corners) +
                      bytes_of(my.blocks) + bytes_of(my.irregular) + bytes_of(my.entering) + bytes_of(my.leaving) +
                      bytes_of(my.records) + bytes_of(my.corner_force) + bytes_of(my.node_force) + bytes_of(my.work) +
                      bytes_of(my.batches) + bytes_of(my.chunks) + bytes_of(my.stress) + bytes_of(my.sections) +
                      bytes_of(my.points);
    for (const auto &of_section : my.points)
      sum += bytes_of(of_section);
    if (my.erosion)
      {
        sum += bytes_of(my.erosion->batches) + bytes_of(my.erosion->damage) + bytes_of(my.erosion->entering_of) +
               bytes_of(my.erosion->n_left);
        for (const auto &of_section : my.erosion->damage)
          sum += bytes_of(of_section);
      }
    return sum;
  }

  namespace
  {
    unsigned int point_of(const ShellLayer layer, const unsigned int n)
    {
      return layer == ShellLayer::bottom ? 0 : layer == ShellLayer::middle ? n / 2 : n - 1;
    }
  } // namespace

  ShellState ShellElements::state(const std::size_t element) const
  {
    const Implementation &my = *implementation;
    const std::size_t     b = element / n_lanes, k = element % n_lanes;
    const double          share = 1. / double(my.n_in_plane);
    ShellState            state{};
    if (my.is_failed(element)) // its nodes may lie anywhere
      state.axes.setIdentity();
    else
      {
        const ShellGeometry<double> g = my.geometry(element);
        state.axes << g.compute_e1(), g.compute_e2(), g.e3;
      }
    for (std::size_t i = 0; i < my.n_in_plane; ++i)
      {
        const auto  &s = my.section_of(b, i);
        const double t = lane(s.thickness, k);
        for (int c = 0; c < 3; ++c)
          {
            state.membrane_force[c] += share * t * lane(s.mean[c], k);
            state.moment[c] += share * t * t / 6. * lane(s.outer[c], k);
          }
        for (int c = 0; c < 2; ++c)
          state.shear_force[c] += share * t * lane(s.shear[c], k);
        state.thickness += share * t;
        for (const auto &point : my.points_of(b, i))
          state.max_plastic_strain = std::max(state.max_plastic_strain, lane(point.plastic_strain, k));
      }
    return state;
  }

  std::array<double, 3> ShellElements::layer_stress(const std::size_t element, const ShellLayer layer) const
  {
    const Implementation &my = *implementation;
    const std::size_t     b = element / n_lanes, k = element % n_lanes;
    const double          share = 1. / double(my.n_in_plane);
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < my.n_in_plane; ++i)
      {
        const auto &points = my.points_of(b, i);
        const auto &s      = my.section_of(b, i);
        for (int c = 0; c < 3; ++c)
          if (points.empty())
            result[c] += share * (lane(s.mean[c], k) + (int(layer) - 1) * lane(s.outer[c], k));
          else
            result[c] += share * lane(points[point_of(layer, points.size())].stress[c], k);
      }
    return result;
  }

  std::array<double, 6> ShellElements::global_layer_stress(const std::size_t element, const ShellLayer layer) const
  {
    if (implementation->is_failed(element))
      return {};
    const auto                  s  = layer_stress(element, layer);
    const ShellGeometry<double> g  = implementation->geometry(element);
    const Point3                e1 = g.compute_e1(), e2 = g.compute_e2();
    const Matrix3<double>       S =
      s[0] * e1 * e1.transpose() + s[1] * e2 * e2.transpose() + s[2] * (e1 * e2.transpose() + e2 * e1.transpose());
    return {S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0)};
  }

  std::array<double, 2> ShellElements::outer_stresses_along(const std::size_t element, const Point3 &direction) const
  {
    if (implementation->is_failed(element))
      return {};
    const ShellGeometry<double> g = implementation->geometry(element);
    const double                a = direction.dot(g.compute_e1()), b = direction.dot(g.compute_e2());
    std::array<double, 2>       result;
    for (const ShellLayer layer : {ShellLayer::bottom, ShellLayer::top})
      {
        const auto s                     = layer_stress(element, layer);
        result[layer == ShellLayer::top] = (s[0] * a * a + s[1] * b * b + 2. * s[2] * a * b) / (a * a + b * b);
      }
    return result;
  }

  double ShellElements::layer_plastic_strain(const std::size_t element, const ShellLayer layer) const
  {
    double largest = 0.;
    for (std::size_t i = 0; i < implementation->n_in_plane; ++i)
      if (const auto &points = implementation->points_of(element / n_lanes, i); !points.empty())
        largest = std::max(largest, lane(points[point_of(layer, points.size())].plastic_strain, element % n_lanes));
    return largest;
  }

  ShellElements::MaxPlasticStrain ShellElements::max_plastic_strain() const
  {
    MaxPlasticStrain result;
    for (std::size_t e = 0; e < n_elements(); ++e)
      for (std::size_t i = 0; i < implementation->n_in_plane; ++i)
        for (const auto &point : implementation->points_of(e / n_lanes, i))
          if (lane(point.plastic_strain, e % n_lanes) > result.value)
            result = {lane(point.plastic_strain, e % n_lanes), e};
    return result;
  }
} // namespace birdstrike
