#include <birdstrike/core/errors.h>
#include <birdstrike/structure/rotor.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike::rotor_test
{
  namespace
  {
    Rotor turning(const std::string &speed)
    {
      BladeParameters::Spin spin;
      spin.speed = speed;
      return Rotor(spin);
    }

    /// About z, rad, of a turn by less than half a turn.
    double angle_of(const Turn &turn)
    {
      const Point3 x = turn(Point3(1., 0., 0.));
      return std::atan2(x[1], x[0]);
    }
  } // namespace

  // Integrals in closed form: a shaft that runs down, one that hums, one that seizes between two whole pieces of time.
  TEST(Rotor, TurnsByTheIntegralOfItsSpeed)
  {
    const Rotor constant = turning("600"), falling = turning("600 - 2e4*t"), humming = turning("100*sin(700*t)"),
                seizing = turning("if(t<1.2345678e-3, 600, 0)");
    EXPECT_TRUE(constant.is_steady());
    EXPECT_FALSE(falling.is_steady());
    for (const double t : {3.1e-3, 0.4e-3, 1e-9, 2.7183e-3, 0.})
      {
        EXPECT_NEAR(angle_of(constant.turn(t)), 600. * t, 1e-14);
        EXPECT_NEAR(angle_of(falling.turn(t)), 600. * t - 1e4 * t * t, 1e-14) << t;
        EXPECT_NEAR(angle_of(humming.turn(t)), (1. - std::cos(700. * t)) / 7., 1e-14) << t;
        EXPECT_NEAR(angle_of(seizing.turn(t)), 600. * std::min(t, 1.2345678e-3), 1e-12) << t;
        EXPECT_NEAR(angle_of(falling.turn(1e-3, t)), 600. * (t - 1e-3) - 1e4 * (t * t - 1e-6), 1e-14) << t;
      }
    EXPECT_NEAR(falling.motion(2e-3).speed, 560., 1e-12);
    EXPECT_NEAR(falling.angular_acceleration(2e-3)[2], -2e4, 1e-2); // a difference of numbers of 600 over 1e-7 s
    EXPECT_EQ(constant.angular_acceleration(0.)[2], 0.);
    EXPECT_FALSE(turning("0").turns());
    EXPECT_FALSE(turning("").turns());
    EXPECT_TRUE(turning("1e5*t").turns());
  }

  // A resumed run asks later times first.
  TEST(Rotor, DoesNotRememberWhatWasAsked)
  {
    const std::string law   = "600*exp(-t/3e-3) + if(t>1e-3, 10, 0)";
    const Rotor       early = turning(law), late = turning(law);
    early.turn(0.33e-3);
    early.turn(1.77e-3);
    for (const double t : {4.21e-3, 0.5e-3})
      EXPECT_EQ(early.turn(t).rotation()[2], late.turn(t).rotation()[2]);
  }

  // w x (w x r) + a x r, and its integral twice in time by differences of the place.
  TEST(Rotor, AcceleratesAsItsPlacesDo)
  {
    BladeParameters::Spin spin;
    spin.speed  = "600 - 2e5*t";
    spin.axis   = {{1., 2., 2.}};
    spin.centre = {{0.1, 0., 0.}};
    const Rotor  rotor(spin);
    const double t = 0.7e-3, h          = 1e-6;
    const Point3 x(0.4, 0.2, -0.3), now = rotor.turn(t).carried(x);
    const Point3 before = rotor.turn(t - h).carried(x), after = rotor.turn(t + h).carried(x);
    const Point3 velocity = (after - before) / (2. * h), acceleration = (after - 2. * now + before) / (h * h);
    EXPECT_LT((rotor.motion(t).velocity(now) - velocity).norm(), 1e-6 * velocity.norm());
    const HubMotion hub = rotor.motion(t);
    EXPECT_LT(
      (hub.centripetal_acceleration(now) + rotor.angular_acceleration(t).cross(now - hub.centre) - acceleration).norm(),
      1e-3 * acceleration.norm());
  }

  TEST(Rotor, RefusesWhatIsNoSpeed)
  {
    for (const char *text : {"fast", "600*x", "600 + 1e5*t*x", "600;5", "1/0", "600 +", "5730 rmp", "600 + rand()*t"})
      EXPECT_THROW(turning(text), InputError) << text;
  }

  // A shaft that stops before the run ends by a formula that knows no more: that is said before the first step.
  TEST(Rotor, AsksForAFormulaThatHoldsToTheEnd)
  {
    const Rotor rotor = turning("600*sqrt(1 - t/2e-3)");
    rotor.require_known_until(1.9e-3);
    EXPECT_THROW(rotor.require_known_until(2e-3), InputError);
    turning("600*(t/1e-2)^1.5").require_known_until(1e-2); // and none is asked about what was before 0
  }

  // A pulse of 3 us is in the angle from the time on at which it was.
  TEST(Rotor, SeesShortPulses)
  {
    const Rotor rotor = turning("if(t<1.0412e-3, 600, if(t<1.0442e-3, 900, 600))");
    for (const double t : {1.0412e-3, 1.0433e-3, 1.05e-3, 1.5e-3})
      EXPECT_NEAR(angle_of(rotor.turn(t)), 600. * t + 300. * std::clamp(t - 1.0412e-3, 0., 3e-6), 1e-9) << t;
  }
} // namespace birdstrike::rotor_test
