#pragma once

#include <birdstrike/mesh/parameters.h>
#include <birdstrike/mesh/surface_mesh.h>
#include <birdstrike/mesh/thickness_law.h>

#include <memory>
#include <vector>

namespace birdstrike
{
  /// The mid-surface: a deal.II Triangulation<2,3> from the built-in plate or from a file, and on demand a DoFHandler
  /// with FE_Q(1)^6. Nodes of `surface()` follow the vertices until `distribute_dofs` renumbers them so that the six
  /// unknowns of node n (ux uy uz rx ry rz) are DoFs 6n ... 6n+5.
  ///
  /// Throws InputError for a file that cannot be read, for cells that are not quadrilaterals, and for what
  /// `update_topology` and `check_shape` refuse. Hanging nodes and adaptive refinement are not offered.
  class ShellMesh
  {
  public:
    /// Lumped mass of the nodes and what the elements need of the thickness.
    struct Mass
    {
      std::vector<double> node;              ///< kg, row sums of the consistent matrix
      std::vector<double> element;           ///< kg
      std::vector<double> rotary;            ///< kg m^2, per node
      std::vector<double> element_thickness; ///< m, mean over the element's area
      double              total = 0.;        ///< kg
    };

    /// `is_halved`: only y >= 0 is meshed, and the boundary y = 0 (id 4 of the flat plate, which then has no edge 2) is
    /// a plane of symmetry; a file is taken as this half already.
    explicit ShellMesh(const MeshParameters &parameters, bool is_halved = false);
    ~ShellMesh();

    const SurfaceMesh &surface() const;

    /// Builds finite element and DoFs; asserts that a vertex' unknowns are contiguous.
    void distribute_dofs();

    /// Row-sum lumping by Gauss quadrature (2x2 points, exact for a flat element of constant thickness):
    ///   m_i = int rho t phi_i dA,    I_i = sum_e m_{i,e} max(t_e^2/12, A_e/8),
    /// the rotary inertia scaled so that bending never sets the step (Hughes, Cohen, Haroun 1978). Needs DoFs.
    Mass compute_mass(double density, const ThicknessLaw &thickness) const;

  private:
    struct Grid;
    void extract(const std::vector<std::uint32_t> &node_of_vertex);

    std::unique_ptr<Grid> grid;
    bool                  is_halved, is_generated;
    SurfaceMesh           plain;
  };
} // namespace birdstrike
