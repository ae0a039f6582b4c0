#include "structure/histories/axes.h"
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

    const char *const axes_entry = "Output/Histories/Axes";

    /// Unit, of the facets at each node, by area, that look along a direction or against it, turned along it; zero at
    /// nodes without any.
    std::vector<Point3> find_nodal_normals(const SurfaceMesh &surface, const Point3 &towards)
    {
      constexpr double    least_cosine = 0.5; // facets of rims look elsewhere
      std::vector<Point3> normals(surface.nodes.size(), Point3::Zero());
      for (std::size_t f = 0; f < surface.cells.size(); ++f)
        {
          const Point3 area   = surface.area_vector(f);
          const double cosine = area.dot(towards) / area.norm();
          if (std::abs(cosine) > least_cosine)
            for (const std::uint32_t n : surface.cells[f])
              normals[n] += (cosine > 0. ? 1. : -1.) * area;
        }
      for (const std::uint32_t n : surface.symmetry_nodes) // with the mirror image
        normals[n][1] = 0.;
      for (Point3 &normal : normals)
        if (normal.norm() > 0.)
          normal.normalize();
      return normals;
    }

    /// Normals of the nodes at the nearest place of the surface, by its weights in its facet: continuous from facet to
    /// facet. Of facets that are equally near, as both faces of a body may be, the mean: their order has no say.
    Point3 interpolate_normal(const SurfaceMesh &surface, const std::vector<Point3> &normals, const Point3 &point)
    {
      constexpr double                  tie = 1e-9; // of the size of a facet: round-off of places
      std::vector<ClosestPoint<double>> closest;
      double                            smallest = INFINITY;
      for (const auto &cell : surface.cells)
        {
          std::array<Point3, 4> x;
          for (unsigned int k = 0; k < 4; ++k)
            x[k] = surface.node(cell[k]);
          closest.push_back(compute_closest_point(point, x));
          smallest = std::min(smallest, std::sqrt(closest.back().distance_squared));
        }
      Point3 sum = Point3::Zero();
      for (std::size_t f = 0; f < surface.cells.size(); ++f)
        if (std::sqrt(closest[f].distance_squared) <= smallest + tie * std::sqrt(surface.area_vector(f).norm()))
          for (unsigned int k = 0; k < 4; ++k)
            sum += closest[f].weights[k] * normals[surface.cells[f][k]];
      return sum;
    }

    /// Of root and tip by the share of the span.
    Point3 interpolate_normal(const BladeRoles &roles, const Point3 &point)
    {
      if (!roles.tip.is_present())
        return roles.root.normal;
      const Point3 way   = roles.tip.middle - roles.root.middle;
      const double share = std::clamp((point - roles.root.middle).dot(way) / way.squaredNorm(), 0., 1.);
      return ((1. - share) * roles.root.normal + share * roles.tip.normal).normalized();
    }
  } // namespace

  std::array<double, 6> Axes::of(const std::array<double, 6> &t) const
  {
    Matrix3<double> tensor;
    tensor << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
    const Matrix3<double> turned = rotation * tensor * rotation.transpose();
    std::array<double, 6> result;
    for (unsigned int k = 0; k < 6; ++k)
      result[k] = turned(pairs[k][0], pairs[k][1]);
    return result;
  }

  std::array<std::string, 6> Axes::tensor_names() const
  {
    std::array<std::string, 6> result;
    const bool                 is_short = names[0].size() == 1;
    for (unsigned int k = 0; k < 6; ++k)
      result[k] = names[pairs[k][0]] + (is_short ? "" : "-") + names[pairs[k][1]];
    return result;
  }

  Matrix3<double> find_blade_axes(const SurfaceMesh &surface, const BladeRoles &roles, const Point3 &point,
                                  const std::string &entry)
  {
    if (!roles.root.is_present())
      throw InputError(entry + " needs the axes of the blade, which follow from its root, and this blade has none.\n"
                               "Name the root in Blade/Supports/Clamped or Hub.");
    const Matrix3<double> turn = roles.turn_at(point);
    const Point3 towards = turn * interpolate_normal(roles, roles.centre + turn.transpose() * (point - roles.centre));
    Point3       there   = interpolate_normal(surface, find_nodal_normals(surface, towards), point);
    if (!surface.symmetry_nodes.empty() && point[1] == 0.)
      there[1] = 0.; // with the place of the other half that is as near
    const Point3 normal = there.norm() > 0. ? Point3(there.normalized()) : towards;
    Point3       way = turn * (roles.tip.is_present() ? Point3(roles.tip.middle - roles.root.middle) : roles.root.span);
    way -= way.dot(normal) * normal;
    const Point3    span = way.normalized();
    Matrix3<double> rows;
    rows << span.transpose(), roles.chord_at(normal, span).transpose(), normal.transpose();
    return rows;
  }

  Axes make_axes(const std::string &text, const SurfaceMesh &surface, const BladeRoles &roles, const Point3 &point)
  {
    if (text == "global")
      return {};
    if (text == "blade")
      return {find_blade_axes(surface, roles, point, std::string(axes_entry) + " = blade"),
              {{"span", "chord", "normal"}},
              "span, chord and normal of the undeformed blade there"};
    const auto   x = parse_numbers(text, 6, std::string(axes_entry) + " (global, blade, or six numbers)");
    const Point3 along(x[0], x[1], x[2]), third = along.cross(Point3(x[3], x[4], x[5]));
    if (!(third.norm() > 1e-6 * along.norm() * Point3(x[3], x[4], x[5]).norm()))
      throw InputError(std::string(axes_entry) + " = '" + text +
                       "': the two vectors are parallel or zero.\nGive a vector along axis 1 and another in the plane "
                       "of axes 1 and 2.");
    Axes axes;
    axes.rotation << along.normalized().transpose(), third.cross(along).normalized().transpose(),
      third.normalized().transpose();
    axes.names = {{"1", "2", "3"}};
    axes.text  = "axes of Output/Histories/Axes";
    return axes;
  }
} // namespace birdstrike
