#include <birdstrike/bird/packing.h>
#include <birdstrike/core/errors.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(Packing, MassIsExactAndTheAxisBalanced)
{
  for (const char *shape : {"cylinder", "hemispherical cylinder", "ellipsoid", "sphere"})
    for (const char *lattice : {"cubic", "fcc"})
      {
        BirdParameters parameters;
        parameters.shape      = bird_shapes().at(shape);
        parameters.packing    = bird_lattices().at(lattice);
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

// However many layers the spacing makes of it, a cylinder is as long and as thick as its mass says. Second moments of
// the points are those of the body: (L^2 - t^2)/12 along the axis, t the distance of layers, which in fcc hold in turn
// a few more and less; R^2/4 across it, but for the steps of its outline.
TEST(Packing, CylindersAndSlicesHaveTheirLengthAndSection)
{
  const double D = std::cbrt(2. * 0.1005 / 950. / std::numbers::pi);
  for (const char *lattice : {"cubic", "fcc"})
    for (const bool is_slice : {false, true})
      for (const double spacing : {0.0021, 0.0025, 0.0031, 0.0034})
        {
          BirdParameters parameters;
          parameters.packing = bird_lattices().at(lattice);
          parameters.spacing = spacing;
          if (is_slice)
            parameters.slice_between = {-0.004, 0.0155};
          const Shape   shape(parameters);
          const Packing packing = compute_packing(parameters, shape);
          EXPECT_NEAR(packing.length, is_slice ? 0.0195 : 2. * D, 1e-15) << lattice << spacing;
          EXPECT_NEAR(packing.diameter, D, 1e-15) << lattice << spacing;
          const double middle = is_slice ? 0.00575 : 0.;
          double       along = 0., across = 0., farthest = 0.;
          for (const Point3 &p : packing.points)
            {
              const Point3 r = p - packing.centre;
              const double z = r.dot(packing.axis);
              along += (z - middle) * (z - middle) / packing.points.size();
              across += 0.5 * (r.squaredNorm() - z * z) / packing.points.size();
              farthest = std::max(farthest, z - middle);
            }
          const double t = packing.length - 2. * farthest;
          EXPECT_NEAR(packing.length / t, std::round(packing.length / t), 1e-9);
          EXPECT_NEAR(along, (packing.length * packing.length - t * t) / 12.,
                      (lattice[0] == 'c' ? 1e-9 : 0.015) * along);
          EXPECT_NEAR(across, D * D / 16., 0.01 * across) << lattice << spacing;
        }
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

// Bird, velocity and span turned by R: so are all particles. Round-off of places below 1 m.
TEST(Packing, TurnsWithTheBladeInSpace)
{
  BirdParameters parameters;
  parameters.spacing    = 0.004;
  parameters.velocity   = {40., 90., 150.};
  parameters.yaw        = 35.;
  parameters.pitch      = -20.;
  parameters.roll       = 10.;
  const Packing packing = compute_packing(parameters, Shape(parameters));

  const Matrix3<double> R      = Eigen::AngleAxisd(2.1, Point3(0.3, -1., 0.7).normalized()).toRotationMatrix();
  BirdParameters        turned = parameters;
  for (auto *of : {&turned.velocity, &turned.aim_point, &turned.span})
    {
      const Point3 there = R * Point3(of->data());
      *of                = {there[0], there[1], there[2]};
    }
  const Packing other = compute_packing(turned, Shape(turned));
  ASSERT_EQ(other.points.size(), packing.points.size());
  EXPECT_LT((other.axis - R * packing.axis).norm(), 1e-14);
  for (std::size_t k = 0; k < packing.points.size(); ++k)
    ASSERT_LT((other.points[k] - R * packing.points[k]).norm(), 1e-14);
}

TEST(Packing, YawTurnsTheAxisByItsAngle)
{
  BirdParameters parameters;
  parameters.yaw        = 30.;
  const Packing packing = compute_packing(parameters, Shape(parameters));
  EXPECT_NEAR(packing.axis[2], std::cos(std::numbers::pi / 6.), 1e-15);
  EXPECT_NEAR(std::abs(packing.axis[1]), 0.5, 1e-15); // about the span, so within the chord
}

namespace
{
  /// Largest difference between the share of points on one side of planes along the axis and the span, over one
  /// spacing about the axis, and the share of the round cross-section there.
  double largest_error_of_a_cut(const double roll)
  {
    BirdParameters parameters;
    parameters.spacing    = 0.004;
    parameters.roll       = roll;
    const Packing packing = compute_packing(parameters, Shape(parameters));
    const double  radius  = 0.5 * packing.diameter;
    double        error   = 0.;
    for (int k = 0; k < 16; ++k)
      {
        const double s = ((k + 0.5) / 16. - 0.5) * packing.spacing, x = s / radius;
        const double share = 0.5 - (x * std::sqrt(1. - x * x) + std::asin(x)) / std::numbers::pi;
        double       n     = 0.;
        for (const Point3 &p : packing.points)
          n += p[1] - packing.centre[1] > s;
        error = std::max(error, std::abs(n / packing.points.size() - share));
      }
    return error;
  }
} // namespace

// A plane along the rows has half a row on the wrong side at worst: (2/pi) dx/D of the bird, 6 % here. At 22.5 degrees,
// whose tangent sqrt(2) - 1 has the continued fraction [0; 2, 2, 2, ...], points pass the plane nearly one by one.
TEST(Packing, RollKeepsRowsFromLyingAlongAnEdge)
{
  EXPECT_GT(largest_error_of_a_cut(0.), 0.05);
  EXPECT_LT(largest_error_of_a_cut(22.5), 0.06 / 4.);
}

// The same plane and the lattice elsewhere: of half a row, (2/pi) dx/D = 0.066, the mean over 32 places that fill the
// cell evenly leaves a tenth.
TEST(Packing, PlacesOfTheLatticeAverageACut)
{
  constexpr int  n = 32;
  BirdParameters parameters;
  parameters.spacing = 0.004;
  double sum = 0., square = 0.;
  for (int k = 0; k < n; ++k)
    {
      parameters.lattice_shift = {{std::fmod(0.7548776662466927 * k, 1.), std::fmod(0.5698402909980532 * k, 1.)}};
      const Packing packing    = compute_packing(parameters, Shape(parameters));
      double        above      = 0.;
      for (const Point3 &p : packing.points)
        above += p[1] > packing.centre[1];
      const double share = above / packing.points.size();
      EXPECT_NEAR(packing.mass(), 0.1005, 1e-15);
      EXPECT_NEAR(share, 0.5, 0.066);
      sum += share;
      square += (share - 0.5) * (share - 0.5);
    }
  EXPECT_GT(std::sqrt(square / n), 0.02);
  EXPECT_NEAR(sum / n, 0.5, 0.0066);
}

TEST(Packing, ACellsShiftIsNone)
{
  BirdParameters parameters;
  parameters.spacing   = 0.004;
  parameters.packing   = BirdLattice::fcc;
  const Packing before = compute_packing(parameters, Shape(parameters));
  const auto    sorted = [](std::vector<Point3> points) {
    std::ranges::sort(points, [](const Point3 &a, const Point3 &b) {
      for (int d = 0; d < 2; ++d)
        if (std::abs(a[d] - b[d]) > 1e-9)
          return a[d] < b[d];
      return a[2] < b[2];
    });
    return points;
  };
  parameters.lattice_shift = {{1., -1.}};
  const Packing after      = compute_packing(parameters, Shape(parameters));
  const auto    a = sorted(before.points), b = sorted(after.points);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    ASSERT_LT((a[k] - b[k]).norm(), 1e-12);
  parameters.lattice_shift = {{0.25, 0.}};
  const Packing quarter    = compute_packing(parameters, Shape(parameters));
  EXPECT_GT((sorted(quarter.points)[0] - a[0]).norm(), 1e-4);
  EXPECT_NEAR(quarter.length, before.length, 1e-15) << "layers along the axis stay";
}

TEST(Packing, RollLeavesTheAxis)
{
  BirdParameters parameters;
  parameters.pitch     = 10.;
  const Packing before = compute_packing(parameters, Shape(parameters));
  parameters.roll      = 30.;
  const Packing after  = compute_packing(parameters, Shape(parameters));
  const Point3  a = before.points[0] - before.centre, b = after.points[0] - after.centre, axis = before.axis;
  EXPECT_LT((after.axis - axis).norm() + (after.centre - before.centre).norm(), 1e-15);
  EXPECT_NEAR(a.dot(axis), b.dot(axis), 1e-15);
  const Point3 p = a - a.dot(axis) * axis, q = b - b.dot(axis) * axis;
  EXPECT_NEAR(std::atan2(axis.dot(p.cross(q)), p.dot(q)), std::numbers::pi / 6., 1e-13); // right-handed about the axis
}

TEST(Packing, RefusesAPeriodShorterThanTwoRanges)
{
  BirdParameters parameters;
  parameters.shape        = BirdShape::slab;
  parameters.slab_lengths = {0.008, 0.02, 0.02};
  parameters.is_periodic  = {{true, false, false}};
  EXPECT_THROW(compute_packing(parameters, Shape(parameters)), InputError);
}
