#include "bird/round_body.h"
#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;
using std::numbers::pi;

namespace
{
  constexpr double R = 0.03, D = 2. * R;

  const RoundBody sphere(BirdShape::sphere, D, D), cylinder(BirdShape::cylinder, D, 0.13),
    ends(BirdShape::hemispherical_cylinder, D, 0.13), ball_of_ends(BirdShape::hemispherical_cylinder, D, D),
    ellipsoid(BirdShape::ellipsoid, D, 0.13);

  double cap(const double height, const double radius = R)
  {
    return pi * height * height * (3. * radius - height) / 3.;
  }

  double volume_between(const RoundBody &body, const double low, const double high, const double cosine)
  {
    return body.volume_to(high, cosine) - body.volume_to(low, cosine);
  }

  BirdParameters slice(const char *shape, const double low, const double high, const std::vector<double> &normal = {})
  {
    BirdParameters parameters;
    parameters.shape         = bird_shapes().at(shape);
    parameters.slice_between = {low, high};
    parameters.slice_normal  = normal;
    return parameters;
  }

  Point3 centre_of(const Packing &packing)
  {
    Point3 sum = Point3::Zero();
    for (const Point3 &p : packing.points)
      sum += p - packing.centre;
    return sum / static_cast<double>(packing.points.size());
  }
} // namespace

TEST(Slice, OfASphereIsItsSegmentInAnyDirection)
{
  for (const double cosine : {0., 0.3, 0.8, 1., -0.6})
    for (const double height : {0.001, 0.01, 0.03, 0.05, 0.06})
      {
        EXPECT_NEAR(volume_between(sphere, R - height, 1., cosine), cap(height), 1e-13 * cap(D));
        // the same body as a cylinder of no length between hemispheres: the quadrature
        EXPECT_NEAR(volume_between(ball_of_ends, R - height, 1., cosine), cap(height), 1e-11 * cap(D)) << cosine;
        EXPECT_NEAR(ball_of_ends.section_area(R - height, cosine), pi * height * (D - height), 1e-9 * pi * R * R);
      }
}

TEST(Slice, AcrossTheAxisIsThatOfTheBodyOfRevolution)
{
  EXPECT_NEAR(volume_between(cylinder, -0.02, 0.05, 1.), pi * R * R * 0.07, 1e-17);
  EXPECT_NEAR(volume_between(ends, -0.02, 0.03, 1.), pi * R * R * 0.05, 1e-17);
  EXPECT_NEAR(volume_between(ends, 0.02, 0.045, 1.), pi * R * R * 0.015 + cap(R) - cap(0.02), 1e-17);
  EXPECT_NEAR(volume_between(ends, 0.05, 1., 1.), cap(0.015), 1e-17);
  const double half = 0.065, k = 0.04; // a spheroid's cap: the ball's, stretched along its axis
  EXPECT_NEAR(volume_between(ellipsoid, half - k, 1., 1.), pi * R * R * k * k * (3. * half - k) / (3. * half * half),
              1e-17);
}

// Planes that miss the ends cut a cylinder of the same length along its axis; one through a diameter of its end cuts
// off Archimedes' hoof, 2/3 R^2 H.
TEST(Slice, InclinedThroughACylinder)
{
  for (const double angle : {1e-7, 1e-3, 0.1, 0.5})
    {
      const double cosine = std::cos(angle), area = pi * R * R / cosine;
      EXPECT_NEAR(volume_between(cylinder, -0.02 * cosine, 0.03 * cosine, cosine), pi * R * R * 0.05, 1e-15) << angle;
      EXPECT_NEAR(cylinder.section_area(0.01, cosine), area, 1e-9 * area) << angle;
    }
  for (const double H : {0.01, 0.06, 0.13})
    {
      const double cosine = 1. / std::hypot(1., H / R);
      EXPECT_NEAR(volume_between(cylinder, -1., -0.065 * cosine, cosine), 2. / 3. * R * R * H, 1e-15) << H;
    }
  EXPECT_NEAR(volume_between(cylinder, 0., 0.5 * R, 0.), 0.13 * R * R * (pi / 6. + std::sqrt(3.) / 4.),
              1e-15); // along the axis
}

// The affine image of a ball: a plane at the share u of its reach leaves the segment of the ball at u.
TEST(Slice, InclinedThroughAnEllipsoid)
{
  const double volume = 4. / 3. * pi * R * R * 0.065;
  for (const double cosine : {0., 0.5, 0.9})
    {
      const double reach = std::sqrt(std::pow(0.065 * cosine, 2) + R * R * (1. - cosine * cosine));
      EXPECT_NEAR(ellipsoid.reach(cosine), reach, 1e-16);
      for (const double u : {0.1, 0.5, 0.9})
        EXPECT_NEAR(volume_between(ellipsoid, u * reach, 1., cosine) / volume, cap(1. - u, 1.) / cap(2., 1.), 1e-14);
    }
}

TEST(Slice, SectionsAreTheSlopesOfVolumes)
{
  for (const RoundBody *body : {&sphere, &cylinder, &ends, &ellipsoid})
    for (const double cosine : {0.05, 0.6, 0.95, 1.})
      for (const double share : {0.1, 0.45, 0.8})
        {
          const double s = share * body->reach(cosine), step = 1e-5;
          EXPECT_NEAR(volume_between(*body, s - step, s + step, cosine) / (2. * step), body->section_area(s, cosine),
                      1e-5 * body->section_area(0., cosine));
        }
}

