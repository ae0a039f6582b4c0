#include "../record.h"
#include "solid_round_meshes.h"
#include "solid_statics.h"

#include <birdstrike/material/radial_return.h>

#include <gtest/gtest.h>

namespace solid_spin_test
{
  using namespace solid_harness;

  /// Bodies that turn (benchmark B6): E = 113.8 GPa, nu = 0.342, 4430 kg/m^3.
  namespace
  {
    constexpr double young = 113.8e9, poisson = 0.342, density = 4430.;

    const auto formulations = {SolidFormulation::one_point, SolidFormulation::b_bar};

    SolidSection titanium(const SolidFormulation formulation, const HardeningLaw law = HardeningLaw::elastic)
    {
      SolidSection section               = make_section(young, poisson, formulation);
      section.material.density           = density;
      section.material.hardening.law     = law;
      section.material.hardening.yield   = 880e6;
      section.material.hardening.modulus = 1e9;
      return section;
    }

    void set_spinning(Motion &motion, const Point3 &omega, const Point3 &centre, const Point3 &velocity)
    {
      for (std::size_t n = 0; n < motion.model.mesh.nodes.size(); ++n)
        motion.velocity.segment<3>(3 * n) += omega.cross(Point3(&motion.model.position[3 * n]) - centre) + velocity;
    }

    /// At the whole step, about the centre of mass at `centre` moving with `velocity`.
    Point3 angular_momentum(const Motion &motion, const Point3 &centre, const Point3 &velocity)
    {
      Point3 sum = Point3::Zero();
      for (std::size_t n = 0; n < motion.model.mesh.nodes.size(); ++n)
        {
          const Point3 v =
            motion.velocity.segment<3>(3 * n) + 0.5 * motion.last_dt / motion.mass[n] * motion.force.segment<3>(3 * n);
          sum += motion.mass[n] * (Point3(&motion.model.position[3 * n]) - centre).cross(v - velocity);
        }
      return sum;
    }

    double von_mises_stress(const SolidState &state)
    {
      double s[6];
      std::copy(state.stress.begin(), state.stress.end(), s);
      return von_mises(s);
    }

    struct Spin
    {
      double energy_error, momentum_error, peak; ///< -, -, largest von Mises stress of an element's mean (Pa)
    };
    /// Five turns of a stress-free cube of 20 mm, 2^3 bricks, half a degree a step.
    Spin spin(const double omega, const Point3 &axis, const Point3 &velocity, const SolidFormulation formulation)
    {
      Model        model(make_box({2, 2, 2}, Point3::Constant(0.02)), titanium(formulation));
      Motion       motion(model);
      const Point3 centre = Point3::Constant(0.01);
      const double dt     = 0.52 * M_PI / 180. / 2e4;
      set_spinning(motion, omega * axis, centre, Point3::Zero());
      const double rotation = motion.kinetic_energy();
      set_spinning(motion, Point3::Zero(), centre, velocity);
      const double initial  = motion.kinetic_energy();
      const Point3 momentum = angular_momentum(motion, centre, velocity);
      Spin         result{};
      const int    n_steps = int(5. * 2. * M_PI / (omega * dt));
      for (int i = 1; i <= n_steps; ++i)
        {
          motion.step(dt);
          result.energy_error = std::max(result.energy_error, std::abs(motion.total_energy() - initial) / rotation);
          if (i % 10 > 0)
            continue;
          for (std::size_t e = 0; e < 8; ++e)
            result.peak = std::max(result.peak, von_mises_stress(model.elements.state(e)));
          const Point3 now      = angular_momentum(motion, centre + i * dt * velocity, velocity);
          result.momentum_error = std::max(result.momentum_error, (now - momentum).norm() / momentum.norm());
        }
      return result;
    }
  } // namespace

