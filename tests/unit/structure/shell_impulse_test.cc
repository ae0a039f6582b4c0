#include "../record.h"
#include "shell_motion.h"

#include <gtest/gtest.h>

#include <map>

namespace shell_impulse_test
{
  using namespace shell_harness;

  /// Shells struck by an impulse or a step of pressure until they yield (benchmarks A9 and A11), in the units of their
  /// sources: inch, pound, second. The peer is a plain Belytschko-Tsay code with five points written for this purpose.
  namespace
  {
    Eigen::VectorXd no_load(const Motion &motion)
    {
      return Eigen::VectorXd::Zero(motion.model.n_dofs());
    }

    struct Panel
    {
      double middle, quarter; ///< largest inward displacement of the crown at half and three quarters of the length
      double worst_balance, hourglass, plastic; ///< over the initial energy
    };

    /// A9: half of a cylindrical panel of 120 degrees, straight edges clamped, curved ones hinged; 5650 in/s inwards
    /// over the middle 60 degrees of 10.205 in of its length.
    Panel run_panel(const unsigned int n_arc, const unsigned int n_length, const ShellFormulation formulation)
    {
      const double R = 2.9375, L = 12.56;
      ShellSection section             = make_section(1.05e7, 0.33, formulation);
      section.material.density         = 2.5e-4;
      section.material.hardening.law   = HardeningLaw::perfect;
      section.material.hardening.yield = 44000.;
      const Mesh                 mesh  = make_grid(n_arc, n_length, [=](const double a, const double b) {
        return Point3(R * std::sin(a * pi / 3.), L * b, R * std::cos(a * pi / 3.));
      });
      Motion                     motion(mesh, 0.125, section);
      std::vector<std::uint32_t> crown;
      std::vector<bool>          held(motion.model.n_dofs(), false);
      for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n)
        {
          const unsigned int i = n % (n_arc + 1), j = n / (n_arc + 1);
          for (int c = 0; c < 6; ++c)
            held[6 * n + c] =
              i == n_arc || (c < 3 && (j == 0 || j == n_length)) || (i == 0 && (c == 0 || c == 4 || c == 5));
          if (i == 0)
            crown.push_back(n);
          if (2 * i <= n_arc && mesh.nodes[n][1] <= 10.2051)
            motion.velocity.segment<3>(6 * n) = -5650. / R * Point3(mesh.nodes[n][0], 0., mesh.nodes[n][2]);
        }
      for (std::size_t d = 0; d < held.size(); ++d)
        motion.velocity[d] *= !held[d];
      auto &elements = motion.model.elements;
      elements.add_symmetry_plane(crown, Point3::UnitX());

      const double start = motion.kinetic_energy();
      Panel        panel{};
      for (double t = 0.; t < 0.6e-3; t += motion.dt) // both peaks are over
        {
          motion.step(no_load(motion), 0., held);
          const auto inwards = [&](const unsigned int j) { return R - motion.model.position[3 * (n_arc + 1) * j + 2]; };
          panel.middle       = std::max(panel.middle, inwards(n_length / 2));
          panel.quarter      = std::max(panel.quarter, inwards(3 * n_length / 4));
          for (std::size_t d = 0; d < held.size(); ++d)
            motion.force[d] *= !held[d]; // that of the supports does no work
          const double internal = elements.elastic_energy() + elements.plastic_work() + elements.hourglass_energy();
          panel.worst_balance =
            std::max(panel.worst_balance, std::abs((motion.kinetic_energy() + internal) / start - 1.));
        }
      panel.hourglass = elements.hourglass_energy() / start;
      panel.plastic   = elements.plastic_work() / start;
      return panel;
    }

