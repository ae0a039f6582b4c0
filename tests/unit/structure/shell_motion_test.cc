#include "../record.h"
#include "shell_motion.h"

#include <gtest/gtest.h>

namespace shell_motion_test
{
  using namespace shell_harness;

  namespace
  {
    struct Spin
    {
      double energy_error;    ///< largest, relative
      double stretch;         ///< of the span, at the end
      double internal_energy; ///< largest, over the kinetic energy
    };

    /// Spins the stress-free blade plate about an axis for three revolutions.
    Spin spin(const Point3 &axis, const ShellFormulation formulation)
    {
      ShellSection section     = make_section(113.8e9, 0.342, formulation);
      section.material.density = 4430.;
      const Mesh mesh          = make_grid(
                 14, 4, [](const double x, const double y) { return Point3(0.3112 * (x - 0.5), 0.0889 * (y - 0.5), 0.); });
      Motion       motion(mesh, 4.27e-3, section);
      const double omega = 2000.;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          motion.velocity.segment<3>(6 * n)     = (omega * axis).cross(mesh.nodes[n]);
          motion.velocity.segment<3>(6 * n + 3) = omega * axis;
        }
      const double start = motion.kinetic_energy();
      Spin         result{0., 0., 0.};
      const int    n = int(3. * 2. * pi / omega / motion.dt);
      for (int i = 0; i < n; ++i)
        {
          motion.step(Eigen::VectorXd::Zero(motion.model.n_dofs()), 0., {});
          if (i % 20 == 0 || i == n - 1)
            {
              const auto  &e         = motion.model.elements;
              const double internal  = e.elastic_energy() + e.hourglass_energy() + e.plastic_work();
              const double error     = std::abs((motion.kinetic_energy() + internal) / start - 1.);
              result.energy_error    = std::max(result.energy_error, error);
              result.internal_energy = std::max(result.internal_energy, internal / start);
            }
        }
      const double *x = motion.model.position.data(), *y = x + 3 * 14;
      result.stretch = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) / 0.3112 - 1.;
      return result;
    }

    /// Cantilever strip along x, dynamic relaxation to rest under a tip moment (ramped) or a dead tip force along z.
    std::array<double, 2> strip_at_rest(const double L, const unsigned int n, const double moment, const double force_z,
                                        const ShellFormulation formulation)
    {
      const double b = 1., t = 0.1;
      const Mesh   mesh = make_grid(n, 1, [=](const double x, const double y) { return Point3(L * x, b * y, 0.); });
      Motion       motion(mesh, t, make_section(1.2e6, 0., formulation));
      auto        &model = motion.model;
      std::vector<bool> held(model.n_dofs(), false);
      for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        {
          held[6 * node + 1] = held[6 * node + 3] = held[6 * node + 5] = true; // a plane problem
          if (node % (n + 1) == 0)
            held[6 * node] = held[6 * node + 2] = held[6 * node + 4] = true;
        }
      // first bending mode of the straight strip, critically damped
      const double    rate    = 2. * 3.516 * std::sqrt(1.2e6 * t * t / 12.) / (L * L);
      const double    rest    = 40. / rate;
      const int       n_steps = int(rest / motion.dt);
      Eigen::VectorXd load    = Eigen::VectorXd::Zero(model.n_dofs());
      for (int i = 0; i < n_steps; ++i)
        {
          const double share = std::min(1., 3. * i / n_steps);
          for (const std::size_t node : {std::size_t(n), std::size_t(2 * n + 1)})
            {
              load[6 * node + 4] = -0.5 * share * moment;
              load[6 * node + 2] = 0.5 * share * force_z;
            }
          motion.step(load, rate, held);
        }
      const double *tip = &model.position[3 * n];
      return {(L - tip[0]) / L, tip[2] / L};
    }
  } // namespace

  // The trap: strain rates on end-of-step geometry shrink the plate by 6.6 % in three turns and cost 15 % of its
  // energy. On midpoint geometry it stretches by what physics asks: rho w^2 L^2/(12 E) = 1.26e-3 at rest, up to twice
  // that when the stress-free plate is set spinning at once (it then rings), and the energy stays within 4e-5.
  TEST(ShellMotion, ASpinningPlateKeepsItsEnergyAndItsLength)
  {
    for (const auto formulation : all_formulations)
      {
        for (const Point3 &axis : {Point3(0., 0., 1.), Point3(0., 1., 0.)})
          {
            const Spin result = spin(axis, formulation);
            record(std::string(name_of(formulation)) + (axis[2] > 0. ? " energy" : " edge energy"),
                   result.energy_error);
            record(std::string(name_of(formulation)) + (axis[2] > 0. ? " stretch" : " edge stretch"), result.stretch);
            EXPECT_LT(result.energy_error, 4e-5) << "axis " << axis.transpose();
            EXPECT_NEAR(result.stretch, 1.26e-3, 1.5e-3) << "axis " << axis.transpose();
            // at rest 1/2 E <e^2> = 3/5 E e_mean^2 is 1.51e-3 of the kinetic energy, at twice the stretch 6.06e-3
            EXPECT_LT(result.internal_energy, 6.2e-3);
          }
        EXPECT_LT(spin(Point3(1., 1., 1.).normalized(), formulation).energy_error, 4e-5);
      }
  }

  // u/L = 1 - sin(phi)/phi, w/L = (1 - cos(phi))/phi with phi = M L/(E I); the benchmark allows 0.5 % of L with 12
  // elements a circle, measured is 0.18 %
  TEST(ShellMotion, RollUp)
  {
    for (const auto formulation : covariant_formulations)
      for (const double share : {0.125, 0.25, 0.5, 0.75, 1., 2.})
        {
          const double phi = 2. * pi * share;
          const auto   tip = strip_at_rest(12., share > 1. ? 24 : 12, 52.35988 * share, 0., formulation);
          record(std::string(name_of(formulation)) + " error " + std::to_string(share).substr(0, 5),
                 std::hypot(tip[0] - 1. + std::sin(phi) / phi, tip[1] - (1. - std::cos(phi)) / phi));
          EXPECT_NEAR(tip[0], 1. - std::sin(phi) / phi, 2e-3) << name_of(formulation) << " " << share;
          EXPECT_NEAR(tip[1], (1. - std::cos(phi)) / phi, 2e-3) << name_of(formulation) << " " << share;
        }
  }

  // Exact elastica, alpha = P L^2/(E I): shortening and deflection over L
  TEST(ShellMotion, Elastica)
  {
    struct Case
    {
      double alpha, u, w;
    };
    for (const auto formulation : all_formulations)
      for (const Case &c : {Case{1., .056433, .301721}, Case{2., .160642, .493457}, Case{4., .328941, .669964},
                            Case{10., .554996, .810609}})
        {
          const auto tip = strip_at_rest(10., 20, 0., c.alpha * 1.2e6 * 1e-3 / 12. / 100., formulation);
          record(std::string(name_of(formulation)) + " u " + std::to_string(int(c.alpha)), tip[0]);
          record(std::string(name_of(formulation)) + " w " + std::to_string(int(c.alpha)), tip[1]);
          EXPECT_NEAR(tip[0] / c.u, 1., 5e-3) << name_of(formulation) << " " << c.alpha;
          EXPECT_NEAR(tip[1] / c.w, 1., 5e-3) << name_of(formulation) << " " << c.alpha;
        }
  }
} // namespace shell_motion_test
