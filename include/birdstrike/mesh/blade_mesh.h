#pragma once

#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/mesh/density_law.h>
#include <birdstrike/mesh/parameters.h>
#include <birdstrike/mesh/thickness_law.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace birdstrike
{
  /// The mesh of a blade: a deal.II Triangulation<dim,3> and a DoFHandler with FE_Q(1)^n_unknowns on it, and what a
  /// process has of it in plain arrays. dim 2 is the mid-surface of a shell (ux uy uz rx ry rz), dim 3 a body (ux uy
  /// uz), which a built-in part makes of its mid-surface by half the thickness to either side along the normal. Both
  /// have the boundary ids 0 root, 1 tip, 2 leading edge, 3 trailing edge; the body also 5 and 6, its faces on the side
  /// of minus and plus the normal. With `is_halved` only y >= 0 is meshed, and y = 0 (id 4 of the flat plate, which
  /// then has no side 2) is a plane of symmetry; a file is taken as this half already, its nodes within 1e-6 of the
  /// size are put on the plane.
  ///
  /// Nodes are numbered as deal.II numbers the DoFs of the vertices, those of a body's skin first. Quadrilaterals of a
  /// file are turned to agree on a normal that looks up (`sign_by_axes` z, y, x of orientation.h) whatever their order
  /// in the file; a closed surface keeps that of its first cell.
  ///
  /// Throws InputError for a file that cannot be read, a thickness that is not positive, cells that are degenerate or
  /// of another kind, several pieces, shells that branch or have one side only, bodies whose cells touch along an edge
  /// only, nodes at y < 0 or no side at y = 0 of a half. Hanging nodes and adaptive refinement are not offered.
  template <int dim>
  class BladeMesh : public std::conditional_t<dim == 2, SurfaceMesh, VolumeMesh>
  {
  public:
    static constexpr unsigned int n_unknowns = dim == 2 ? 6 : 3; ///< of a node

    /// Lumped mass: row sums of the consistent matrix. Ghosts that no owned cell has lack cells that are not here.
    struct Mass
    {
      std::vector<double> node;              ///< kg
      std::vector<double> element;           ///< kg
      std::vector<double> rotary;            ///< kg m^2, per node of a shell
      std::vector<double> element_thickness; ///< m, mean over the area of a shell's element
      std::size_t         n_given = 0;       ///< elements of a shell whose thickness the file or a table gives
      double              total   = 0.;      ///< kg, of the cells that are owned
    };

    explicit BladeMesh(const GeometryParameters &parameters);

    /// What a process has that owns these nodes, a range of global numbers: cells that touch them, and cells that touch
    /// these (masses, and normals of a shell, at ghosts need them). The triangulation is shared.
    BladeMesh part(std::uint32_t first, std::uint32_t last) const;

    /// Row sums by two Gauss points in each direction, exact for a trilinear cell and a flat element of constant
    /// thickness:
    ///   m_i = int rho t phi_i dA or int rho phi_i dV,    I_i = sum_e m_{i,e} max(t_e^2/12, A_e/8),
    /// the rotary inertia of a shell scaled so that bending never sets the step (Hughes, Cohen, Haroun 1978).
    /// A body has no use for a thickness. What is given at nodes goes before what the file says of the corners of an
    /// element; between them it is bilinear.
    Mass compute_mass(const DensityLaw &density, const ThicknessLaw &thickness = {},
                      const NodalThickness &nodal = {}) const;

    /// The facets that contact meets.
    const SurfaceMesh &surface() const
    {
      if constexpr (dim == 2)
        return *this;
      else
        return this->skin;
    }

    /// The node closest to a point, unless another process owns it; of equals the first of the mesh's vertices.
    std::optional<std::uint32_t> nearest_node(const Point3 &p, bool only_on_boundary = false) const;

  private:
    struct Grid;

    BladeMesh() = default;
    void extract(std::uint32_t first, std::uint32_t last);
    void face_upwards(const std::string &top);

    std::shared_ptr<Grid> grid;
  };

  using ShellMesh = BladeMesh<2>;
  using SolidMesh = BladeMesh<3>;
} // namespace birdstrike
