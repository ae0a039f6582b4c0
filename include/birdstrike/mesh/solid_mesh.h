#pragma once

#include <birdstrike/mesh/parameters.h>
#include <birdstrike/mesh/volume_mesh.h>

#include <memory>
#include <vector>

namespace birdstrike
{
  /// The blade as a body: a deal.II Triangulation<3> of hexahedra, from a built-in mid-surface that the thickness law
  /// extends by half its value to either side along the normal, or from a file, and on demand a DoFHandler with
  /// FE_Q(1)^3. Built-in parts keep the boundary ids of their shell (0 root, 1 tip, 2 leading edge, 3 trailing edge, 4
  /// plane of symmetry); the faces on the side of minus and plus the normal are 5 and 6.
  ///
  /// Throws InputError for a file that cannot be read or holds no hexahedra, for a thickness that is not positive, and
  /// for what `make_skin` and `check_shape` refuse. Hanging nodes and adaptive refinement are not offered.
  class SolidMesh
  {
  public:
    /// Lumped mass: row sums of the consistent matrix.
    struct Mass
    {
      std::vector<double> node;    ///< kg
      std::vector<double> element; ///< kg
      double              total = 0.;
    };

    /// Reads `mesh`, `thickness` and `is_halved` of the parameters: only y >= 0 is meshed, and the boundary y = 0 (id 4
    /// of the flat plate, which then has no face 2) is a plane of symmetry; a file is taken as this half already.
    explicit SolidMesh(const GeometryParameters &parameters);
    ~SolidMesh();

    /// Never changes after construction.
    const VolumeMesh &volume() const;

    /// Builds finite element and DoFs, numbered so that unknown c of node n is DoF 3n + c.
    void distribute_dofs();

    /// Row-sum lumping by 2x2x2 Gauss points, which integrate shape function times Jacobian of a trilinear cell
    /// exactly: m_i = int rho phi_i dV. `density` in kg/m^3. Needs DoFs.
    Mass compute_mass(double density) const;

  private:
    struct Grid;

    std::unique_ptr<Grid> grid;
    VolumeMesh            plain;
  };
} // namespace birdstrike
