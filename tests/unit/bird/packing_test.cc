#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>

#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(Packing, MassIsExactAndTheAxisBalanced)
{
  for (const char *shape : {"cylinder", "hemispherical cylinder", "ellipsoid", "sphere"})
    for (const char *lattice : {"cubic", "fcc"})
      {
        BirdParameters parameters;
        parameters.shape      = shape;
        parameters.packing    = lattice;
        parameters.spacing    = 0.003;
        parameters.yaw        = 20.;
        parameters.pitch      = -10.;
        const Packing packing = compute_packing(parameters, Shape(parameters));
        EXPECT_NEAR(packing.mass(), parameters.mass, 1e-15) << shape;
        EXPECT_NEAR(packing.particle_mass, parameters.density * std::pow(packing.spacing, 3),
                    1e-12 * packing.particle_mass);
        Point3 off_axis = Point3::Zero();
        for (const Point3 &p : packing.points)
          off_axis += (p - packing.centre) - packing.axis.dot(p - packing.centre) * packing.axis;
        // pairs opposite each other about the axis cancel to round-off
        EXPECT_LT(off_axis.norm() / packing.points.size(), 1e-15) << shape << ' ' << lattice;
        // the cut is never farther from the nominal volume than a layer; spacing moves by a third of that
        EXPECT_NEAR(packing.spacing, parameters.spacing, 0.02 * parameters.spacing) << shape << ' ' << lattice;
      }
}

// Frontal and oblique bird of the published strikes: diameters and lengths from m, rho = 950 and L = 2 D.
TEST(Packing, DimensionsFollowFromTheMass)
{
  BirdParameters parameters;
  EXPECT_NEAR(Shape(parameters).diameter(), 0.040686, 5e-7);
  EXPECT_NEAR(Shape(parameters).length(), 0.081371, 1e-6);
  parameters.mass = 0.0826;
  EXPECT_NEAR(Shape(parameters).diameter(), 0.038111, 5e-7);
}

TEST(Packing, TheAxisPassesThroughTheAimPointAlongTheVelocity)
{
  BirdParameters parameters;
  parameters.velocity         = {0., 243.2, 179.3};
  parameters.aim_point        = {0.2, 0.01, 0.};
  parameters.chordwise_offset = 0.02;
  const Packing packing       = compute_packing(parameters, Shape(parameters));
  const Point3  direction     = Point3(0., 243.2, 179.3).normalized();
  const Point3  way           = Point3(0.2, 0.03, 0.) - packing.centre;
  EXPECT_LT(way.cross(direction).norm(), 1e-15);
  EXPECT_NEAR(way.norm(), 2. * packing.bounding_radius, 1e-15);
  EXPECT_LT((packing.axis - direction).norm(), 1e-15);
}

TEST(Packing, YawTurnsTheAxisByItsAngle)
{
  BirdParameters parameters;
  parameters.yaw        = 30.;
  const Packing packing = compute_packing(parameters, Shape(parameters));
  EXPECT_NEAR(packing.axis[2], std::cos(std::numbers::pi / 6.), 1e-15);
  EXPECT_NEAR(std::abs(packing.axis[1]), 0.5, 1e-15); // about the span, so within the chord
}

TEST(Packing, RefusesAPeriodShorterThanTwoRanges)
{
  BirdParameters parameters;
  parameters.shape               = "slab";
  parameters.slab_lengths        = {0.008, 0.02, 0.02};
  parameters.periodic_directions = "x";
  EXPECT_THROW(compute_packing(parameters, Shape(parameters)), InputError);
}
