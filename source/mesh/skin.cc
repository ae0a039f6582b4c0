#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/volume_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace birdstrike
{
  namespace
  {
    constexpr std::uint32_t not_numbered = std::numeric_limits<std::uint32_t>::max();

    std::string at(const Point3 &p)
    {
      return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + ") m";
    }

    /// An edge of a facet with its nodes in ascending order; equal edges stand together once sorted.
    struct FacetEdge
    {
      std::array<std::uint32_t, 2> nodes;
      std::uint32_t                facet;
      unsigned int                 side;

      bool operator<(const FacetEdge &other) const
      {
        return std::pair(nodes, facet) < std::pair(other.nodes, other.facet);
      }
    };

    std::vector<FacetEdge> sorted_edges(const SurfaceMesh &skin)
    {
      std::vector<FacetEdge> edges;
      for (std::uint32_t facet = 0; facet < skin.cells.size(); ++facet)
        for (unsigned int side = 0; side < 4; ++side)
          {
            const std::uint32_t a = skin.cells[facet][side], b = skin.cells[facet][(side + 1) % 4];
            edges.push_back({{{std::min(a, b), std::max(a, b)}}, facet, side});
          }
      std::sort(edges.begin(), edges.end());
      return edges;
    }

    /// Facets across edges. Each edge has two facets, or one where the plane of symmetry cuts the skin open.
    void set_neighbors(SurfaceMesh &skin)
    {
      skin.neighbors.assign(skin.cells.size(), {{-1, -1, -1, -1}});
      const std::vector<FacetEdge> edges = sorted_edges(skin);
      for (std::size_t first = 0, last; first < edges.size(); first = last)
        {
          for (last = first + 1; last < edges.size() && edges[last].nodes == edges[first].nodes;)
            ++last;
          const FacetEdge &one = edges[first], &other = edges[last - 1];
          if (last - first > 2)
            throw InputError("Mesh: cells touch each other along an edge only, near " + at(skin.centroid(one.facet)) +
                             ".\nCells of a body share whole faces or nothing; join them or part them there.");
          if (last - first == 2)
            {
              skin.neighbors[one.facet][one.side]     = other.facet;
              skin.neighbors[other.facet][other.side] = one.facet;
            }
          else
            skin.neighbors[one.facet][one.side] = FacetsView::symmetry_edge;
        }
    }

    /// Number of the first cell that is not reached from cell 0 through whole faces; n cells if there is none.
    std::size_t first_loose_cell(const VolumeMesh &mesh)
    {
      static const unsigned int corners[6][4] = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5},
                                                 {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};
      // Pieces by union of the cells on both sides of a face; a root is the smallest cell of its piece.
      std::vector<std::uint32_t> parent(mesh.cells.size());
      const auto                 root = [&parent](std::uint32_t cell) {
        while (parent[cell] != cell)
          cell = parent[cell] = parent[parent[cell]];
        return cell;
      };
      std::vector<std::pair<std::array<std::uint32_t, 4>, std::uint32_t>> faces;
      for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
        {
          parent[cell] = cell;
          for (const auto &c : corners)
            {
              std::array<std::uint32_t, 4> nodes;
              for (unsigned int k = 0; k < 4; ++k)
                nodes[k] = mesh.cells[cell][c[k]];
              std::sort(nodes.begin(), nodes.end());
              faces.emplace_back(nodes, cell);
            }
        }
      std::sort(faces.begin(), faces.end());
      for (std::size_t f = 1; f < faces.size(); ++f)
        if (faces[f].first == faces[f - 1].first)
          {
            const std::uint32_t a = root(faces[f - 1].second), b = root(faces[f].second);
            parent[std::max(a, b)] = std::min(a, b);
          }
      std::size_t cell = 0;
      while (cell < mesh.cells.size() && root(cell) == 0)
        ++cell;
      return cell;
    }

    /// Puts nodes near the plane y = 0 onto it, and faces between them into a list of their own.
    void cut_at_plane(VolumeMesh &mesh)
    {
      double size = 0.;
      for (const auto &node : mesh.nodes)
        size = std::max({size, std::abs(node[0]), std::abs(node[1]), std::abs(node[2])});
      for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n)
        {
          double &y = mesh.nodes[n][1];
          if (y < -1e-6 * size)
            throw InputError("Mesh: node " + std::to_string(n) + " at " + at(mesh.node(n)) +
                             " lies beyond the symmetry plane y = 0.\nAllowed: the half y >= 0 of the blade.");
          if (y <= 1e-6 * size)
            y = 0.;
        }
      const auto is_off_plane = [&mesh](const VolumeMesh::BoundaryFace &face) {
        return std::any_of(face.nodes.begin(), face.nodes.end(),
                           [&mesh](const std::uint32_t n) { return mesh.nodes[n][1] != 0.; });
      };
      const auto middle = std::stable_partition(mesh.faces.begin(), mesh.faces.end(), is_off_plane);
      mesh.symmetry_faces.assign(middle, mesh.faces.end());
      mesh.faces.erase(middle, mesh.faces.end());
      if (mesh.symmetry_faces.empty())
        throw InputError("Mesh: no face lies on the symmetry plane y = 0.\nCut the blade there, or set Case/Symmetry "
                         "plane to none.");
    }

    /// New number of each node: those of the skin first, each group in the order in which cells name them.
    std::vector<std::uint32_t> number_skin_first(VolumeMesh &mesh)
    {
      std::vector<bool> is_skin(mesh.nodes.size(), false);
      for (const auto &face : mesh.faces)
        for (const std::uint32_t n : face.nodes)
          is_skin[n] = true;
      std::vector<std::uint32_t> number(mesh.nodes.size(), not_numbered);
      std::uint32_t              next = 0;
      for (const bool skin : {true, false})
        {
          for (const auto &cell : mesh.cells)
            for (const std::uint32_t n : cell)
              if (is_skin[n] == skin && number[n] == not_numbered)
                number[n] = next++;
          if (skin)
            mesh.n_skin_nodes = next;
        }
      return number;
    }

    void renumber(VolumeMesh &mesh, const std::vector<std::uint32_t> &number)
    {
      std::vector<std::array<double, 3>> nodes(mesh.nodes.size());
      std::size_t                        n_used = 0;
      for (std::size_t n = 0; n < nodes.size(); ++n)
        if (number[n] != not_numbered)
          {
            nodes[number[n]] = mesh.nodes[n];
            ++n_used;
          }
      nodes.resize(n_used);
      mesh.nodes        = std::move(nodes);
      const auto rename = [&number](auto &entities) {
        for (auto &entity : entities)
          for (std::uint32_t &n : entity)
            n = number[n];
      };
      rename(mesh.cells);
      for (auto *list : {&mesh.faces, &mesh.symmetry_faces})
        for (auto &face : *list)
          for (std::uint32_t &n : face.nodes)
            n = number[n];
    }
  } // namespace

  void make_skin(VolumeMesh &mesh, const bool is_halved)
  {
    if (const std::size_t loose = first_loose_cell(mesh); loose < mesh.cells.size())
      throw InputError("Mesh: the body falls into pieces; the cell at " + at(mesh.centroid(loose)) +
                       " hangs together with the first one by no face.\nMerge coincident nodes (Gmsh: Coherence Mesh) "
                       "or remove the loose part.");
    if (is_halved)
      cut_at_plane(mesh);
    renumber(mesh, number_skin_first(mesh));

    mesh.skin = SurfaceMesh();
    mesh.skin.nodes.assign(mesh.nodes.begin(), mesh.nodes.begin() + mesh.n_skin_nodes);
    for (const auto &face : mesh.faces)
      {
        mesh.skin.cells.push_back(face.nodes);
        mesh.skin.material_ids.push_back(mesh.material_ids[face.cell]);
      }
    set_neighbors(mesh.skin);
    for (const auto &face : mesh.symmetry_faces)
      mesh.symmetry_nodes.insert(mesh.symmetry_nodes.end(), face.nodes.begin(), face.nodes.end());
    std::sort(mesh.symmetry_nodes.begin(), mesh.symmetry_nodes.end());
    mesh.symmetry_nodes.erase(std::unique(mesh.symmetry_nodes.begin(), mesh.symmetry_nodes.end()),
                              mesh.symmetry_nodes.end());
    for (const std::uint32_t n : mesh.symmetry_nodes)
      if (n < mesh.n_skin_nodes)
        mesh.skin.symmetry_nodes.push_back(n);
  }
} // namespace birdstrike
