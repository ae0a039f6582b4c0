#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/orientation.h>
#include <birdstrike/mesh/surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace birdstrike
{
  namespace
  {
    std::string at(const Point3 &p)
    {
      return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + ") m";
    }

    struct Side
    {
      std::uint32_t cell;
      unsigned int  side;
    };

    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    Edge edge_of(const SurfaceMesh &mesh, const std::size_t cell, const unsigned int side)
    {
      const std::uint32_t a = mesh.cells[cell][side], b = mesh.cells[cell][(side + 1) % 4];
      return {std::min(a, b), std::max(a, b)};
    }

    /// The two (or one) cells on every edge.
    std::map<Edge, std::vector<Side>> sides_of_edges(const SurfaceMesh &mesh)
    {
      std::map<Edge, std::vector<Side>> sides;
      for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
        for (unsigned int side = 0; side < 4; ++side)
          {
            auto &list = sides[edge_of(mesh, cell, side)];
            list.push_back({cell, side});
            if (list.size() > 2)
              throw InputError("Mesh: more than two cells share the edge near " + at(mesh.centroid(cell)) +
                               ".\nA shell surface may not branch.");
          }
      return sides;
    }

    void set_neighbors(SurfaceMesh &mesh)
    {
      mesh.neighbors.assign(mesh.cells.size(), {{-1, -1, -1, -1}});
      for (const auto &[edge, sides] : sides_of_edges(mesh))
        if (sides.size() == 2)
          {
            mesh.neighbors[sides[0].cell][sides[0].side] = sides[1].cell;
            mesh.neighbors[sides[1].cell][sides[1].side] = sides[0].cell;
          }
    }

    /// Neighbours agree if they run along their common edge in opposite directions.
    bool runs_along(const SurfaceMesh &mesh, const std::size_t cell, const std::uint32_t from, const std::uint32_t to)
    {
      for (unsigned int side = 0; side < 4; ++side)
        if (mesh.cells[cell][side] == from && mesh.cells[cell][(side + 1) % 4] == to)
          return true;
      return false;
    }

    void turn(SurfaceMesh &mesh, const std::size_t cell)
    {
      std::swap(mesh.cells[cell][1], mesh.cells[cell][3]);
      std::swap(mesh.neighbors[cell][0], mesh.neighbors[cell][3]);
      std::swap(mesh.neighbors[cell][1], mesh.neighbors[cell][2]);
    }

    /// Visits cells from neighbour to neighbour; returns how many were reached from cell 0.
    std::size_t unify_normals(SurfaceMesh &mesh)
    {
      std::vector<bool>        seen(mesh.cells.size(), false);
      std::vector<std::size_t> front{0};
      seen[0]               = true;
      std::size_t n_reached = 1;
      while (!front.empty())
        {
          const std::size_t cell = front.back();
          front.pop_back();
          for (unsigned int side = 0; side < 4; ++side)
            {
              const std::int32_t other = mesh.neighbors[cell][side];
              if (other < 0)
                continue;
              const bool differs = runs_along(mesh, other, mesh.cells[cell][side], mesh.cells[cell][(side + 1) % 4]);
              if (differs && seen[other])
                throw InputError("Mesh: the surface has only one side (like a Moebius band) near " +
                                 at(mesh.centroid(cell)) + ".\nA shell needs an upper and a lower face.");
              if (differs)
                turn(mesh, other);
              if (!seen[other])
                {
                  seen[other] = true;
                  ++n_reached;
                  front.push_back(other);
                }
            }
        }
      return n_reached;
    }

    void set_sides_of_rim(SurfaceMesh &mesh)
    {
      for (auto &edge : mesh.rim)
        for (unsigned int side = 0; side < 4; ++side)
          if (edge_of(mesh, edge.cell, side) ==
              Edge(std::min(edge.nodes[0], edge.nodes[1]), std::max(edge.nodes[0], edge.nodes[1])))
            edge.side = side;
    }
  } // namespace

  Point3 SurfaceMesh::node(const std::size_t n) const
  {
    return Point3(nodes[n][0], nodes[n][1], nodes[n][2]);
  }

  Point3 SurfaceMesh::centroid(const std::size_t cell) const
  {
    const auto &c = cells[cell];
    return 0.25 * (node(c[0]) + node(c[1]) + node(c[2]) + node(c[3]));
  }

  Point3 SurfaceMesh::area_vector(const std::size_t cell) const
  {
    const auto &c = cells[cell];
    return 0.5 * (node(c[2]) - node(c[0])).cross(node(c[3]) - node(c[1]));
  }

  double SurfaceMesh::smallest_edge(const std::size_t cell) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (unsigned int side = 0; side < 4; ++side)
      smallest = std::min(smallest, (node(cells[cell][(side + 1) % 4]) - node(cells[cell][side])).norm());
    return smallest;
  }

  std::vector<std::uint32_t> SurfaceMesh::rim_nodes(const std::vector<unsigned int> &ids) const
  {
    std::vector<std::uint32_t> found;
    for (const auto &edge : rim)
      if (std::find(ids.begin(), ids.end(), edge.id) != ids.end())
        found.insert(found.end(), edge.nodes.begin(), edge.nodes.end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  std::vector<unsigned int> SurfaceMesh::boundary_ids() const
  {
    std::vector<unsigned int> ids;
    for (const auto &edge : rim)
      ids.push_back(edge.id);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }

  bool SurfaceMesh::has_boundary_id(const unsigned int id) const
  {
    return std::any_of(rim.begin(), rim.end(), [id](const BoundaryEdge &edge) { return edge.id == id; });
  }

  std::uint32_t SurfaceMesh::nearest_node(const Point3 &p) const
  {
    std::uint32_t nearest  = 0;
    double        distance = std::numeric_limits<double>::infinity();
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
      if (const double d = (node(n) - p).squaredNorm(); d < distance)
        {
          distance = d;
          nearest  = n;
        }
    return nearest;
  }

  void update_topology(SurfaceMesh &mesh)
  {
    set_neighbors(mesh);
    const std::size_t n_reached = unify_normals(mesh);
    if (n_reached < mesh.cells.size())
      throw InputError(
        "Mesh: the surface falls into pieces; only " + std::to_string(n_reached) + " of " +
        std::to_string(mesh.cells.size()) +
        " cells hang together.\nMerge coincident nodes (Gmsh: Coherence Mesh) or remove the loose part.");
    set_sides_of_rim(mesh);
  }

  void face_upwards(SurfaceMesh &mesh)
  {
    Point3 sum  = Point3::Zero();
    double area = 0.;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        sum += mesh.area_vector(cell);
        area += mesh.area_vector(cell).norm();
      }
    if (sum.norm() <= 1e-6 * area || sign_by_axes(sum, {{2, 1, 0}}) > 0.)
      return;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      turn(mesh, cell);
    set_sides_of_rim(mesh);
  }

  void cut_at_symmetry_plane(SurfaceMesh &mesh)
  {
    double size = 0.;
    for (const auto &node : mesh.nodes)
      size = std::max({size, std::abs(node[0]), std::abs(node[1]), std::abs(node[2])});
    std::vector<bool> is_on_plane;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n)
      {
        double &y = mesh.nodes[n][1];
        if (y < -1e-6 * size)
          throw InputError("Mesh: node " + std::to_string(n) + " at " + at(mesh.node(n)) +
                           " lies beyond the symmetry plane y = 0.\nAllowed: the half y >= 0 of the blade.");
        is_on_plane.push_back(y <= 1e-6 * size);
        if (is_on_plane[n])
          y = 0.;
      }
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int side = 0; side < 4; ++side)
        if (const Edge edge = edge_of(mesh, cell, side);
            mesh.neighbors[cell][side] == FacetsView::free_edge && is_on_plane[edge.first] && is_on_plane[edge.second])
          {
            mesh.neighbors[cell][side] = FacetsView::symmetry_edge;
            mesh.symmetry_nodes.insert(mesh.symmetry_nodes.end(), {edge.first, edge.second});
          }
    auto &nodes = mesh.symmetry_nodes;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (nodes.empty())
      throw InputError(
        "Mesh: no edge lies on the symmetry plane y = 0.\nCut the blade there, or set Case/Symmetry plane "
        "to none.");
  }

  void check_shape(const SurfaceMesh &mesh)
  {
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const Point3 normal  = mesh.area_vector(cell);
        bool         is_fine = normal.norm() > 0.;
        for (unsigned int k = 0; k < 4 && is_fine; ++k)
          {
            const Point3 here = mesh.node(mesh.cells[cell][k]);
            const Point3 next = mesh.node(mesh.cells[cell][(k + 1) % 4]) - here;
            const Point3 last = mesh.node(mesh.cells[cell][(k + 3) % 4]) - here;
            is_fine           = next.cross(last).dot(normal) > 1e-10 * normal.squaredNorm();
          }
        if (!is_fine)
          throw InputError("Mesh: cell " + std::to_string(cell) + " at " + at(mesh.centroid(cell)) +
                           " has a corner of zero or negative area (folded, crossed or collapsed).\n"
                           "Every quadrilateral must be convex; repair or re-mesh there.");
      }
  }
} // namespace birdstrike
