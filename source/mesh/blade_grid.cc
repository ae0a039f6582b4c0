#include "mesh/blade_grid.h"
#include "mesh/generated_surface.h"

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    template <class Face>
    bool lies_on_plane(const Face &face)
    {
      for (const unsigned int v : face->vertex_indices())
        if (face->vertex(v)[1] != 0.)
          return false;
      return true;
    }
  } // namespace

  template <int dim>
  std::size_t BladeMesh<dim>::Grid::distribute_dofs()
  {
    element = std::make_unique<dealii::FESystem<dim, 3>>(dealii::FE_Q<dim, 3>(1), n_unknowns);
    dofs.reinit(triangulation);
    dofs.distribute_dofs(*element);
    std::vector<bool> is_inside(dofs.n_dofs(), dim == 3);
    if constexpr (dim == 3)
      {
        for (const auto &cell : dofs.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f) && !(is_halved && lies_on_plane(cell->face(f))))
              for (const unsigned int v : cell->face(f)->vertex_indices())
                for (unsigned int c = 0; c < n_unknowns; ++c)
                  is_inside[cell->face(f)->vertex_dof_index(v, c)] = false;
        dealii::DoFRenumbering::sort_selected_dofs_back(dofs, is_inside);
      }
    node_of_vertex.resize(triangulation.n_vertices());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          for (unsigned int c = 0; c < n_unknowns; ++c)
            AssertThrow(cell->vertex_dof_index(v, c) == node(cell, v) * n_unknowns + c,
                        dealii::ExcMessage("The unknowns of a vertex must be contiguous."));
          node_of_vertex[cell->vertex_index(v)] = node(cell, v);
        }
    return static_cast<std::size_t>(std::count(is_inside.begin(), is_inside.end(), false)) / n_unknowns;
  }

  template <int dim>
  std::uint32_t BladeMesh<dim>::Grid::blade_of(const unsigned int cell) const
  {
    return cell / (triangulation.n_active_cells() / row.n_blades);
  }

  template <int dim>
  Point3 BladeMesh<dim>::Grid::as_first(const unsigned int cell, const Point3 &x) const
  {
    const std::uint32_t blade = blade_of(cell);
    return blade == 0 ? x : turn(row, -row.angles()[blade], x);
  }

  template <int dim>
  NodeSpace BladeMesh<dim>::Grid::make_space(const std::uint32_t first, const std::uint32_t last) const
  {
    dealii::IndexSet owned(dofs.n_dofs() / n_unknowns);
    owned.add_range(first, last);
    dealii::IndexSet here = owned;
    for (unsigned int layer = 0; layer < 2 && owned.n_elements() < owned.size(); ++layer)
      {
        const dealii::IndexSet before = here;
        for (const auto &cell : dofs.active_cell_iterators())
          {
            const auto vertices = cell->vertex_indices();
            if (std::any_of(vertices.begin(), vertices.end(),
                            [&](const unsigned int v) { return before.is_element(node(cell, v)); }))
              for (const unsigned int v : vertices)
                here.add_index(node(cell, v));
          }
      }
    here.subtract_set(owned);
    return NodeSpace(owned, here);
  }

  template struct BladeMesh<2>::Grid;
  template struct BladeMesh<3>::Grid;
} // namespace birdstrike
