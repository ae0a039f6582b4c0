#pragma once

#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <string>
#include <vector>

// A twisted blade, whole and cut in two: what each of two processes would have of it.
namespace birdstrike
{
  BladeParameters     twisted_blade();
  std::vector<Point3> points_of(const std::vector<std::array<double, 3>> &nodes);

  ShellElements make_elements(const ShellMesh &mesh, const std::string &formulation, ThreadPool &pool,
                              double yield = 880e6);
  SolidElements make_elements(const SolidMesh &mesh, const std::string &formulation, ThreadPool &pool,
                              double yield = 880e6);

  template <int dim>
  typename BladeMesh<dim>::Mass mass_of(const BladeMesh<dim> &mesh);

  template <int dim>
  struct Halves
  {
    BladeMesh<dim>              whole;
    std::vector<BladeMesh<dim>> parts;

    Halves();
    ~Halves();
  };
} // namespace birdstrike
