#pragma once

#include <birdstrike/mesh/cell_mesh.h>

#include <vector>

namespace birdstrike
{
  /// A node that takes a share of a force.
  struct NodeShare
  {
    std::uint32_t node;
    double        weight;
  };

  /// The nodes among which a force at a place of a body is shared: those of the brick that holds the place, by its
  /// trilinear shape functions there. With sum N_i = 1 and sum N_i x_i = x, force and moment are those of the place. At
  /// a node this is the node alone. A place beside the body is taken at the nearest one, of the bricks at `nearest`,
  /// its nearest node.
  std::vector<NodeShare> share_force(const VolumeMesh &mesh, std::uint32_t nearest, const Point3 &place);
} // namespace birdstrike
