#include "split_case.h"

namespace birdstrike
{
  BladeParameters twisted_blade()
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

  std::vector<Point3> points_of(const std::vector<std::array<double, 3>> &nodes)
  {
    std::vector<Point3> points;
    for (const auto &x : nodes)
      points.emplace_back(x.data());
    return points;
  }

  ShellElements make_elements(const ShellMesh &mesh, const std::string &formulation, ThreadPool &pool,
                              const double yield)
  {
    ShellSection section;
    section.formulation              = formulation == "physical"          ? ShellFormulation::one_point_physical
                                       : formulation == "Belytschko-Tsay" ? ShellFormulation::belytschko_tsay
                                                                          : ShellFormulation::fully_integrated;
    section.material.hardening.yield = yield;
    return ShellElements(points_of(mesh.nodes), mesh.cells, std::vector<double>(mesh.cells.size(), 0.004), section,
                         pool);
  }

  SolidElements make_elements(const SolidMesh &mesh, const std::string &formulation, ThreadPool &pool,
                              const double yield)
  {
    SolidSection section;
    section.formulation              = formulation == "B-bar"         ? SolidFormulation::b_bar
                                       : formulation == "solid-shell" ? SolidFormulation::solid_shell
                                                                      : SolidFormulation::one_point;
    section.material.hardening.yield = yield;
    return SolidElements(points_of(mesh.nodes), mesh.cells, section, pool);
  }

  template <int dim>
  typename BladeMesh<dim>::Mass mass_of(const BladeMesh<dim> &mesh)
  {
    return mesh.compute_mass(4430., [](const SurfacePlace &at) { return 0.004 + 0.001 * at.position[0]; });
  }

  template <int dim>
  Halves<dim>::Halves() : whole(twisted_blade())
  {
    const std::uint32_t n = whole.space.size();
    parts.push_back(whole.part(0, n / 2));
    parts.push_back(whole.part(n / 2, n));
  }

  template <int dim>
  Halves<dim>::~Halves() = default;

  template ShellMesh::Mass mass_of(const ShellMesh &);
  template SolidMesh::Mass mass_of(const SolidMesh &);
  template struct Halves<2>;
  template struct Halves<3>;
} // namespace birdstrike
