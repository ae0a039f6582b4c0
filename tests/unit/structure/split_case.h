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
  inline BladeParameters twisted_blade()
  {
    BladeParameters p;
    p.mesh.generator       = MeshGenerator::blade;
    p.mesh.n_span          = 9;
    p.mesh.n_chord         = 5;
    p.mesh.n_layers        = 1; // nodes inside are numbered after the skin: a range of numbers would be no half
    p.mesh.profile.stagger = "40*s";
    p.mesh.profile.camber  = "0.1";
    p.supports.held        = "3: uz";
    p.loads.pressure       = "1e5*x + 1e4*t";
    p.loads.point_loads    = "0.3112 0.0 0: 1; 2; 3 | 0.1 0.0 0: 4; 5; 6";
    return p;
  }

  inline std::vector<Point3> points_of(const std::vector<std::array<double, 3>> &nodes)
  {
    std::vector<Point3> points;
    for (const auto &x : nodes)
      points.emplace_back(x.data());
    return points;
  }

  inline ShellElements make_elements(const ShellMesh &mesh, const std::string &formulation, ThreadPool &pool,
                                     const double yield = 880e6)
  {
    ShellSection section;
    section.formulation              = formulation == "physical"          ? ShellFormulation::one_point_physical
                                       : formulation == "Belytschko-Tsay" ? ShellFormulation::belytschko_tsay
                                                                          : ShellFormulation::fully_integrated;
    section.material.hardening.yield = yield;
    return ShellElements(points_of(mesh.nodes), mesh.cells, std::vector<double>(mesh.cells.size(), 0.004), section,
                         pool);
  }

  inline SolidElements make_elements(const SolidMesh &mesh, const std::string &formulation, ThreadPool &pool,
                                     const double yield = 880e6)
  {
    SolidSection section;
    section.formulation              = formulation == "B-bar"         ? SolidFormulation::b_bar
                                       : formulation == "solid-shell" ? SolidFormulation::solid_shell
                                                                      : SolidFormulation::one_point;
    section.material.hardening.yield = yield;
    return SolidElements(points_of(mesh.nodes), mesh.cells, section, pool);
  }

  template <int dim>
  auto mass_of(const BladeMesh<dim> &mesh)
  {
    return mesh.compute_mass(4430., [](const SurfacePlace &at) { return 0.004 + 0.001 * at.position[0]; });
  }

  template <int dim>
  struct Halves
  {
    BladeMesh<dim>              whole{twisted_blade()};
    std::vector<BladeMesh<dim>> parts;

    Halves()
    {
      const std::uint32_t n = whole.space.size();
      parts.push_back(whole.part(0, n / 2));
      parts.push_back(whole.part(n / 2, n));
    }
  };
} // namespace birdstrike
