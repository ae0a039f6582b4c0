#include "contact/law.h"

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  /// A millimetre of water at a hundred metres a second, a step so short that no limit acts.
  Touch<double> water_at(const double speed, const double hugoniot_slope = 1.92)
  {
    Touch<double> touch;
    touch.penetration  = 0.;
    touch.size         = 1e-3;
    touch.modulus      = 1000. * 1480. * 1480.;
    touch.hardening    = 4. / 3. * hugoniot_slope;
    touch.density      = 1000.;
    touch.sound_speed  = 1480.;
    touch.reduced_mass = 1e-6;
    touch.normal       = Point3(0., 0., 1.);
    touch.velocity     = Point3(0., 0., -speed);
    return touch;
  }
} // namespace

TEST(ContactLaw, FirstTouchGivesTheHugoniotPressure)
{
  const ContactLaw law{1., 1., 0., 1.92, 1e-9};
  for (const double speed : {50., 200., 350.})
    {
      const auto force = compute_contact_force(law, water_at(speed));
      EXPECT_NEAR(force.force[2] / 1e-6, 1000. * (1480. + 1.92 * speed) * speed, 1e-6); // rho U_s u, Pa; round-off
      EXPECT_EQ(force.dissipative, force.force);
      EXPECT_EQ(force.stored_energy, 0.);
    }
}

TEST(ContactLaw, NoForcePullsAndNoDamperActsOnTheWayOut)
{
  const ContactLaw law{1., 1., 0., 0., 1e-9};
  auto             touch = water_at(-100., 0.);
  EXPECT_EQ(compute_contact_force(law, touch).normal_force, 0.);
  touch.penetration = 1e-5;
  EXPECT_NEAR(compute_contact_force(law, touch).normal_force, 1000. * 1480. * 1480. * 1e-3 * 1e-5, 1e-9);
}

TEST(ContactLaw, ForceAndTangentAreDerivativesOfTheEnergy)
{
  // central differences over the tangent's continuation at y = 3/4 and beyond; their error is of second order
  for (const double beta : {0., 3000.})
    for (const double depth : {1e-6, 1e-4, 2.4e-4, 2.6e-4, 5e-4})
      {
        const double                h = 1e-10;
        const ContactSpring<double> spring(1e6, beta, depth), less(1e6, beta, depth - h), more(1e6, beta, depth + h);
        EXPECT_NEAR((more.energy - less.energy) / (2. * h) / spring.force, 1., 1e-5) << beta << " " << depth;
        EXPECT_NEAR((more.force - less.force) / (2. * h) / spring.tangent, 1., 1e-5) << beta << " " << depth;
      }
}

// Even motion into a linear spring, wherever the step begins in which it is touched, and out of it: kicks with the
// force at the ends of steps do the spring's work and give the impulse of its force in time.
TEST(ContactLaw, StepsInWhichATouchBeginsOrEndsDoTheWorkOfTheSpring)
{
  const double     k = 1000. * 1480. * 1480. * 1e-3, speed = 10., step = 1e-8, way = speed * step;
  const ContactLaw law{1., 0., 0., 0., step};
  for (const double direction : {1., -1.})
    for (const double share : {0.01, 0.3, 0.5, 0.99}) // of a step, inside
      {
        const double depth   = share * way;
        double       impulse = 0.;
        for (const double d : {depth, depth + way}) // whole kicks; the second ends half a step early
          {
            auto touch        = water_at(direction * speed, 0.);
            touch.penetration = d;
            impulse += compute_contact_force(law, touch).force[2] * (d > way ? 0.5 : 1.) * step;
          }
        const double last = depth + way;
        EXPECT_NEAR(impulse * speed / (0.5 * k * last * last), 1., 1e-12) << direction << " " << share;
      }
}

