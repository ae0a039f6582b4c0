#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/node_columns.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>

namespace birdstrike
{
  namespace
  {
    constexpr unsigned int  unknown = 3;
    constexpr std::uint32_t none    = std::numeric_limits<std::uint32_t>::max();

    [[noreturn]] void refuse(const std::string &what, const Point3 &at)
    {
      char where[96];
      std::snprintf(where, sizeof where, "(%.4g, %.4g, %.4g) m", at[0], at[1], at[2]);
      throw InputError("Blade/Mass scaling/Method: 'selective' needs a mesh in layers, but " + what + " at " + where +
                       ".\nSet Method = off, or mesh the blade in layers through its thickness.");
    }

    /// Corners of an edge along an axis: the four pairs that differ in this coordinate alone.
    std::array<unsigned int, 2> corners_of_edge(const unsigned int axis, const unsigned int edge)
    {
      const unsigned int below = (1u << axis) - 1, lower = (edge & below) | (edge & ~below) << 1;
      return {{lower, lower | 1u << axis}};
    }

    /// Mean length of the edges along each axis over the shortest of the other two.
    double flatness(const VolumeMesh &mesh, const std::size_t cell, const unsigned int axis)
    {
      std::array<double, 3> length{};
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto [lower, upper] = corners_of_edge(a, edge);
            length[a] += (mesh.node(mesh.cells[cell][upper]) - mesh.node(mesh.cells[cell][lower])).norm();
          }
      return length[axis] / std::min(length[(axis + 1) % 3], length[(axis + 2) % 3]);
    }

    /// The axis of a cell along which two of its nodes differ.
    unsigned int axis_between(const std::array<std::uint32_t, 8> &cell, const std::uint32_t a, const std::uint32_t b)
    {
      const auto corner = [&cell](const std::uint32_t node) {
        return static_cast<unsigned int>(std::find(cell.begin(), cell.end(), node) - cell.begin());
      };
      const unsigned int difference = corner(a) ^ corner(b);
      return difference == 1 ? 0 : difference == 2 ? 1 : difference == 4 ? 2 : unknown;
    }

    /// An edge of `cell` along its axis that lies in the face, or, if the axis crosses it, one of `other` that does.
    unsigned int continued_axis(const VolumeMesh &mesh, const std::uint32_t cell, const unsigned int face,
                                const unsigned int axis, const std::uint32_t other)
    {
      const auto &nodes = mesh.cells[cell], &others = mesh.cells[other];
      if (axis != face / 2)
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto [lower, upper] = corners_of_edge(axis, edge);
            if ((lower >> (face / 2) & 1) == face % 2)
              return axis_between(others, nodes[lower], nodes[upper]);
          }
      // the axis of the other that no edge of the common face has
      const auto &corner = corners_of_edge(face / 2, 0), &right = corners_of_edge(face / 2, 1),
                 &up          = corners_of_edge(face / 2, 2);
      const unsigned int side = face % 2;
      return 3 - axis_between(others, nodes[corner[side]], nodes[right[side]]) -
             axis_between(others, nodes[corner[side]], nodes[up[side]]);
    }
  } // namespace

  NodeColumns::NodeColumns(const VolumeMesh &mesh) : axis(mesh.cells.size(), unknown), place(mesh.nodes.size(), none)
  {
    find_axes(mesh);
    string_columns(mesh);
  }

  void NodeColumns::find_axes(const VolumeMesh &mesh)
  {
    std::uint32_t first = 0;
    axis[0]             = 2;
    if (mesh.layers == 0)
      {
        double       flattest = std::numeric_limits<double>::infinity();
        unsigned int best     = 0;
        for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
          for (unsigned int a = 0; a < 3; ++a)
            if (const double f = flatness(mesh, cell, a); f < flattest * (1. - 1e-9))
              {
                flattest = f;
                first    = cell;
                best     = a;
              }
        axis[0]     = unknown;
        axis[first] = best;
      }
    std::vector<std::uint32_t> reached{first}; // the mesh is in one piece
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (unsigned int f = 0; f < 6; ++f)
        {
          const std::uint32_t cell = reached[k];
          if (mesh.neighbors[cell][f] < 0)
            continue;
          const auto         other = static_cast<std::uint32_t>(mesh.neighbors[cell][f]);
          const unsigned int there = continued_axis(mesh, cell, f, axis[cell], other);
          if (axis[other] == unknown)
            reached.push_back(other);
          else if (axis[other] != there)
            refuse("two ways through it give element " + std::to_string(other) + " different directions of thickness",
                   mesh.centroid(other));
          axis[other] = there;
        }
  }

  void NodeColumns::string_columns(const VolumeMesh &mesh)
  {
    std::vector<std::array<std::uint32_t, 2>> next(mesh.nodes.size(), {{none, none}});
    const auto                                join = [&](const std::uint32_t a, const std::uint32_t b) {
      for (std::uint32_t &slot : next[a])
        if (slot == b || slot == none)
          {
            slot = b;
            return;
          }
      refuse("more than two edges through the thickness meet", mesh.node(a));
    };
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int edge = 0; edge < 4; ++edge)
        {
          const auto [lower, upper] = corners_of_edge(axis[cell], edge);
          join(mesh.cells[cell][lower], mesh.cells[cell][upper]);
          join(mesh.cells[cell][upper], mesh.cells[cell][lower]);
        }
    for (std::uint32_t n = 0; n < next.size(); ++n)
      if (next[n][1] == none && place[n] == none) // the end of a column not yet strung
        {
          begin.push_back(static_cast<std::uint32_t>(nodes.size()));
          for (std::uint32_t previous = none, node = n; node != none;)
            {
              place[node] = static_cast<std::uint32_t>(nodes.size());
              nodes.push_back(node);
              const std::uint32_t following = next[node][0] == previous ? next[node][1] : next[node][0];
              previous                      = node;
              node                          = following;
            }
        }
    begin.push_back(static_cast<std::uint32_t>(nodes.size()));
    for (std::size_t n = 0; n < place.size(); ++n)
      if (place[n] == none)
        refuse("edges through the thickness close to a ring", mesh.node(n));
  }

  std::uint32_t NodeColumns::edge_place(const VolumeMesh &mesh, const std::size_t cell, const unsigned int edge) const
  {
    const auto [lower, upper] = corners_of_edge(axis[cell], edge);
    return std::min(place[mesh.cells[cell][lower]], place[mesh.cells[cell][upper]]);
  }
} // namespace birdstrike
