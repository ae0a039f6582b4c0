#include "structure/histories/gauges.h"
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>

#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    /// Whether the blade's normal, away from the struck side, is that of a shell's mesh.
    bool is_turned(const BladeRoles &roles, const std::string &entry)
    {
      for (const BladeEnd *end : {&roles.tip, &roles.root})
        if (end->is_present())
          return end->is_turned;
      throw InputError(entry + ": this blade has neither root nor tip, so its struck face is not known.\nGive the face "
                               "as top or bottom, or name root and tip in Blade/Supports.");
    }
  } // namespace

  ShellFaces::ShellFaces(const WatchedBlade<ShellKind> &blade)
    : blade(blade), directors(blade.mesh, blade.elements, blade.motion)
  {
  }

  void ShellFaces::add(const Place &place, const GaugeFace face, const std::string &entry, Warnings &warnings)
  {
    directors.add(find_element(blade.mesh, place, entry, warnings));
    if (face == GaugeFace::top || face == GaugeFace::bottom)
      zeta.push_back(face == GaugeFace::top ? 1. : -1.);
    else
      zeta.push_back((face == GaugeFace::other) != is_turned(blade.roles, entry) ? 1. : -1.);
  }

  std::array<Point3, 4> ShellFaces::corners_at_rest(const std::size_t k) const
  {
    return directors.corners_at_rest(k, zeta[k]);
  }

  std::array<Point3, 4> ShellFaces::corners(const std::size_t k) const
  {
    return directors.corners(k, zeta[k]);
  }

  bool ShellFaces::is_failed(const std::size_t k) const
  {
    return blade.elements.is_failed(directors.element(k));
  }

  SolidFaces::SolidFaces(const WatchedBlade<SolidKind> &blade) : blade(blade)
  {
  }

  void SolidFaces::add(const Place &place, const GaugeFace face, const std::string &entry, Warnings &warnings)
  {
    if (face == GaugeFace::top || face == GaugeFace::bottom)
      throw InputError(entry + ": '" + place.name + "' is on the top or bottom of bricks.\nAllowed: struck or other.");
    constexpr double least_cosine = 0.5; // facets of rims look elsewhere
    const Point3     normal       = find_blade_axes(blade.mesh.skin, blade.roles, place.point, entry).row(2);
    const double     side         = face == GaugeFace::other ? 1. : -1.;
    double           nearest      = std::numeric_limits<double>::infinity();
    std::uint32_t    found        = 0;
    for (std::uint32_t f = 0; f < blade.mesh.boundary.size(); ++f)
      {
        const auto &of = blade.mesh.boundary[f];
        if (side * area_vector(blade.mesh, of).normalized().dot(normal) < least_cosine)
          continue;
        std::array<Point3, 4> x;
        for (unsigned int k = 0; k < 4; ++k)
          x[k] = blade.mesh.node(of.nodes[k]);
        if (const double distance = compute_closest_point(place.point, x).distance_squared; distance < nearest)
          {
            nearest = distance;
            found   = f;
          }
      }
    find_element(blade.mesh, place, entry, warnings); // for its warning
    facet.push_back(found);
  }

  std::array<Point3, 4> SolidFaces::corners_at_rest(const std::size_t k) const
  {
    std::array<Point3, 4> x;
    for (unsigned int c = 0; c < 4; ++c)
      x[c] = blade.mesh.node(blade.mesh.boundary[facet[k]].nodes[c]);
    return x;
  }

  std::array<Point3, 4> SolidFaces::corners(const std::size_t k) const
  {
    std::array<Point3, 4> x;
    for (unsigned int c = 0; c < 4; ++c)
      x[c] = Point3(blade.motion.positions() + 3 * blade.mesh.boundary[facet[k]].nodes[c]);
    return x;
  }

  bool SolidFaces::is_failed(const std::size_t k) const
  {
    return blade.elements.is_failed(blade.mesh.boundary[facet[k]].cell);
  }
} // namespace birdstrike
