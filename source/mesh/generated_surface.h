#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/mesh/parameters.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <vector>

namespace birdstrike
{
  /// The mid-surface of a built-in blade: nodes on lines along the span (i = 0 at the root) and the chord (j = 0 at the
  /// leading edge, or on the plane of symmetry). Shell and solid are made of the same nodes.
  struct GeneratedSurface
  {
    unsigned int              n_span = 0, n_chord = 0;
    bool                      is_halved = false; ///< j = 0 lies on the plane y = 0 and carries id 4 instead of 2
    std::vector<Point3>       nodes;             ///< m, node (i, j) at i (n_chord + 1) + j
    std::vector<Point3>       normals;           ///< of length one, of the exact surface, not of the facets
    std::vector<unsigned int> material_ids;      ///< of the cell between lines i, i + 1 and j, j + 1: at i n_chord + j

    unsigned int node(const unsigned int i, const unsigned int j) const
    {
      return i * (n_chord + 1) + j;
    }
  };

  /// Throws InputError where the surface has no symmetric half, or laws are out of range.
  GeneratedSurface generate_surface(const MeshParameters &parameters, bool is_halved);

  /// Turns points about the axis of a row by one of its angles (rad).
  Point3 turn(const MeshParameters::Row &row, double angle, const Point3 &point);

  /// One quadrilateral between neighbouring lines; ids 0 root, 1 tip, 2 leading edge, 3 trailing edge, 4 symmetry.
  /// Cells, and those that follow, blade after blade of the row.
  void make_shell(const GeneratedSurface &surface, const MeshParameters::Row &row,
                  dealii::Triangulation<2, 3> &triangulation);

  /// Heights of the layers' boundaries over the mid-surface in thicknesses, from -0.5 to 0.5, symmetric about 0; the
  /// layers grow geometrically from the faces to the middle, grading = middle over outermost.
  std::vector<double> layer_heights(unsigned int n_layers, double grading);

  /// Bricks between neighbouring lines and layers: node = mid-surface node + height * thickness * normal. First axis of
  /// a cell along the span, second along the chord, third along the normal; faces at -1/2 and +1/2 carry ids 5 and 6.
  /// `thickness` (m) is asked at the mid-surface nodes.
  void make_solid(const GeneratedSurface &surface, const std::vector<double> &heights,
                  const std::function<double(const Point3 &)> &thickness, const MeshParameters::Row &row,
                  dealii::Triangulation<3> &triangulation);
} // namespace birdstrike
