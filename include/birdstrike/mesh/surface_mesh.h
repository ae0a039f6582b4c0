#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// A quadrilateral surface in plain arrays: what element kernels, contact and output need of a mesh.
  struct SurfaceMesh
  {
    /// An edge of the rim with the boundary id that the mesh gives it.
    struct BoundaryEdge
    {
      std::uint32_t                cell;
      unsigned int                 side; ///< between the cell's nodes side and side + 1 (mod 4)
      std::array<std::uint32_t, 2> nodes;
      unsigned int                 id;
    };

    std::vector<std::array<double, 3>>        nodes;        ///< m
    std::vector<std::array<std::uint32_t, 4>> cells;        ///< counter-clockwise about the surface normal
    std::vector<std::array<std::int32_t, 4>>  neighbors;    ///< cell across side k, or as FacetsView says
    std::vector<unsigned int>                 material_ids; ///< per cell
    std::vector<BoundaryEdge>                 rim;
    std::vector<std::uint32_t>                symmetry_nodes; ///< sorted, on the plane y = 0 where the mesh is cut
    std::vector<unsigned int>                 mirrored_ids;   ///< boundary ids that only the other half has

    Point3 node(std::size_t n) const;
    Point3 centroid(std::size_t cell) const;
    Point3 area_vector(std::size_t cell) const; ///< half the cross product of the diagonals, m^2
    double smallest_edge(std::size_t cell) const;

    /// Sorted nodes on rim edges that carry one of these boundary ids.
    std::vector<std::uint32_t> rim_nodes(const std::vector<unsigned int> &ids) const;
    bool                       has_boundary_id(unsigned int id) const;
    std::vector<unsigned int>  boundary_ids() const;

    /// Node closest to a point.
    std::uint32_t nearest_node(const Point3 &p) const;
  };

  /// Fills `neighbors` and turns cells so that neighbours agree on the normal (the first cell decides). Throws
  /// InputError if more than two cells share an edge, if the surface has only one side (Möbius), or if it falls into
  /// several pieces.
  void update_topology(SurfaceMesh &mesh);

  /// Turns all cells of a surface whose mean normal has the wrong sign (`sign_by_axes` z, y, x of orientation.h), so
  /// that which face is the upper one does not depend on the order in which a file lists nodes and cells. A closed
  /// surface, which has no mean normal, stays as it is. After update_topology.
  void face_upwards(SurfaceMesh &mesh);

  /// Takes the mesh as the half y >= 0 of a symmetric one: nodes within 1e-6 of its size are put on the plane, edges
  /// between them become symmetry edges. Throws InputError for nodes at y < 0, or none on the plane.
  void cut_at_symmetry_plane(SurfaceMesh &mesh);

  /// Throws InputError naming the first cell that is degenerate: a corner whose area is not positive about the cell's
  /// own normal (crossed or folded quadrilateral), or an edge of no length.
  void check_shape(const SurfaceMesh &mesh);
} // namespace birdstrike