TEST(Slice, SlicesMakeUpTheBird)
{
  for (const char *shape : {"cylinder", "hemispherical cylinder", "ellipsoid", "sphere"})
    for (const std::vector<double> &normal : {std::vector<double>{}, {1., 0., 0.}, {0.3, -1., 0.8}})
      for (const char *lattice : {"cubic", "fcc"})
        {
          double                      mass   = 0.;
          Point3                      moment = Point3::Zero();
          const std::array<double, 5> planes{{-1., -0.008, 0.002, 0.014, 1.}};
          for (unsigned int k = 0; k < 4; ++k)
            {
              BirdParameters parameters = slice(shape, planes[k], planes[k + 1], normal);
              parameters.packing        = bird_lattices().at(lattice);
              parameters.yaw            = 20.;
              parameters.pitch          = -10.;
              parameters.roll           = 15.;
              const Shape   part(parameters);
              const Packing packing = compute_packing(parameters, part);
              EXPECT_NEAR(packing.mass(), part.volume() * parameters.density, 1e-15) << shape;
              EXPECT_NEAR(packing.particle_mass, parameters.density * std::pow(packing.spacing, 3),
                          1e-12 * packing.particle_mass);
              // a cut ten millimetres thick, of whole layers: never farther from its volume than half a layer
              EXPECT_NEAR(packing.spacing, parameters.spacing, 0.06 * parameters.spacing) << shape << ' ' << lattice;
              mass += packing.mass();
              moment += packing.mass() * centre_of(packing);
              const Point3 n = normal.empty() ? packing.axis : Point3(normal.data()).normalized();
              for (const Point3 &p : packing.points)
                {
                  EXPECT_GT(n.dot(p - packing.centre), planes[k] - 0.5 * packing.spacing);
                  EXPECT_LT(n.dot(p - packing.centre), planes[k + 1] + 0.5 * packing.spacing);
                }
            }
          EXPECT_NEAR(mass, 0.1005, 1e-12) << shape;
          EXPECT_LT(moment.norm() / mass, 0.2 * 0.002) << shape << ' ' << lattice;
        }
}

// Centre of mass of half a ball, 3 R/8; of half a cylinder along its axis 4 R/(3 pi): within a layer's share.
TEST(Slice, HalvesBalanceWhereTheyShould)
{
  BirdParameters parameters = slice("sphere", 0., 1., {0., 1., 0.});
  parameters.spacing        = 0.001;
  const Shape  half_ball(parameters);
  const Point3 ball = centre_of(compute_packing(parameters, half_ball));
  EXPECT_NEAR(ball[1], 0.1875 * half_ball.whole_diameter(), 0.15 * parameters.spacing);
  EXPECT_LT(std::hypot(ball[0], ball[2]), 1e-12);
  parameters.shape = BirdShape::cylinder;
  const Shape  half_cylinder(parameters);
  const Point3 along = centre_of(compute_packing(parameters, half_cylinder));
  EXPECT_NEAR(along[1], 2. / (3. * pi) * half_cylinder.whole_diameter(), 0.15 * parameters.spacing);
}

// A slice across a cylinder is a short cylinder, particle by particle.
TEST(Slice, OfACylinderIsAShorterOne)
{
  BirdParameters whole = slice("cylinder", -0.012, 0.012), made = whole;
  whole.yaw = made.yaw = -40.;
  whole.roll = made.roll = 22.5;
  const Shape shape(whole);
  made.slice_between.clear();
  made.length_to_diameter = 0.024 / shape.whole_diameter();
  made.mass               = shape.volume() * made.density;
  const Packing a = compute_packing(whole, shape), b = compute_packing(made, Shape(made));
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_NEAR(a.mass(), b.mass(), 1e-15);
  EXPECT_NEAR(a.diameter, b.diameter, 1e-12);
  for (std::size_t p = 0; p < a.points.size(); ++p)
    EXPECT_LT((a.points[p] - b.points[p]).norm(), 1e-12);
}

// Aim and stand-off are the whole bird's.
TEST(Slice, LiesWhereTheWholeBirdWould)
{
  BirdParameters parameters = slice("cylinder", 0.01, 1.);
  parameters.stand_off      = 0.1;
  parameters.velocity       = {0., 60., 80.};
  const Packing packing     = compute_packing(parameters, Shape(parameters));
  EXPECT_LT((packing.centre - Point3(0.21784, -0.06, -0.08)).norm(), 1e-12);
  const double middle = 0.5 * (0.01 + 0.5 * Shape(parameters).whole_length());
  EXPECT_LT((centre_of(packing) - middle * packing.axis).norm(), 1e-12);
}

TEST(Slice, HalvesOfItAreMirrored)
{
  BirdParameters parameters = slice("hemispherical cylinder", -0.01, 1., {1., 0., 2.});
  const Packing  whole      = compute_packing(parameters, Shape(parameters));
  parameters.is_halved      = true;
  const Packing half        = compute_packing(parameters, Shape(parameters));
  EXPECT_NEAR(half.mass(), whole.mass(), 1e-15);
  EXPECT_NO_THROW(parameters.check());
  parameters.slice_normal[1] = 0.1;
  EXPECT_THROW(parameters.check(), InputError);
}
