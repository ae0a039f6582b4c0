#pragma once

#include <birdstrike/core/symmetry_plane.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// The views through which parts meet contact: it sees points and facets, never a bird or a blade, and adds its forces
/// to sinks that their owners hand over. Neither owns; both stay valid until the part changes its entities
/// (`revision`).
namespace birdstrike
{
  /// Soft points with mass, volume and a sound speed. Component arrays are contiguous (structure of arrays).
  struct PointsView
  {
    std::size_t                   n = 0;
    std::array<const double *, 3> position{};                       ///< m
    std::array<const double *, 3> velocity{};                       ///< m/s, at the half step
    const double                 *mass                   = nullptr; ///< kg
    const double                 *density                = nullptr; ///< kg/m^3
    const double                 *sound_speed            = nullptr; ///< m/s, at the present density
    const std::uint32_t          *id                     = nullptr; ///< persistent identity, < n_ids
    std::size_t                   n_ids                  = 0;       ///< one more than the largest id that ever existed
    double                        spacing                = 0.;      ///< m, cube root of a point's undeformed volume
    double                        undeformed_density     = 0.;      ///< kg/m^3
    double                        undeformed_sound_speed = 0.;      ///< m/s, as a strike sees it
    double                        hugoniot_slope = 0.; ///< s in p = rho c u (1 + s u/c), from the equation of state
    double                        shock_pressure = 0.; ///< over rho0 c0^2, of the speed at which they meet facets
    double                        strike_step    = 0.; ///< s, with which these points meet facets
    std::uint64_t                 revision       = 0;  ///< grows whenever points are re-ordered or removed
    SymmetryPlane                 plane;               ///< beyond which there are as many
  };

  /// Quadrilateral (or triangular: last node repeated) facets of a deformable or rigid surface.
  struct FacetsView
  {
    std::size_t   n_nodes         = 0;
    const double *position        = nullptr; ///< [n_nodes][3], m, current
    const double *velocity        = nullptr; ///< [n_nodes][velocity_stride], m/s, at the half step, translations first
    const double *inverse_mass    = nullptr; ///< [n_nodes], 1/kg; 0 where the node is held or rigid
    std::size_t   velocity_stride = 3;

    std::size_t                         n_facets  = 0;
    const std::array<std::uint32_t, 4> *nodes     = nullptr; ///< [n_facets], counter-clockwise about the facet normal
    const std::array<std::int32_t, 4>  *neighbor  = nullptr; ///< [n_facets], facet across edge (k, k+1 mod 4), or:
    static constexpr std::int32_t       free_edge = -1, symmetry_edge = -2; ///< nothing there; the facet's mirror image
    const double *half_thickness = nullptr; ///< [n_facets], m: material beyond the facet's surface
    bool          two_sided      = true;    ///< false for the skin of a solid: only the normal side is outside
    std::uint64_t revision       = 0;       ///< grows whenever facets appear or vanish
    SymmetryPlane plane;                    ///< beyond which there are as many
  };

  /// Contact forces on points, N, as `position` lies.
  struct PointForces
  {
    std::array<double *, 3> component{};
  };

  /// Contact forces on nodes, [n_nodes][stride], N: of an entry the three translations come first.
  struct NodeForces
  {
    double     *values = nullptr;
    std::size_t stride = 3;

    double *of(const std::size_t node) const
    {
      return values + stride * node;
    }
  };

  /// A force on one node.
  struct NodalForce
  {
    std::uint32_t         node = 0;
    std::array<double, 3> force{}; ///< N
  };
} // namespace birdstrike