  // The peer: 5.7e-4 and 5.7e-6 of the energy at 2e4 and 2e3 rad/s, 1e-14 of the angular momentum, and 176.96 MPa: the
  // stress-free cube rings about its static stretch, so that its peak is near twice rho w^2 R^2/2 = 88.6 MPa. Measured
  // with either element: 8.3e-5, 8.2e-7, 3e-14, 176.81 MPa about both axes, at rest and in flight.
  TEST(SolidSpin, ACubeKeepsItsEnergyAboutAnyAxisAndInFlight)
  {
    for (const auto formulation : formulations)
      {
        for (const Point3 &axis : {Point3(0., 0., 1.), Point3(Point3(1., 1., 1.).normalized())})
          for (const Point3 &velocity : {Point3(0., 0., 0.), Point3(500., 0., 0.)})
            {
              const Spin found = spin(2e4, axis, velocity, formulation);
              record("energy " + std::to_string(int(formulation)), found.energy_error);
              record("peak " + std::to_string(int(formulation)), found.peak);
              EXPECT_LT(found.energy_error, 2e-4);
              EXPECT_LT(found.momentum_error, 1e-12);
              EXPECT_NEAR(found.peak / 176.96e6, 1., 0.005);
            }
        EXPECT_LT(spin(2e3, Point3(0., 0., 1.), Point3(0., 0., 0.), formulation).energy_error, 2e-6);
      }
  }

  // The same cube, stretched beyond yield while it turns ten times: a stressed, flowing block keeps its energy within
  // the tenth of a percent that is asked. What is seen of the error is that of the first blow, dt^2 f^2/(8 m) in the
  // kinetic energy at whole steps, not of the turns: it does not grow.
  TEST(SolidSpin, AStressedBlockKeepsItsEnergy)
  {
    for (const auto formulation : formulations)
      {
        Model        model(make_box({2, 2, 2}, Point3::Constant(0.02)), titanium(formulation, HardeningLaw::linear));
        Motion       motion(model);
        const Point3 centre = Point3::Constant(0.01);
        const int    n_turn = 2769;
        const double dt     = 2. * M_PI / n_turn / 2e4;
        set_spinning(motion, 2e4 * Point3(1., 1., 1.).normalized(), centre, Point3::Zero());
        for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
          motion.velocity[3 * n] += 1.2e4 * (model.mesh.nodes[n][0] - centre[0]);
        const double initial = motion.kinetic_energy();
        double       first = 0., worst = 0., last = 0., by_work = 0.;
        for (int i = 0; i < 10 * n_turn; ++i)
          {
            motion.step(dt);
            const double error = std::abs(motion.total_energy() / initial - 1.);
            worst              = std::max(worst, error);
            by_work = std::max(by_work, std::abs((motion.kinetic_energy() + model.elements.work()) / initial - 1.));
            (i < n_turn ? first : last) = std::max(i < n_turn ? first : last, error);
          }
        EXPECT_LT(by_work, 1e-3);
        EXPECT_LT(worst, 5e-3) << "stored and plastic energy of the first blow, which flows within few steps: 0.4 %";
        EXPECT_LE(last, first);
        EXPECT_GT(model.elements.plastic_work(), 0.05 * initial);
      }
  }

