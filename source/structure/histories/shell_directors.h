#pragma once

#include "structure/shell_kind.h"

#include <array>
#include <vector>

namespace birdstrike
{
  /// Fibres through the thickness of some shells, one at each corner: normal to the undeformed element, turned since by
  /// the rotation increments of the nodes, d <- exp(dtheta) d. With them a layer at zeta in [-1, 1] has the corners
  ///   x_a + zeta t/2 d_a,   t the present thickness,
  /// whose change is the membrane strain and zeta t/2 times that of curvature, as the element has them.
  class ShellDirectors
  {
  public:
    ShellDirectors(const ShellMesh &mesh, const ShellElements &elements, const NodalMechanics<6> &motion);

    std::size_t add(std::uint32_t element); ///< returns its number here

    void follow();
    void archive(Archive &archive);

    std::array<Point3, 4> corners_at_rest(std::size_t k, double zeta) const; ///< m
    std::array<Point3, 4> corners(std::size_t k, double zeta) const;         ///< m, now
    /// F at the middle of the element, dx/dX by the base vectors of layer and fibre; the fibre keeps its length, or
    /// stretches at the layer so that ln det F is the volume strain.
    Matrix3<double> deformation_gradient(std::size_t k, double zeta) const;
    Matrix3<double> deformation_gradient(std::size_t k, double zeta, double volume_strain) const;
    std::uint32_t   element(std::size_t k) const
    {
      return watched[k].element;
    }

  private:
    struct Watched
    {
      std::uint32_t         element;
      double                thickness;          ///< m, at rest
      Point3                normal;             ///< at rest
      std::array<Point3, 4> director, rotation; ///< rotation: sum of the increments that the director has followed, rad
    };
    const ShellMesh         &mesh;
    const ShellElements     &elements;
    const NodalMechanics<6> &motion;
    std::vector<Watched>     watched;
  };
} // namespace birdstrike
