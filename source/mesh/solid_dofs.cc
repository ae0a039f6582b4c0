#include "mesh/solid_mesh_grid.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

namespace birdstrike
{
  void SolidMesh::distribute_dofs()
  {
    grid->element = std::make_unique<dealii::FESystem<3>>(dealii::FE_Q<3>(1), 3);
    grid->dofs    = std::make_unique<dealii::DoFHandler<3>>(grid->triangulation);
    grid->dofs->distribute_dofs(*grid->element);
    AssertThrow(grid->dofs->n_dofs() == 3 * plain.nodes.size(),
                dealii::ExcMessage("Each node must carry three unknowns."));

    std::vector<dealii::types::global_dof_index> number(grid->dofs->n_dofs());
    for (const auto &cell : grid->dofs->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int c = 0; c < 3; ++c)
          number[cell->vertex_dof_index(v, c)] = 3 * plain.cells[cell->active_cell_index()][v] + c;
    grid->dofs->renumber_dofs(number);
  }

  SolidMesh::Mass SolidMesh::compute_mass(const double density) const
  {
    const dealii::QGauss<3> quadrature(2);
    const dealii::FE_Q<3>   shape(1);
    dealii::FEValues<3>     values(shape, quadrature, dealii::update_values | dealii::update_JxW_values);
    Mass                    mass;
    mass.node.assign(plain.nodes.size(), 0.);
    for (const auto &cell : grid->dofs->active_cell_iterators())
      {
        values.reinit(static_cast<const dealii::Triangulation<3>::active_cell_iterator &>(cell));
        double element_mass = 0.;
        double share[8]     = {};
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const double m = density * values.JxW(q);
            element_mass += m;
            for (unsigned int v = 0; v < 8; ++v)
              share[v] += m * values.shape_value(v, q);
          }
        for (const unsigned int v : cell->vertex_indices())
          mass.node[cell->vertex_dof_index(v, 0) / 3] += share[v];
        mass.element.push_back(element_mass);
        mass.total += element_mass;
      }
    return mass;
  }
} // namespace birdstrike
