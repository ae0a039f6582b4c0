#include "structure/implicit/free_unknowns.h"

#include <Eigen/Geometry>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// How far the director may lean out of what is left of held rotations to count as lying in it.
    constexpr double lies_in = 0.9;

    /// Axes of the rotations that are left of a node and do something.
    std::vector<Point3> rotation_axes(const std::array<bool, 3> &is_held, const Point3 &director)
    {
      std::vector<Point3> left;
      Point3              inside = Point3::Zero();
      for (unsigned int d = 0; d < 3; ++d)
        if (!is_held[d])
          {
            left.push_back(Point3::Unit(d));
            inside[d] = director[d];
          }
      if (inside.norm() < lies_in)
        return left;
      inside.normalize();
      std::vector<Point3> across; // Gram and Schmidt, the axis that leans least on the director first
      std::sort(left.begin(), left.end(),
                [&](const Point3 &a, const Point3 &b) { return std::abs(a.dot(inside)) < std::abs(b.dot(inside)); });
      left.pop_back();
      for (Point3 axis : left)
        {
          axis -= axis.dot(inside) * inside;
          for (const Point3 &other : across)
            axis -= axis.dot(other) * other;
          across.push_back(axis.normalized());
        }
      return across;
    }
  } // namespace

  FreeUnknowns::FreeUnknowns(const std::vector<bool> &is_held, const std::size_t n_nodes,
                             const std::span<const Point3> directors)
    : n_unknowns(directors.empty() ? 3 : 6)
  {
    for (std::uint32_t n = 0; n < n_nodes; ++n)
      {
        first.push_back(all.size());
        for (unsigned int d = 0; d < 3; ++d)
          if (!is_held[n_unknowns * n + d])
            all.push_back({n, false, Point3::Unit(d)});
        first_rotation.push_back(all.size());
        if (n_unknowns == 6)
          for (const Point3 &axis :
               rotation_axes({is_held[6 * n + 3], is_held[6 * n + 4], is_held[6 * n + 5]}, directors[n]))
            all.push_back({n, true, axis});
      }
    first.push_back(all.size());
  }

  void FreeUnknowns::expand(const std::span<const double> values, std::vector<double> &nodal) const
  {
    nodal.assign(n_unknowns * n_nodes(), 0.);
    for (std::size_t k = 0; k < all.size(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
        nodal[n_unknowns * all[k].node + (all[k].is_rotation ? 3 : 0) + d] += values[k] * all[k].axis[d];
  }

  void FreeUnknowns::restrict(const std::span<const double> nodal, std::vector<double> &forces) const
  {
    forces.resize(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      forces[k] = all[k].axis.dot(Point3(&nodal[n_unknowns * all[k].node + (all[k].is_rotation ? 3 : 0)]));
  }
} // namespace birdstrike