  // A bar that turns about its middle at 1000 rad/s in its static stretch: rho w^2 R^2/2 = 22.15 MPa in the middle,
  // each end 12.976 um further out, R = 0.1 m; n lumped elements to either side find 1 + 1/(2 n^2) of that. Started in
  // this state it must stay there: within a thousandth of its stretch over two turns, 8000 steps each.
  TEST(SolidSpin, ABarTurnsInItsStaticStretch)
  {
    const double omega = 1000., half = 0.1, stretch = 1.2976e-5;
    const int    n = 20;
    for (const auto formulation : formulations)
      {
        SolidSection section                = titanium(formulation);
        section.material.elasticity.poisson = 0.;
        const Mesh        mesh = make_grid({2 * n, 1, 1}, [half](const double x, const double y, const double z) {
          return Point3(half * (2. * x - 1.), 0.005 * (y - 0.5), 0.005 * (z - 0.5));
        });
        Model             model(mesh, section);
        const auto        mass = model.elements.compute_nodal_masses();
        std::vector<bool> held(model.n_dofs(),
                               true); // across the bar: a section's own stretch is (5/200)^2 of the bar's
        Eigen::VectorXd   load = Eigen::VectorXd::Zero(model.n_dofs());
        for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
          {
            load[3 * k] = mass[k] * omega * omega * mesh.nodes[k][0];
            held[3 * k] = std::abs(mesh.nodes[k][0]) < 1e-9;
          }
        const Eigen::VectorXd u = solve_by_gradients(mesh, section, load, held);
        EXPECT_NEAR(u[3 * 2 * n] / stretch, 1. + 0.5 / (n * n), 1e-4);
        Motion motion(model);
        motion.force        = model.move(u);
        const double middle = 0.5 * (model.elements.state(n - 1).stress[0] + model.elements.state(n).stress[0]);
        EXPECT_NEAR(middle / 22.15e6, 1., 1e-3);
        set_spinning(motion, Point3(0., 0., omega), Point3::Zero(), Point3::Zero());
        const double initial = motion.total_energy(), dt = 0.8 * model.elements.largest_stable_step();
        double       least = 2., largest = 0., worst = 0.;
        for (double t = 0.; t < 2. * 2. * M_PI / omega; t += dt)
          {
            motion.step(dt);
            const Point3 a(&model.position[0]), b(&model.position[3 * 2 * n]);
            const double now = (0.5 * (b - a).norm() - half) / stretch;
            least            = std::min(least, now);
            largest          = std::max(largest, now);
            worst            = std::max(worst, std::abs(motion.total_energy() / initial - 1.));
          }
        EXPECT_NEAR(least, 1. + 0.5 / (n * n), 1e-3);
        EXPECT_NEAR(largest, 1. + 0.5 / (n * n), 1e-3);
        EXPECT_LT(worst, 1e-8);
      }
  }

  // A thin disc of radius 0.1 m at 1000 rad/s, a quarter: (3 + nu)/8 rho w^2 R^2 = 18.506 MPa in the middle in both
  // directions, 6.4036 um at the rim; order 2 (the stress of the B-bar's corner is exact from the start).
  TEST(SolidSpin, ADiscHasItsCentrifugalStress)
  {
    const auto compute_errors = [](const unsigned int n, const SolidFormulation formulation) {
      const Mesh        mesh = make_quarter_cylinder(n, 1, 0.1, 0.1 / (2. * n));
      Model             model(mesh, titanium(formulation));
      const auto        mass = model.elements.compute_nodal_masses();
      std::vector<bool> held(model.n_dofs(), false);
      Eigen::VectorXd   load = Eigen::VectorXd::Zero(model.n_dofs());
      std::size_t       rim  = 0;
      for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
        {
          const Point3 &x = mesh.nodes[k];
          for (int c = 0; c < 3; ++c)
            {
              held[3 * k + c] = x[c] < 1e-9;
              load[3 * k + c] = c < 2 ? mass[k] * 1e6 * x[c] : 0.;
            }
          if (x[0] > 0.1 - 1e-9)
            rim = k;
        }
      const Eigen::VectorXd u = model.solve(load, held);
      Model                 loaded(mesh, titanium(formulation));
      loaded.move(1e-6 * u);
      const auto s = loaded.elements.corner_stress(0, 0);
      EXPECT_NEAR(s[0] / s[1], 1., 1e-3);
      return std::array{std::abs(u[3 * rim] / 6.4036e-6 - 1.), std::abs(1e6 * s[0] / 18.506e6 - 1.)};
    };
    for (const auto formulation : formulations)
      {
        const auto coarse = compute_errors(6, formulation), fine = compute_errors(12, formulation);
        EXPECT_LT(fine[0], 1e-3);
        EXPECT_LT(fine[1], 1e-3);
        EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 2., 0.2);
      }
  }
} // namespace solid_spin_test