// A point flies on a wall at phases omega dt of liquids, with the damper: what it has lost when it is back is what the
// damper booked. With whole forces in the steps of touch and parting, 2 and 3 % of its energy would be gone unbooked.
TEST(ContactLaw, APointThatBouncesHasLostWhatItsDamperTook)
{
  const double mass = 1e-6, speed = 100., frequency = 1480. / 1e-3;
  for (const double phase : {0.45, 0.6})
    {
      const double     step = phase / frequency;
      const ContactLaw law{1., 0.3, 0., 1.92, step};
      double           missing  = 0.; // of the energy, mean over where the step of the touch begins
      const int        n_starts = 50;
      for (int i = 0; i < n_starts; ++i)
        {
          auto   touch      = water_at(speed);
          double taken      = 0.;
          touch.penetration = -(i + 0.5) / n_starts * speed * step;
          for (int n = 0; n < 40; ++n)
            {
              touch.penetration -= touch.velocity[2] * step;
              if (touch.penetration <= 0.)
                continue;
              const auto   force  = compute_contact_force(law, touch);
              const double before = touch.velocity[2];
              touch.velocity[2] += force.force[2] / mass * step;
              taken -= 0.5 * step * force.dissipative[2] * (before + touch.velocity[2]);
            }
          EXPECT_GT(touch.velocity[2], 0.2 * speed);
          missing +=
            (1. - (taken + 0.5 * mass * touch.velocity[2] * touch.velocity[2]) / (0.5 * mass * speed * speed)) /
            n_starts;
        }
      EXPECT_NEAR(missing, 0., 0.002) << phase;
    }
}

TEST(ContactLaw, SpringFollowsTheHugoniotCurveOfTheLiquid)
{
  // p = rho0 c0^2 eta/(1 - s eta)^2, eta = d/L. Equal to second order: with x = s eta,
  // (1 - 2x/3)/(1 - 4x/3)^2 (1 - x)^2 = 1 + (2/3) x^2 + ..., 1.6 % at 0.07, and stiffer beyond.
  const double s = 2.2, size = 2e-3, modulus = 1e9;
  for (const double eta : {0.001, 0.01, 0.03, 0.07, 0.15, 0.25})
    {
      const ContactSpring<double> spring(modulus * size, 4. / 3. * s / size, eta * size);
      const double                hugoniot = modulus * eta / ((1. - s * eta) * (1. - s * eta));
      const double                excess = spring.force / (size * size) / hugoniot - 1., x = s * eta;
      EXPECT_GE(excess, -1e-12) << eta;
      if (eta < 0.1)
        {
          EXPECT_LE(excess, x * x) << eta;
        }
    }
}

TEST(ContactLaw, SpringCarriesTheShockOfAFastStrikeThreeTenthsOfACellDeep)
{
  // K (1/V - 1), whose shocks run at U with U (U - u) = c^2, so that s = 1/2 to first order: at 820 m/s against c =
  // 1483 m/s the shock's pressure is 0.73 rho0 c0^2, which the cell's own curve meets 0.43 L deep
  const double size = 2e-3, modulus = 2.2e9;
  ContactLaw   law{1., 1., 0., 0.5, 1e-9};
  for (const double p : {0., 0.05, 0.2, 0.42})
    {
      law.shock_pressure = p;
      EXPECT_EQ(law.hardening(), 4. / 3. * 0.5) << p;
    }
  for (const double p : {0.43, 0.73, 1.1, 2.})
    {
      law.shock_pressure = p;
      const ContactSpring<double> spring(modulus * size, law.hardening() / size, 0.3 * size);
      EXPECT_NEAR(spring.force / (size * size * modulus), p, 1e-9) << p;
      EXPECT_GT(law.hardening(), 4. / 3. * 0.5) << p;
    }
}

TEST(ContactLaw, ASpringThatALightTargetHasSoftenedCarriesTheShockNoDeeper)
{
  // with a sixth of the modulus a shock of 0.3 rho0 c0^2 would go 0.7 L deep
  const double size = 2e-3, liquid = 2.2e9;
  ContactLaw   law{1., 1., 0., 0.5, 1e-9};
  for (const double p : {0.05, 0.1, 0.3})
    for (const double softening : {1.5, 3., 6.})
      {
        law.shock_pressure                  = p;
        const double                modulus = liquid / softening;
        const ContactSpring<double> spring(modulus * size, law.hardening(softening) / size, 0.3 * size);
        const double                carried = spring.force / (size * size * liquid);
        EXPECT_GE(carried, p * (1. - 1e-9)) << p << " " << softening;
        if (p * softening > 0.43)
          {
            EXPECT_NEAR(carried, p, 1e-9) << softening;
          }
        else
          {
            EXPECT_EQ(law.hardening(softening), law.hardening());
          }
      }
}

