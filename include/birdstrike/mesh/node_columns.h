#pragma once

#include <birdstrike/mesh/cell_mesh.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// The columns of a layered body: nodes that lie one above the other through the thickness, joined by the edges that
  /// cross the layers. Every node belongs to one column, every cell stands between four of them.
  ///
  /// Which way the thickness runs is found from the mesh alone: along the third axis of the cells of a built-in part;
  /// else along the shortest edges of the flattest cell, and from there over the faces to all others (an axis that lies
  /// in a face is the neighbour's too, one that crosses it goes on straight). Throws InputError where two ways lead to
  /// different axes of a cell, where columns branch, and where they close to rings: such a mesh has no layers.
  struct NodeColumns
  {
    explicit NodeColumns(const VolumeMesh &mesh);

    /// Place of the edge of a cell along its axis, 0..3: it joins nodes[place] and nodes[place + 1].
    std::uint32_t edge_place(const VolumeMesh &mesh, std::size_t cell, unsigned int edge) const;

    std::vector<unsigned int>  axis;  ///< per cell: 0, 1 or 2 of the reference cube runs through the thickness
    std::vector<std::uint32_t> nodes; ///< column by column, in the order of the column
    std::vector<std::uint32_t> begin; ///< [columns + 1], of each in `nodes`
    std::vector<std::uint32_t> place; ///< per node: where it is in `nodes`

  private:
    void find_axes(const VolumeMesh &mesh);
    void string_columns(const VolumeMesh &mesh);
  };
} // namespace birdstrike
