#include "blade_case.h"

#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The force of the root is what the blade exerts on its support: also what acts on the held row of nodes itself.
namespace birdstrike::support_force_test
{
  namespace
  {
    constexpr double length = 0.3, chord = 0.02, thickness = 0.004, density = 2700., young = 70e9;

    BladeParameters plate(const BladeKind kind, const unsigned int n_span)
    {
      BladeParameters p   = test::elastic_plate(n_span, 2);
      p.kind              = kind;
      p.mesh.length       = length;
      p.mesh.chord        = chord;
      p.thickness.value   = std::to_string(thickness);
      p.material.density  = "2700";
      p.material.young    = "70e9";
      p.material.poisson  = "0";
      p.mesh.n_layers     = 1;
      p.spin.n_load_steps = 1;
      p.element.formulation =
        kind == BladeKind::solid ? element_formulations().at("solid-shell") : element_formulations().at("physical");
      return p;
    }

    /// On a hub of half a metre, 1500 rad/s about an axis between edgewise and flatwise.
    BladeParameters on_hub(const BladeKind kind, const unsigned int n_span)
    {
      BladeParameters p = plate(kind, n_span);
      p.spin.speed      = "1500";
      p.spin.axis       = {0., -3., 4.};
      p.spin.centre     = {-0.5, 0., 0.};
      return p;
    }

    /// Tension of a bar that rotates at the radius a: E u'' + rho w^2 (a + x + u) = 0, u(0) = u'(L) = 0.
    double tension_of_bar(const double a, const double speed)
    {
      const double k = speed * std::sqrt(density / young), phase = k * length;
      return young * chord * thickness * ((1. + a * k * std::sin(phase)) / std::cos(phase) - 1.);
    }

    constexpr std::array<BladeKind, 2> kinds{{BladeKind::shell, BladeKind::solid}};
  } // namespace

  // Second order in the size of elements, and the strain of 1.5 % squared: 3e-4 with ten elements, where the forces of
  // the elements alone are 4 % short.
  TEST(SupportForce, OfARotatingBarIsItsWholeTension)
  {
    ThreadPool pool(1);
    for (const BladeKind kind : kinds)
      for (const unsigned int n_span : {10U, 40U})
        {
          const auto blade = make_blade(on_hub(kind, n_span), pool);
          EXPECT_NEAR(blade->root_section().normal_force / tension_of_bar(0.5, 1500.), 1., 4e-4) << n_span;
        }
  }

  // m w^2 times the radius of the centre of mass where nothing stretches: 5 rad/s.
  TEST(SupportForce, OfAStiffBladeIsThatOfItsCentreOfMass)
  {
    ThreadPool pool(1);
    for (const BladeKind kind : kinds)
      for (const unsigned int n_span : {1U, 3U, 10U})
        {
          BladeParameters p  = on_hub(kind, n_span);
          p.spin.speed       = "5";
          p.spin.axis        = {0., 0., 1.};
          const double force = density * length * chord * thickness * 25. * 0.65;
          EXPECT_NEAR(make_blade(p, pool)->root_section().normal_force / force, 1., 1e-6) << n_span;
        }
  }

  // q L b and q L^2 b/2, however few elements; of half a plate and of bricks the same. The bent plate's own shortening
  // is of the order 1e-10.
  TEST(SupportForce, OfAPlateUnderPressureIsAllOfIt)
  {
    ThreadPool   pool(1);
    const double pressure = 1., force = pressure * length * chord;
    for (const BladeKind kind : kinds)
      for (const bool is_halved : {false, true})
        for (const unsigned int n_span : {4U, 24U})
          {
            BladeParameters p = plate(kind, n_span);
            p.is_halved       = is_halved;
            p.loads.pressure  = "1";
            const auto blade  = make_blade(p, pool);
            blade->find_equilibrium();
            const RootSectionReport root = blade->root_section();
            EXPECT_NEAR(std::abs(root.transverse_force) / force, 1., 1e-6) << n_span << is_halved;
            EXPECT_NEAR(std::abs(root.bending_moment) / (0.5 * force * length), 1., 1e-5) << n_span << is_halved;
          }
  }

  // The impulse of a support that rests changes in a step by the mean of the forces at its ends, to round-off: of
  // leapfrog that is what both half kicks give. With a pressure that changes and a force on the held row itself.
  TEST(SupportForce, IsTheRateOfTheSupportImpulse)
  {
    for (const BladeKind kind : kinds)
      {
        BladeParameters p        = plate(kind, 12);
        p.loads.pressure         = "1e4*(1 + sin(2e4*t))*(1 + 3*x)";
        p.loads.initial_velocity = "0; 0; 20*(x/0.3)^2";
        p.loads.point_loads      = "0 0 0: 30*t/1e-3; 0; 500*sin(1e4*t)";
        ThreadPool        pool(1);
        const auto        blade = make_blade(p, pool);
        const double      dt    = 0.8 * blade->step_limit().value;
        RootSectionReport before;
        double            largest = 0.;
        for (unsigned int k = 0; k < 200; ++k)
          {
            const auto impulse = blade->momenta().support_impulse;
            test::advance(*blade, dt, 1);
            const RootSectionReport now   = blade->root_section();
            const auto              after = blade->momenta().support_impulse;
            largest                       = std::max(largest, std::abs(now.transverse_force));
            if (k > 0)
              {
                EXPECT_NEAR((after[0] - impulse[0]) / dt, 0.5 * (before.normal_force + now.normal_force),
                            1e-9 * largest);
                EXPECT_NEAR(std::abs(after[2] - impulse[2]) / dt,
                            0.5 * std::abs(before.transverse_force + now.transverse_force), 1e-9 * largest);
              }
            before = now;
          }
        EXPECT_GT(largest, 50.);
      }
  }

  // The hub spins up: in the frame of the hub the force is Newton's law of the whole blade, force on the support =
  // -d(momentum)/dt. Means over a step of the force along the span against the change of momentum, which has the
  // inertia of the held row: 1e-3 of the largest force.
  TEST(SupportForce, OfAHubThatSpinsUpIsNewtonsLaw)
  {
    for (const BladeKind kind : kinds)
      {
        BladeParameters p = on_hub(kind, 10);
        p.spin.axis       = {0., 0., 1.};
        p.spin.speed      = "300 + 2e5*t";
        ThreadPool   pool(1);
        const auto   blade = make_blade(p, pool);
        const double dt    = 0.5 * blade->step_limit().value;
        test::advance(*blade, dt, 50);
        double largest = 0.;
        for (unsigned int k = 0; k < 50; ++k)
          {
            const auto   before = blade->momenta();
            const double at     = blade->root_section().normal_force;
            test::advance(*blade, dt, 1);
            const auto              after = blade->momenta();
            const RootSectionReport now   = blade->root_section();
            // root axes turn by the angle of the hub at the middle of the step
            const double t = (50.5 + k) * dt, angle = 300. * t + 1e5 * t * t;
            const double fx = -(after.momentum[0] - before.momentum[0]) / dt,
                         fy = -(after.momentum[1] - before.momentum[1]) / dt;
            largest         = std::max(largest, now.normal_force);
            EXPECT_NEAR(0.5 * (at + now.normal_force), std::cos(angle) * fx + std::sin(angle) * fy, 1e-3 * largest);
          }
        EXPECT_GT(largest, 1000.);
      }
  }
} // namespace birdstrike::support_force_test
