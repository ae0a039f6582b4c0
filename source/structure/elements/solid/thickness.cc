#include "structure/elements/solid/thickness.h"

#include "structure/elements/solid/modes.h"

#include <algorithm>
#include <limits>

namespace birdstrike
{
  namespace
  {
    using Cells = std::vector<std::array<std::uint32_t, 8>>;

    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Face 2 k + s of a cell has the corners whose bit k is s. Returns [6 n_cells]: the face 6 cell + face on the
    /// other side of each, or none on the skin.
    std::vector<std::uint32_t> find_neighbors(const Cells &cells)
    {
      struct Face
      {
        std::array<std::uint32_t, 4> nodes;
        std::uint32_t                number;
      };
      std::vector<Face> faces;
      for (std::uint32_t number = 0; number < 6 * cells.size(); ++number)
        {
          Face         face{{}, number};
          unsigned int n = 0;
          for (unsigned int c = 0; c < 8; ++c)
            if ((c >> number % 6 / 2 & 1) == number % 2)
              face.nodes[n++] = cells[number / 6][c];
          std::sort(face.nodes.begin(), face.nodes.end());
          faces.push_back(face);
        }
      std::sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) { return a.nodes < b.nodes; });
      std::vector<std::uint32_t> neighbors(faces.size(), none);
      for (std::size_t f = 1; f < faces.size(); ++f)
        if (faces[f].nodes == faces[f - 1].nodes)
          {
            neighbors[faces[f].number]     = faces[f - 1].number;
            neighbors[faces[f - 1].number] = faces[f].number;
          }
      return neighbors;
    }

    /// Mean edges of the cells along their axes, m.
    std::vector<std::array<double, 3>> compute_edges(const std::vector<Point3> &nodes, const Cells &cells)
    {
      std::vector<std::array<double, 3>> edges;
      for (const auto &cell : cells)
        {
          Vector3<double> x[8];
          for (int i = 0; i < 8; ++i)
            x[i] = nodes[cell[i]];
          const SolidModes<double> modes(x);
          edges.push_back(
            {0.25 * modes.linear[0].norm(), 0.25 * modes.linear[1].norm(), 0.25 * modes.linear[2].norm()});
        }
      return edges;
    }
  } // namespace

  solid_shell::Thickness solid_shell::find_thickness(const std::vector<Point3> &nodes, const Cells &cells)
  {
    const auto            neighbors = find_neighbors(cells);
    const auto            edges     = compute_edges(nodes, cells);
    std::array<double, 3> endless;
    endless.fill(std::numeric_limits<double>::infinity());
    std::vector<std::array<double, 3>>        length(cells.size(), endless); // of the rows along the axes
    std::vector<std::array<std::uint32_t, 3>> n_in_row(cells.size());        // none in a ring, which has no length
    // from each face of the skin through the cells to the opposite one
    const auto walk = [&](std::uint32_t face, const auto &visit) {
      for (; face != none; face = neighbors[face ^ 1])
        visit(face / 6, face % 6 / 2);
    };
    for (std::uint32_t face = 0; face < neighbors.size(); ++face)
      if (neighbors[face] == none)
        {
          double        sum = 0.;
          std::uint32_t n   = 0;
          walk(face, [&](const std::uint32_t cell, const unsigned int axis) {
            sum += edges[cell][axis];
            ++n;
          });
          walk(face, [&](const std::uint32_t cell, const unsigned int axis) {
            length[cell][axis]   = sum;
            n_in_row[cell][axis] = n;
          });
        }
    Thickness thickness;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      {
        std::uint8_t shortest = 2;
        for (std::uint8_t k = 0; k < 2; ++k)
          if (length[cell][k] < 0.99 * length[cell][shortest])
            shortest = k;
        thickness.axis.push_back(shortest);
        thickness.n_layers.push_back(n_in_row[cell][shortest]);
      }
    return thickness;
  }

  Cells solid_shell::with_third(const std::vector<std::uint8_t> &axes, Cells cells)
  {
    for (std::size_t e = 0; e < axes.size(); ++e)
      {
        const auto old    = cells[e];
        const auto [i, j] = following(axes[e]);
        for (unsigned int c = 0; c < 8; ++c)
          cells[e][c] = old[(c & 1) << i | (c >> 1 & 1) << j | (c >> 2) << axes[e]];
      }
    return cells;
  }
} // namespace birdstrike
