#pragma once

#include <birdstrike/mesh/surface_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// A hexahedral body in plain arrays: what brick kernels, contact and output need of a mesh. Nodes on the skin come
  /// first, so that contact sees the nodes [0, n_skin_nodes) and no others.
  struct VolumeMesh
  {
    /// A face of the boundary with the id that the mesh gives it.
    struct BoundaryFace
    {
      std::uint32_t                cell;
      unsigned int                 face;  ///< of the cell, deal.II's order: -x +x -y +y -z +z of the reference cube
      std::array<std::uint32_t, 4> nodes; ///< counter-clockwise about the outward normal
      unsigned int                 id;
    };

    std::vector<std::array<double, 3>>        nodes; ///< m
    std::size_t                               n_skin_nodes = 0;
    std::vector<std::array<std::uint32_t, 8>> cells;          ///< lexicographic: node x + 2y + 4z of the reference cube
    std::vector<unsigned int>                 material_ids;   ///< per cell
    std::vector<BoundaryFace>                 faces;          ///< one for each facet of the skin, in its order
    std::vector<BoundaryFace>                 symmetry_faces; ///< in the plane y = 0 where the mesh is cut

    /// All faces but those in the symmetry plane; closed, or closed by its mirror image (`symmetry_edge` where it is
    /// cut). Its nodes are the first n_skin_nodes; it has no rim.
    SurfaceMesh skin;

    std::vector<std::uint32_t> symmetry_nodes; ///< sorted, on the plane y = 0 where the mesh is cut
    std::vector<unsigned int>  mirrored_ids;   ///< boundary ids that only the other half has

    /// Bricks through the thickness of a built-in part, along the third axis of each cell (from the face on the side
    /// of minus the mid-surface normal, id 5, to the other, id 6); 0 for a mesh from a file.
    unsigned int layers = 0;

    Point3 node(std::size_t n) const;
    Point3 centroid(std::size_t cell) const; ///< mean of the nodes, m
    double volume(std::size_t cell) const;   ///< of the trilinear cell, exact, m^3
    double smallest_edge(std::size_t cell) const;

    /// Sorted nodes on boundary faces that carry one of these ids.
    std::vector<std::uint32_t> nodes_on(const std::vector<unsigned int> &ids) const;
    bool                       has_boundary_id(unsigned int id) const;
    std::vector<unsigned int>  boundary_ids() const;

    /// Node closest to a point, inside or on the skin.
    std::uint32_t nearest_node(const Point3 &p) const;
  };

  /// Makes the skin of a body that has cells, `faces` (all of the boundary, in any order) and nodes in any order:
  /// renumbers nodes so that those of the skin come first, each group in the order in which the cells name them, and
  /// fills `skin`. If `is_halved`, takes the mesh as the half y >= 0 of a symmetric one: nodes within 1e-6 of its size
  /// are put on the plane, faces between them move to `symmetry_faces`.
  ///
  /// Throws InputError for cells that hang together by an edge or a corner only, a body in several pieces, nodes at
  /// y < 0, or no face on the plane.
  void make_skin(VolumeMesh &mesh, bool is_halved);

  /// Throws InputError naming the first cell whose Jacobian is not positive at one of its corners (folded, collapsed or
  /// inside out).
  void check_shape(const VolumeMesh &mesh);
} // namespace birdstrike
