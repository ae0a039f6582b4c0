#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/mesh/file_notes.h>
#include <birdstrike/mesh/named_ids.h>
#include <birdstrike/mesh/node_space.h>
#include <birdstrike/mesh/open_seams.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Cells over the nodes of a NodeSpace in plain arrays: what element loops, contact and output need of a mesh.
  /// Quadrilaterals (dim 2) list their nodes counter-clockwise about the surface's normal, hexahedra (dim 3)
  /// lexicographically: node x + 2y + 4z of the reference cube. Sides of a quadrilateral are between nodes k and
  /// k + 1 (mod 4), those of a hexahedron deal.II's faces: -x +x -y +y -z +z of the reference cube.
  template <int dim>
  struct CellMesh
  {
    static constexpr unsigned int n_corners = 1u << dim, n_sides = 2 * dim;
    using Cell = std::array<std::uint32_t, n_corners>;

    /// A side on the boundary.
    struct BoundarySide
    {
      std::uint32_t                            cell;
      unsigned int                             side;
      std::array<std::uint32_t, n_corners / 2> nodes; ///< of a hexahedron counter-clockwise about the outward normal
      unsigned int                             id;    ///< that the mesh gives it
    };

    NodeSpace                                      space;
    std::vector<std::array<double, 3>>             nodes;         ///< m
    std::vector<std::int64_t>                      file_node_ids; ///< per node; empty: no file gives them
    std::vector<Cell>                              cells;
    std::vector<std::int64_t>                      file_element_ids; ///< per cell; empty: no file gives them
    std::size_t                                    n_owned_cells = 0;
    std::vector<std::array<std::int32_t, n_sides>> neighbors;      ///< cell across a side, or as FacetsView says
    std::vector<unsigned int>                      material_ids;   ///< per cell
    std::vector<std::uint32_t>                     blades;         ///< per cell, of a row; empty: one blade
    std::vector<BoundarySide>                      boundary;       ///< without
    std::vector<BoundarySide>                      symmetry_sides; ///< those in the plane y = 0 where the mesh is cut
    std::vector<std::uint32_t>                     symmetry_nodes; ///< sorted, of these sides
    std::vector<unsigned int>                      boundary_ids;   ///< sorted, of the whole mesh
    std::vector<unsigned int>                      mirrored_ids;   ///< boundary ids that only the other half has
    NamedIds                                       boundary_names, material_names{NamedIds::Of::materials};
    OpenSeams                                      open_seams; ///< of the whole mesh, if it is from a file
    FileNotes                                      file_notes; ///< of the mesh's file

    /// By which users know them: the ids of the mesh's file, else the place in these lists.
    std::int64_t node_label(const std::size_t n) const
    {
      return file_node_ids.empty() ? static_cast<std::int64_t>(n) : file_node_ids[n];
    }
    std::int64_t element_label(const std::size_t cell) const
    {
      return file_element_ids.empty() ? static_cast<std::int64_t>(cell) : file_element_ids[cell];
    }

    Point3 node(const std::size_t n) const
    {
      return Point3(nodes[n].data());
    }
    Point3 centroid(std::size_t cell) const; ///< mean of the nodes, m
    double smallest_edge(std::size_t cell) const;
    /// Nodes of a side in the order of BoundarySide.
    std::array<std::uint32_t, n_corners / 2> side_nodes(std::size_t cell, unsigned int side) const;

    /// Each cell is owned by one process, that of its node with the smallest global number.
    bool              is_owned(std::size_t cell) const;
    std::vector<bool> owned_cells() const; ///< is_owned of each

    /// Owned nodes, sorted, on boundary sides that carry one of these ids.
    std::vector<std::uint32_t> nodes_on(const std::vector<unsigned int> &ids) const;
    bool                       has_boundary_id(unsigned int id) const;

    /// Of a row of blades, 0 the one that is described.
    std::uint32_t blade_of(const std::size_t cell) const
    {
      return blades.empty() ? 0 : blades[cell];
    }

    /// Takes the mesh as the half y >= 0 of a symmetric one: boundary sides whose nodes all have y = 0 move to
    /// `symmetry_sides`. Throws InputError if there is none.
    void cut_at_symmetry_plane();
  };

  extern template struct CellMesh<2>;
  extern template struct CellMesh<3>;

  /// A surface: the mid-surface of a shell, or the skin of a solid.
  struct SurfaceMesh : CellMesh<2>
  {
    Point3 area_vector(std::size_t cell) const; ///< half the cross product of the diagonals, m^2
  };

  /// A body. Nodes on the skin come first if the mesh is whole, so that contact sees the nodes [0, n_skin_nodes) and no
  /// others.
  struct VolumeMesh : CellMesh<3>
  {
    std::size_t n_skin_nodes = 0;

    /// `boundary` as a surface of its own, facet by facet: closed, or closed by its mirror image (`symmetry_edge` where
    /// it is cut). It has no boundary.
    SurfaceMesh skin;

    /// Bricks through the thickness of a built-in part, along the third axis of each cell (from the face on the side
    /// of minus the mid-surface normal, id 5, to the other, id 6); 0 for a mesh from a file.
    unsigned int layers = 0;
  };

  /// Area of a side of a hexahedron along its normal, m^2; and its middle, m.
  Point3 area_vector(const VolumeMesh &mesh, const VolumeMesh::BoundarySide &side);
  Point3 middle(const VolumeMesh &mesh, const VolumeMesh::BoundarySide &side);
} // namespace birdstrike
