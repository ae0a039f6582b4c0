#include "structure/surface/eroding_skin.h"

#include <algorithm>
#include <map>

namespace birdstrike
{
  namespace
  {
    /// Corners of the faces, counter-clockwise about the outward normal; faces in deal.II's order -x +x -y +y -z +z.
    constexpr std::array<std::array<unsigned int, 4>, 6> corners_of_face{
      {{{0, 4, 6, 2}}, {{1, 3, 7, 5}}, {{0, 1, 5, 4}}, {{2, 6, 7, 3}}, {{0, 2, 3, 1}}, {{4, 5, 7, 6}}}};

    std::array<std::uint32_t, 4> nodes_of(const VolumeMesh &mesh, const std::size_t cell, const unsigned int face)
    {
      std::array<std::uint32_t, 4> nodes;
      for (unsigned int k = 0; k < 4; ++k)
        nodes[k] = mesh.cells[cell][corners_of_face[face][k]];
      return nodes;
    }

    bool has(const std::array<std::uint32_t, 4> &nodes, const std::uint32_t node)
    {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    }
  } // namespace

  ErodingSkin::ErodingSkin(const VolumeMesh &mesh) : mesh(mesh), half_thickness(mesh.skin.cells.size(), 0.)
  {
  }

  void ErodingSkin::find_neighbors()
  {
    struct Side
    {
      std::size_t  cell;
      unsigned int face;
    };
    std::map<std::array<std::uint32_t, 4>, Side> seen;
    across.assign(mesh.cells.size(), {{outside, outside, outside, outside, outside, outside}});
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int face = 0; face < 6; ++face)
        {
          auto nodes = nodes_of(mesh, cell, face);
          std::sort(nodes.begin(), nodes.end());
          const auto [other, is_new] = seen.try_emplace(nodes, Side{cell, face});
          if (is_new)
            continue;
          across[cell][face]                             = static_cast<std::int32_t>(other->second.cell);
          across[other->second.cell][other->second.face] = static_cast<std::int32_t>(cell);
          seen.erase(other);
        }
    for (const auto &face : mesh.symmetry_faces)
      across[face.cell][face.face] = symmetry;
  }

  std::int32_t ErodingSkin::facet_across(const std::size_t first, const unsigned int first_face, const std::uint32_t a,
                                         const std::uint32_t b) const
  {
    std::size_t  cell = first;
    unsigned int face = first_face;
    while (true)
      {
        // the other face of this cell at the edge
        unsigned int other = 0;
        while (other == face || !has(nodes_of(mesh, cell, other), a) || !has(nodes_of(mesh, cell, other), b))
          ++other;
        if (number[cell][other] >= 0)
          return number[cell][other];
        const std::int32_t next = across[cell][other];
        if (next == symmetry)
          return FacetsView::symmetry_edge;
        const auto from = static_cast<std::int32_t>(cell);
        cell            = static_cast<std::size_t>(next);
        const auto back = std::find(across[cell].begin(), across[cell].end(), from);
        face            = static_cast<unsigned int>(back - across[cell].begin());
      }
  }

  void ErodingSkin::remove(const FunctionRef<bool(std::size_t)> is_gone)
  {
    if (across.empty())
      find_neighbors();
    number.assign(mesh.cells.size(), {{-1, -1, -1, -1, -1, -1}});
    facets.clear();
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int face = 0; face < 6 && !is_gone(cell); ++face)
        if (const std::int32_t other = across[cell][face];
            other == outside || (other >= 0 && is_gone(static_cast<std::size_t>(other))))
          {
            number[cell][face] = static_cast<std::int32_t>(facets.size());
            facets.push_back(nodes_of(mesh, cell, face));
          }
    neighbors.resize(facets.size());
    half_thickness.assign(facets.size(), 0.);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int face = 0; face < 6; ++face)
        if (const std::int32_t f = number[cell][face]; f >= 0)
          for (unsigned int k = 0; k < 4; ++k)
            neighbors[static_cast<std::size_t>(f)][k] = facet_across(cell, face, facets[static_cast<std::size_t>(f)][k],
                                                                     facets[static_cast<std::size_t>(f)][(k + 1) % 4]);
    ++revision;
  }

  void ErodingSkin::offer(FacetsView &view) const
  {
    const bool is_whole = revision == 0;
    view.n_facets       = is_whole ? mesh.skin.cells.size() : facets.size();
    view.nodes          = is_whole ? mesh.skin.cells.data() : facets.data();
    view.neighbor       = is_whole ? mesh.skin.neighbors.data() : neighbors.data();
    view.half_thickness = half_thickness.data();
    view.two_sided      = false;
    view.revision       = revision;
  }
} // namespace birdstrike