TEST(ContactLaw, TheStepBoundsTheDamper)
{
  const ContactLaw law{1., 1., 0., 1.92, 1e-5};
  EXPECT_NEAR(compute_contact_force(law, water_at(100.)).normal_force, 1e-6 * 100. / 1e-5, 1e-12); // does not reverse
}

// On a tapered plate the depth grows faster than the way along the normal (thickness_slope.h).
TEST(ContactLaw, AlongASteepGradientTheDamperDoesNotReverseAndTheSpringIsStiffer)
{
  auto touch        = water_at(100.);
  touch.penetration = 1e-5;
  const auto level  = compute_contact_force({1., 0., 0., 1.92, 1e-9}, touch);
  touch.normal      = Point3(0.3, 0., 1.);
  const auto steep  = compute_contact_force({1., 0., 0., 1.92, 1e-9}, touch);
  EXPECT_NEAR((steep.force - level.force[2] * touch.normal).norm(), 0., 1e-12 * level.force.norm()); // -grad U
  EXPECT_EQ(steep.stored_energy, level.stored_energy);
  EXPECT_NEAR(steep.tangent, 1.09 * level.tangent, 1e-12 * level.tangent);

  touch.penetration = 0.;
  const double step = 1e-5;
  const auto   stop = compute_contact_force({1., 1., 0., 1.92, step}, touch);
  const Point3 left = touch.velocity + step / touch.reduced_mass * stop.force;
  EXPECT_NEAR(left.dot(touch.normal), 0., 1e-10);
}

TEST(ContactLaw, DampersThatShareANodeOnlyTakeEnergy)
{
  // n points of 1 g at different speeds hit one free node of 1 mg: each alone may stop itself against the node, all
  // together would throw it back n times as fast.
  const double     node_mass = 1e-6, step = 1e-5;
  const ContactLaw law{1., 1e6, 0., 0., step}; // a damper that its bound rules
  for (const unsigned int n : {1u, 10u, 1000u})
    {
      double before = 0., points_after = 0., node_impulse = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          auto         touch = water_at(10. + i % 7);
          const double mass = 1e-3, speed = 10. + i % 7;
          touch.reduced_mass   = compute_reduced_mass(1. / mass, {1., 0., 0., 0.}, {n / node_mass, 0., 0., 0.});
          const double impulse = step * compute_contact_force(law, touch).force[2];
          before += 0.5 * mass * speed * speed;
          points_after += 0.5 * mass * (speed - impulse / mass) * (speed - impulse / mass);
          node_impulse += impulse;
        }
      const double node_speed = node_impulse / node_mass;
      EXPECT_LE(node_speed, 16.) << n; // no faster than the fastest point
      EXPECT_LE(points_after + 0.5 * node_mass * node_speed * node_speed, before) << n;
    }
}

TEST(ContactLaw, FrictionIsCoulombsUntilItWouldReverseTheSlip)
{
  const ContactLaw law{1., 1., 0.3, 1.92, 1e-7};
  auto             touch = water_at(10.);
  touch.velocity[0]      = 50.;
  const auto sliding     = compute_contact_force(law, touch);
  EXPECT_NEAR(sliding.force[0], -0.3 * sliding.normal_force, 1e-12);
  touch.velocity[0] = 1e-3;
  EXPECT_NEAR(compute_contact_force(law, touch).force[0], -1e-6 * 1e-3 / 1e-7, 1e-12);
}

TEST(ContactLaw, ReducedMassOfAPointOverTheMiddleOfAFacet)
{
  // four nodes of m_n / 4, each the point's own by a quarter of their weights' sum 1/4, move as one mass m_n
  const std::array<double, 4> weights{0.25, 0.25, 0.25, 0.25}, inverse{100., 100., 100., 100.};
  EXPECT_NEAR(compute_reduced_mass(1. / 0.02, weights, inverse), 0.02 * 0.01 / 0.03, 1e-17);
  EXPECT_EQ(compute_reduced_mass(1. / 0.02, weights, std::array<double, 4>{}), 0.02);
}
