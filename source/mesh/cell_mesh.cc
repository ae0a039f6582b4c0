#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/cell_mesh.h>

#include <algorithm>
#include <limits>

namespace birdstrike
{
  namespace
  {
    template <class Value>
    void sort_uniquely(std::vector<Value> &values)
    {
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
    }

    template <class Value>
    bool contains(const std::vector<Value> &values, const Value value)
    {
      return std::find(values.begin(), values.end(), value) != values.end();
    }

    /// Half the cross product of the diagonals, m^2.
    template <int dim>
    Point3 area_of(const CellMesh<dim> &mesh, const std::array<std::uint32_t, 4> &n)
    {
      return 0.5 * (mesh.node(n[2]) - mesh.node(n[0])).cross(mesh.node(n[3]) - mesh.node(n[1]));
    }
  } // namespace

  template <int dim>
  Point3 CellMesh<dim>::centroid(const std::size_t cell) const
  {
    Point3 sum = node(cells[cell][0]);
    for (unsigned int k = 1; k < n_corners; ++k)
      sum += node(cells[cell][k]);
    return 1. / n_corners * sum;
  }

  template <int dim>
  double CellMesh<dim>::smallest_edge(const std::size_t cell) const
  {
    double     smallest = std::numeric_limits<double>::infinity();
    const auto look     = [&](const unsigned int a, const unsigned int b) {
      smallest = std::min(smallest, (node(cells[cell][b]) - node(cells[cell][a])).norm());
    };
    for (unsigned int k = 0; k < n_corners; ++k)
      if constexpr (dim == 2)
        look(k, (k + 1) % 4);
      else
        for (unsigned int d = 0; d < 3; ++d)
          if (!(k >> d & 1))
            look(k, k | 1u << d);
    return smallest;
  }

  template <int dim>
  auto CellMesh<dim>::side_nodes(const std::size_t cell, const unsigned int side) const
    -> std::array<std::uint32_t, n_corners / 2>
  {
    const Cell &c = cells[cell];
    if constexpr (dim == 2)
      return {{c[side], c[(side + 1) % 4]}};
    else
      {
        static constexpr unsigned int outward[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        const auto                   &k             = outward[side];
        return {{c[k[0]], c[k[1]], c[k[2]], c[k[3]]}};
      }
  }

  template <int dim>
  bool CellMesh<dim>::is_owned(const std::size_t cell) const
  {
    const auto comes_first = [this](const std::uint32_t a, const std::uint32_t b) {
      return space.global(a) < space.global(b);
    };
    return space.is_whole() || space.is_owned(*std::min_element(cells[cell].begin(), cells[cell].end(), comes_first));
  }

  template <int dim>
  std::vector<bool> CellMesh<dim>::owned_cells() const
  {
    std::vector<bool> are_owned;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      are_owned.push_back(is_owned(cell));
    return are_owned;
  }

  template <int dim>
  std::vector<std::uint32_t> CellMesh<dim>::nodes_on(const std::vector<unsigned int> &ids) const
  {
    std::vector<std::uint32_t> found;
    for (const auto *list : {&boundary, &symmetry_sides})
      for (const BoundarySide &side : *list)
        if (contains(ids, side.id))
          std::copy_if(side.nodes.begin(), side.nodes.end(), std::back_inserter(found),
                       [this](const std::uint32_t n) { return space.is_owned(n); });
    sort_uniquely(found);
    return found;
  }

  template <int dim>
  bool CellMesh<dim>::has_boundary_id(const unsigned int id) const
  {
    return contains(boundary_ids, id);
  }

  template <int dim>
  void CellMesh<dim>::cut_at_symmetry_plane()
  {
    const auto is_off_plane = [this](const BoundarySide &side) {
      return std::any_of(side.nodes.begin(), side.nodes.end(),
                         [this](const std::uint32_t n) { return nodes[n][1] != 0.; });
    };
    const auto middle = std::stable_partition(boundary.begin(), boundary.end(), is_off_plane);
    symmetry_sides.assign(middle, boundary.end());
    boundary.erase(middle, boundary.end());
    for (const BoundarySide &side : symmetry_sides)
      {
        neighbors[side.cell][side.side] = FacetsView::symmetry_edge;
        symmetry_nodes.insert(symmetry_nodes.end(), side.nodes.begin(), side.nodes.end());
      }
    sort_uniquely(symmetry_nodes);
    if (symmetry_sides.empty() && space.is_whole())
      throw InputError(std::string("Mesh: no ") + (dim == 2 ? "edge" : "face") +
                       " lies on the symmetry plane y = 0.\nCut the blade there, or set Case/Symmetry plane to none.");
  }

  Point3 SurfaceMesh::area_vector(const std::size_t cell) const
  {
    return area_of(*this, cells[cell]);
  }

  Point3 area_vector(const VolumeMesh &mesh, const VolumeMesh::BoundarySide &side)
  {
    return area_of(mesh, side.nodes);
  }

  Point3 middle(const VolumeMesh &mesh, const VolumeMesh::BoundarySide &side)
  {
    const auto &c = side.nodes;
    return 0.25 * (mesh.node(c[0]) + mesh.node(c[1]) + mesh.node(c[2]) + mesh.node(c[3]));
  }

  template struct CellMesh<2>;
  template struct CellMesh<3>;
} // namespace birdstrike
