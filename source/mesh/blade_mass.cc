#include "mesh/blade_grid.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace birdstrike
{
  template <int dim>
  auto BladeMesh<dim>::compute_mass(const DensityLaw &density_of, const ThicknessLaw &thickness,
                                    const NodalThickness &nodal) const -> Mass
  {
    const dealii::QGauss<dim>  quadrature(2);
    const dealii::FE_Q<dim, 3> shape(1);
    dealii::FEValues<dim, 3>   values(
        shape, quadrature, dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
    Mass mass;
    mass.node.assign(this->nodes.size(), 0.);
    if (dim == 2)
      mass.rotary.assign(this->nodes.size(), 0.);
    for (const auto &cell : grid->dofs.active_cell_iterators())
      {
        if (!Grid::is_here(this->space, cell))
          continue;
        values.reinit(static_cast<const typename dealii::Triangulation<dim, 3>::active_cell_iterator &>(cell));
        const double density = density_of(cell->material_id());
        double       size = 0., element_mass = 0.;
        double       share[BladeMesh::n_corners] = {};
        bool         is_given                    = true;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const dealii::Point<3> &p = values.quadrature_point(q);
            const Point3            x = grid->as_first(cell->active_cell_index(), Point3(p[0], p[1], p[2]));
            SurfacePlace            place{x.data(), cell->material_id()};
            for (const unsigned int v : cell->vertex_indices())
              {
                const std::uint32_t n = this->space.local(Grid::node(cell, v));
                const double        w = values.shape_value(v, q);
                if (!nodal.given.empty())
                  place.given += w * nodal.given[n];
                else if (!grid->labels.corner_thickness.empty())
                  place.given += w * grid->labels.corner_thickness[cell->active_cell_index()][v];
                for (unsigned int d = 0; d < 2 && !nodal.station.empty(); ++d)
                  place.station[d] += w * nodal.station[n][d];
              }
            const double t = dim == 2 ? thickness_at(thickness, place) : 1.;
            is_given       = is_given && t == place.given;
            const double m = density * t * values.JxW(q);
            size += values.JxW(q);
            element_mass += m;
            for (const unsigned int v : cell->vertex_indices())
              share[v] += m * values.shape_value(v, q);
          }
        const double t       = element_mass / (density * size);
        const double inertia = std::max(t * t / 12., size / 8.); // of a shell
        for (const unsigned int v : cell->vertex_indices())
          {
            const std::uint32_t n = this->space.local(Grid::node(cell, v));
            mass.node[n] += share[v];
            if (dim == 2)
              mass.rotary[n] += share[v] * inertia;
          }
        if (this->is_owned(mass.element.size()))
          mass.total += element_mass;
        mass.element.push_back(element_mass);
        mass.n_given += dim == 2 && is_given;
        if (dim == 2)
          mass.element_thickness.push_back(t);
      }
    return mass;
  }

  template BladeMesh<2>::Mass BladeMesh<2>::compute_mass(const DensityLaw &, const ThicknessLaw &,
                                                         const NodalThickness &) const;
  template BladeMesh<3>::Mass BladeMesh<3>::compute_mass(const DensityLaw &, const ThicknessLaw &,
                                                         const NodalThickness &) const;
} // namespace birdstrike
