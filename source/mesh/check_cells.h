#pragma once

#include <birdstrike/mesh/cell_mesh.h>

#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// Moves vertices within 1e-6 of the mesh's size to the plane y = 0 onto it. Throws InputError for one beyond.
  template <int dim>
  void put_on_symmetry_plane(dealii::Triangulation<dim, 3> &triangulation);

  /// Throws InputError naming the first cell that is degenerate: whose Jacobian (of a surface: the area vector about
  /// the cell's own) is not positive at one of its corners: folded, crossed, collapsed or inside out.
  template <int dim>
  void check_cells(const dealii::Triangulation<dim, 3> &triangulation);

  /// Throws InputError if a mesh falls into several pieces, or if a surface has only one side (Moebius). `neighbors`
  /// must be known.
  template <int dim>
  void check_connection(const CellMesh<dim> &mesh);

  /// Throws InputError for an edge of a body's skin that more than two of its quadrilaterals share.
  [[noreturn]] void refuse_edge(const Point3 &place);
} // namespace birdstrike
