#include <birdstrike/contact/law.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  /// A millimetre of water at a hundred metres a second, a step so short that no limit acts.
  Touch<double> water_at(const double speed)
  {
    Touch<double> touch;
    touch.penetration  = 0.;
    touch.size         = 1e-3;
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
  const ContactLaw law{1., 1., 0.4, 0., 1.92, 1e-9};
  for (const double speed : {50., 200., 350.})
    {
      const auto force = compute_contact_force(law, water_at(speed));
      EXPECT_NEAR(force.force[2] / 1e-6, 1000. * (1480. + 1.92 * speed) * speed, 1e-6); // rho U_s u, Pa; round-off
      EXPECT_NEAR(force.dissipation_power, force.force[2] * speed, 1e-9);
      EXPECT_EQ(force.stored_energy, 0.);
    }
}

TEST(ContactLaw, NoForcePullsAndNoDamperActsOnTheWayOut)
{
  const ContactLaw law{1., 1., 0.4, 0., 1.92, 1e-9};
  auto             touch = water_at(-100.);
  EXPECT_EQ(compute_contact_force(law, touch).normal_force, 0.);
  touch.penetration = 1e-5;
  EXPECT_NEAR(compute_contact_force(law, touch).normal_force, 1000. * 1480. * 1480. * 1e-3 * 1e-5, 1e-9);
}

TEST(ContactLaw, StepBoundsStiffnessAndDamper)
{
  const ContactLaw law{1., 1., 0.4, 0., 1.92, 1e-5};
  auto             touch = water_at(100.);
  EXPECT_NEAR(compute_contact_force(law, touch).normal_force, 1e-6 * 100. / 1e-5, 1e-12); // stops, does not reverse
  touch             = water_at(0.);
  touch.penetration = 1e-4;
  EXPECT_NEAR(compute_contact_force(law, touch).normal_force, 0.4 * 1e-6 / 1e-10 * 1e-4, 1e-12);
}

TEST(ContactLaw, FrictionIsCoulombsUntilItWouldReverseTheSlip)
{
  const ContactLaw law{1., 1., 0.4, 0.3, 1.92, 1e-7};
  auto             touch = water_at(10.);
  touch.velocity[0]      = 50.;
  const auto sliding     = compute_contact_force(law, touch);
  EXPECT_NEAR(sliding.force[0], -0.3 * sliding.normal_force, 1e-12);
  touch.velocity[0] = 1e-3;
  EXPECT_NEAR(compute_contact_force(law, touch).force[0], -1e-6 * 1e-3 / 1e-7, 1e-12);
}

TEST(ContactLaw, ReducedMassOfAPointOverTheMiddleOfAFacet)
{
  // four nodes of m_n / 4 with weights 1/4 move as one mass m_n
  const std::array<double, 4> weights{0.25, 0.25, 0.25, 0.25}, inverse{400., 400., 400., 400.};
  EXPECT_NEAR(compute_reduced_mass(0.02, weights, inverse), 0.02 * 0.01 / 0.03, 1e-17);
  EXPECT_EQ(compute_reduced_mass(0.02, weights, std::array<double, 4>{}), 0.02);
}
