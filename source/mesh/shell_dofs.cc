#include "mesh/shell_mesh_grid.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace birdstrike
{
  void ShellMesh::distribute_dofs()
  {
    grid->element = std::make_unique<dealii::FESystem<2, 3>>(dealii::FE_Q<2, 3>(1), 6);
    grid->dofs    = std::make_unique<dealii::DoFHandler<2, 3>>(grid->triangulation);
    grid->dofs->distribute_dofs(*grid->element);

    std::vector<std::uint32_t> node_of_vertex(grid->triangulation.n_vertices());
    for (const auto &cell : grid->dofs->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          const auto first = cell->vertex_dof_index(v, 0);
          for (unsigned int c = 0; c < 6; ++c)
            AssertThrow(first % 6 == 0 && cell->vertex_dof_index(v, c) == first + c,
                        dealii::ExcMessage("The unknowns of a vertex must be contiguous."));
          node_of_vertex[cell->vertex_index(v)] = first / 6;
        }
    extract(node_of_vertex);
  }

  ShellMesh::Mass ShellMesh::compute_mass(const double density, const ThicknessLaw &thickness) const
  {
    const dealii::QGauss<2>  quadrature(2);
    const dealii::FE_Q<2, 3> shape(1);
    dealii::FEValues<2, 3>   values(shape, quadrature,
                                    dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
    const SurfaceMesh       &mesh = plain;
    Mass                     mass;
    mass.node.assign(mesh.nodes.size(), 0.);
    mass.rotary.assign(mesh.nodes.size(), 0.);
    for (const auto &cell : grid->dofs->active_cell_iterators())
      {
        values.reinit(static_cast<const dealii::Triangulation<2, 3>::active_cell_iterator &>(cell));
        double area = 0., element_mass = 0.;
        double share[4] = {0., 0., 0., 0.};
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const dealii::Point<3> p = values.quadrature_point(q);
            const double           t = thickness_at(thickness, &p[0], cell->material_id());
            const double           m = density * t * values.JxW(q);
            area += values.JxW(q);
            element_mass += m;
            for (unsigned int k = 0; k < 4; ++k)
              share[k] += m * values.shape_value(k, q);
          }
        const double t       = element_mass / (density * area);
        const double inertia = std::max(t * t / 12., area / 8.);
        for (unsigned int k = 0; k < 4; ++k)
          {
            const std::size_t n = cell->vertex_dof_index(k, 0) / 6;
            mass.node[n] += share[k];
            mass.rotary[n] += share[k] * inertia;
          }
        mass.element.push_back(element_mass);
        mass.element_thickness.push_back(t);
        mass.total += element_mass;
      }
    return mass;
  }
} // namespace birdstrike
