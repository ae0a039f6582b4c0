#pragma once

#include <birdstrike/core/number.h>

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace birdstrike::test
{
  enum class MeshFormat
  {
    gmsh,
    abaqus,
    ls_dyna
  };

  /// Quadrilaterals or hexahedra, and named sides of their boundary, as a file lists them: ids from 1, corners round
  /// the faces.
  struct ListedMesh
  {
    struct Side
    {
      unsigned int              id;
      std::vector<unsigned int> nodes;
    };
    std::vector<Point3>                    nodes;
    std::vector<std::vector<unsigned int>> cells;
    std::vector<Side>                      sides;
    std::map<unsigned int, std::string>    names; ///< of sides

    bool                   is_solid() const;
    std::set<unsigned int> nodes_on(unsigned int id) const;
  };

  /// Format 2.2, sides as elements.
  void write_gmsh(std::ostream &out, const ListedMesh &mesh);
  /// Sides as node sets.
  void write_abaqus(std::ostream &out, const ListedMesh &mesh);
  /// Nodes between commas, which keep all their digits, the rest in columns; sides as node sets, of bricks as segments.
  void write_ls_dyna(std::ostream &out, const ListedMesh &mesh);
} // namespace birdstrike::test
