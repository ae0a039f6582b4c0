#include "solid_harness.h"

#include <gtest/gtest.h>

using namespace solid_harness;

namespace
{
  constexpr double young = 113.8e9, poisson = 0.342, density = 4430.;
  constexpr double length = 0.3112, chord = 0.0889, thickness = 4.27e-3;

  std::vector<double> plate_frequencies(const std::array<unsigned int, 3> &n, const SolidFormulation formulation,
                                        const int n_modes)
  {
    SolidSection section     = make_section(young, poisson, formulation);
    section.material.density = density;
    Model             model(make_box(n, Point3(length, chord, thickness)), section);
    std::vector<bool> held(model.n_dofs(), false);
    for (std::size_t d = 0; d < held.size(); ++d)
      held[d] = model.mesh.nodes[d / 3][0] < 1e-9;
    return model.compute_frequencies(held, n_modes);
  }

  /// Tip deflection over that of beam theory of a cantilever with a tip force.
  double cantilever(const std::array<unsigned int, 3> &n, const Point3 &size, const double nu,
                    const SolidFormulation formulation)
  {
    Model             model(make_box(n, size), make_section(1e9, nu, formulation));
    std::vector<bool> held(model.n_dofs(), false);
    Eigen::VectorXd   load  = Eigen::VectorXd::Zero(model.n_dofs());
    double            tip   = 0.;
    std::size_t       n_tip = (n[1] + 1) * (n[2] + 1);
    for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
      {
        const Point3 &x = model.mesh.nodes[k];
        if (x[0] < 1e-9)
          {
            held[3 * k]     = true; // free to contract
            held[3 * k + 1] = x[1] < 1e-9;
            held[3 * k + 2] = x[2] < 1e-9;
          }
        if (x[0] > size[0] - 1e-9)
          load[3 * k + 2] = 1. / double(n_tip);
      }
    const Eigen::VectorXd u = model.solve(load, held);
    for (std::size_t k = 0; k < model.mesh.nodes.size(); ++k)
      if (model.mesh.nodes[k][0] > size[0] - 1e-9)
        tip += u[3 * k + 2] / double(n_tip);
    const double inertia = size[1] * std::pow(size[2], 3) / 12.;
    return tip / (std::pow(size[0], 3) / (3e9 * inertia));
  }
} // namespace

TEST(SolidBending, Table)
{
  for (const auto formulation : {SolidFormulation::one_point, SolidFormulation::b_bar})
    for (const double nu : {0., 0.3, 0.499})
      for (const double aspect : {1., 2., 10., 20.})
        std::printf("%d nu %g aspect %g: %.5f\n", int(formulation), nu, aspect,
                    cantilever({20, 1, 1}, Point3(20. * aspect, 1., 1.), nu, formulation));
  for (const auto formulation : {SolidFormulation::one_point, SolidFormulation::b_bar})
    for (const auto &n : {std::array<unsigned int, 3>{14, 4, 1}, {28, 8, 1}, {28, 8, 2}, {56, 16, 1}})
      {
        std::printf("%d %ux%ux%u:", int(formulation), n[0], n[1], n[2]);
        for (const double f : plate_frequencies(n, formulation, 7))
          std::printf(" %.3f", f);
        std::printf("\n");
      }
}