    /// A quarter of a spherical cap, 3 n^2 elements around its apex, node 0.
    Mesh make_cap(const unsigned int n, const double R, const double half_angle)
    {
      using Plane = std::array<double, 2>; // in the unit disc, the radius as a share of the angle
      Mesh                                           mesh;
      std::map<std::pair<long, long>, std::uint32_t> known;
      const auto                                     node = [&](const Plane &p) {
        const auto key = std::make_pair(std::lround(1e7 * p[0]), std::lround(1e7 * p[1]));
        if (const auto found = known.find(key); found != known.end())
          return found->second;
        const double r = std::hypot(p[0], p[1]), angle = half_angle * r, s = r > 0. ? R * std::sin(angle) / r : 0.;
        mesh.nodes.push_back({s * p[0], s * p[1], R * std::cos(angle)});
        return known[key] = std::uint32_t(mesh.nodes.size() - 1);
      };
      const auto inner = [](const double s, const double t) {
        return Plane{0.5 * s - 0.1 * s * t, 0.5 * t - 0.1 * s * t};
      };
      const auto to_rim = [](const Plane &from, const double share, const double angle) {
        return Plane{(1. - share) * from[0] + share * std::cos(angle),
                     (1. - share) * from[1] + share * std::sin(angle)};
      };
      const std::function<Plane(double, double)> blocks[3] = {
        inner, [&](const double s, const double t) { return to_rim(inner(1., t), s, 0.25 * pi * t); },
        [&](const double s, const double t) { return to_rim(inner(s, 1.), t, 0.5 * pi - 0.25 * pi * s); }};
      for (const auto &block : blocks)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              const auto at = [&](const unsigned int a, const unsigned int b) {
                return node(block(double(i + a) / n, double(j + b) / n));
              };
              const std::uint32_t corner[4] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; // in this order
              mesh.cells.push_back({corner[0], corner[1], corner[2], corner[3]});
            }
      return mesh;
    }

    /// A11: clamped cap under a step of 600 psi that follows the surface; the largest deflection of the apex in 1 ms.
    double largest_cap_deflection(const unsigned int n, const bool is_plastic, const ShellFormulation formulation)
    {
      const double R = 22.27, half_angle = 26.67 * pi / 180.;
      ShellSection section     = make_section(10.5e6, 0.3, formulation);
      section.material.density = 2.45e-4;
      if (is_plastic)
        {
          section.material.hardening.law     = HardeningLaw::linear;
          section.material.hardening.yield   = 24000.;
          section.material.hardening.modulus = 214286.;
        }
      const Mesh                 mesh = make_cap(n, R, half_angle);
      Motion                     motion(mesh, 0.41, section);
      std::vector<bool>          held(motion.model.n_dofs(), false);
      std::vector<std::uint32_t> side[2];
      for (std::uint32_t k = 0; k < mesh.nodes.size(); ++k)
        {
          const Point3 &x = mesh.nodes[k];
          for (int c = 0; c < 2; ++c)
            if (std::abs(x[c]) < 1e-6)
              {
                side[c].push_back(k);
                held[6 * k + c] = held[6 * k + 4 - c] = held[6 * k + 5] = true;
              }
          for (int c = 0; c < 6; ++c)
            if (std::hypot(x[0], x[1]) > R * std::sin(half_angle) - 1e-6)
              held[6 * k + c] = true;
        }
      for (int c = 0; c < 2; ++c)
        motion.model.elements.add_symmetry_plane(side[c], Point3::Unit(c));
      double largest = 0.;
      for (double t = 0.; t < 1e-3; t += motion.dt)
        {
          Eigen::VectorXd load = no_load(motion);
          for (const auto &cell : mesh.cells)
            {
              const auto   x    = [&](const int i) { return Point3(&motion.model.position[3 * cell[i]]); };
              const Point3 area = 0.5 * (x(2) - x(0)).cross(x(3) - x(1));
              for (const auto node : cell)
                load.segment<3>(6 * node) -= 0.25 * 600. * area;
            }
          motion.step(load, 0., held);
          largest = std::max(largest, R - motion.model.position[2]);
        }
      return largest;
    }
  } // namespace

  // The peer's 12 x 32: 1.158 and 0.588 in; the tolerances are those that the benchmark gives for 24 x 64 (1.21, 0.61),
  // where all three find 1.20 and 0.61-0.62. Clamps and hinges do no work: the balance is that of energies from
  // stresses, within 0.8 % at plastic strains of a quarter. That is the step's, not the rate law's: 0.17 % with half of
  // it.
  TEST(ShellImpulse, CylindricalPanel)
  {
    for (const auto formulation : all_formulations)
      {
        const Panel panel = run_panel(12, 32, formulation);
        record(std::string(name_of(formulation)) + " middle", panel.middle);
        record(std::string(name_of(formulation)) + " quarter", panel.quarter);
        record(std::string(name_of(formulation)) + " balance", panel.worst_balance);
        EXPECT_NEAR(panel.middle / 1.158, 1., 0.04) << name_of(formulation);
        EXPECT_NEAR(panel.quarter / 0.588, 1., 0.06) << name_of(formulation);
        EXPECT_LT(panel.worst_balance, 1e-2) << name_of(formulation);
        EXPECT_GT(panel.plastic, 0.95) << name_of(formulation);
        EXPECT_LT(panel.hourglass, 0.01) << name_of(formulation);
        EXPECT_EQ(panel.hourglass == 0., formulation == ShellFormulation::fully_integrated);
      }
  }

  // The benchmark's 4 % of the peer's peaks on 192 elements.
  TEST(ShellImpulse, SphericalCap)
  {
    for (const auto formulation : all_formulations)
      {
        const double plastic = largest_cap_deflection(8, true, formulation);
        const double elastic = largest_cap_deflection(8, false, formulation);
        record(std::string(name_of(formulation)) + " plastic", plastic);
        record(std::string(name_of(formulation)) + " elastic", elastic);
        EXPECT_NEAR(plastic / 0.0712, 1., 0.04) << name_of(formulation);
        EXPECT_NEAR(elastic / 0.0922, 1., 0.04) << name_of(formulation);
      }
  }
} // namespace shell_impulse_test
