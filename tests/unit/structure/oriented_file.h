#pragma once

#include "blade_case.h"
#include "mesh_writers.h"

#include <array>
#include <functional>
#include <random>

namespace birdstrike::test
{
  /// How a file lists a plate: which corner each cell begins at and about which axes it runs, the order of its cells
  /// and nodes, and where in space it stands.
  struct Listing
  {
    /// The order of a cell's corners, from those of the plate (quadrilaterals counter-clockwise, hexahedra by bits of
    /// span, chord and normal); called once a cell.
    std::function<std::vector<unsigned int>()> corners;
    unsigned int                               seed   = 0; ///< of the order of cells and nodes; 0: as they come
    Matrix3<double>                            turned = Matrix3<double>::Identity();
    MeshFormat                                 format = MeshFormat::gmsh;
    std::function<Point3(const Point3 &)>      shape{}; ///< of the plate, before it is turned; none: flat
  };

  /// The 24 rotations of a cube as orders of its corners.
  std::vector<std::vector<unsigned int>> rotations_of_a_cube();

  /// The plate of elastic_plate() as a file that lives as long as this object: quadrilaterals, or hexahedra in
  /// n_layers. Boundary ids 10 root, 11 tip, 12 and 13 the edges at -y and +y, 15 and 16 the faces at -z and +z.
  class PlateFile
  {
  public:
    PlateFile(const std::array<unsigned int, 3> &n, const Listing &listing);
    PlateFile(const PlateFile &) = delete;
    ~PlateFile();

    BladeParameters parameters() const;

  private:
    std::array<unsigned int, 3> n;
    Listing                     listing;
    std::mt19937                random;
    std::string                 path;
    std::vector<unsigned int>   number; ///< from 1
    ListedMesh                  mesh;

    unsigned int node(const std::array<unsigned int, 3> &i) const;
    void         shuffle(auto &list);
    void         add_nodes();
    void         add_sides(unsigned int d); ///< the boundary at both ends of a direction
    void         add_cells();
  };
} // namespace birdstrike::test
