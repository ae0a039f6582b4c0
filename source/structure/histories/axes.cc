#include "structure/histories/axes.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/orientation.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

    const char *const axes_entry = "Output/Histories/Axes";

    /// Which of the nodes with a facet is nearest.
    std::uint32_t find_nearest(const SurfaceMesh &surface, const Point3 &point)
    {
      std::uint32_t nearest = surface.cells[0][0];
      for (const auto &cell : surface.cells)
        for (const std::uint32_t n : cell)
          if ((surface.node(n) - point).squaredNorm() < (surface.node(nearest) - point).squaredNorm())
            nearest = n;
      return nearest;
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
    constexpr double    least_cosine = 0.5; // facets of rims look elsewhere
    const Point3        towards      = interpolate_normal(roles, point);
    const std::uint32_t nearest      = find_nearest(surface, point);
    Point3              normal       = Point3::Zero();
    for (std::size_t f = 0; f < surface.cells.size(); ++f)
      if (std::find(surface.cells[f].begin(), surface.cells[f].end(), nearest) != surface.cells[f].end())
        {
          const Point3 area   = surface.area_vector(f);
          const double cosine = area.dot(towards) / area.norm();
          if (std::abs(cosine) > least_cosine)
            normal += (cosine > 0. ? 1. : -1.) * area;
        }
    normal     = normal.norm() > 0. ? Point3(normal.normalized()) : towards;
    Point3 way = roles.tip.is_present() ? Point3(roles.tip.middle - roles.root.middle) : roles.root.span;
    way -= way.dot(normal) * normal;
    const Point3    span = way.normalized();
    Matrix3<double> rows;
    rows << span.transpose(), chord_along(normal, span).transpose(), normal.transpose();
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
