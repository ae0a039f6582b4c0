#include <birdstrike/core/closest_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace birdstrike;

namespace
{
  using Facet = std::array<Point3, 4>;

  Facet warped_facet()
  {
    return {Point3(0., 0., 0.), Point3(1.1, 0.1, 0.15), Point3(1.3, 0.9, -0.1), Point3(-0.1, 1.2, 0.2)};
  }

  Point3 random_point(std::mt19937 &random, const double range)
  {
    std::uniform_real_distribution<double> uniform(-range, range);
    const double                           a = uniform(random), b = uniform(random), c = uniform(random);
    return {a, b, c};
  }

  /// Nearest of a fine sample of the fan: no closer than the truth.
  double sampled_distance(const Point3 &p, const Facet &x, const unsigned int n)
  {
    const Point3 c        = 0.25 * (x[0] + x[1] + x[2] + x[3]);
    double       smallest = 1e300;
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; i + j <= n; ++j)
          smallest =
            std::min(smallest, (p - c - (x[k] - c) * (double(i) / n) - (x[(k + 1) % 4] - c) * (double(j) / n)).norm());
    return smallest;
  }
} // namespace

TEST(ClosestPoint, OnARectangleItClampsTheCoordinates)
{
  const Facet  x{Point3(0., 0., 0.), Point3(2., 0., 0.), Point3(2., 1., 0.), Point3(0., 1., 0.)};
  std::mt19937 random(1);
  for (unsigned int trial = 0; trial < 2000; ++trial)
    {
      const Point3 p       = random_point(random, 3.), q(std::clamp(p[0], 0., 2.), std::clamp(p[1], 0., 1.), 0.);
      const auto   closest = compute_closest_point(p, x);
      EXPECT_NEAR((p - closest.offset - q).norm(), 0., 1e-14); // round-off of coordinates up to 3
      EXPECT_NEAR(closest.distance_squared, (p - q).squaredNorm(), 1e-13);
    }
}

TEST(ClosestPoint, WeightsReproduceThePointAndSumToOne)
{
  std::mt19937 random(2);
  for (unsigned int trial = 0; trial < 2000; ++trial)
    {
      const Facet  x = warped_facet();
      const Point3 p = random_point(random, 2.);
      const auto   q = compute_closest_point(p, x);
      Point3       sum(0., 0., 0.);
      double       total = 0.;
      for (unsigned int k = 0; k < 4; ++k)
        {
          EXPECT_GE(q.weights[k], 0.);
          sum += q.weights[k] * x[k];
          total += q.weights[k];
        }
      EXPECT_NEAR(total, 1., 1e-15);
      EXPECT_NEAR((p - sum - q.offset).norm(), 0., 2e-15);
    }
}

TEST(ClosestPoint, NothingOfAWarpedFacetIsCloser)
{
  std::mt19937 random(3);
  const Facet  x = warped_facet();
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const Point3 p        = random_point(random, 1.5);
      const double distance = std::sqrt(compute_closest_point(p, x).distance_squared),
                   sample   = sampled_distance(p, x, 60);
      EXPECT_LE(distance, sample + 1e-14);
      EXPECT_GE(distance, sample - 0.02); // the sample's mesh is 1/60 of the facet
    }
}

TEST(ClosestPoint, NeighboursAgreeBeyondTheirCommonEdge)
{
  // two facets share x1-x2; a point nearest to that edge has the same distance to both, whatever the warp
  const Facet a = warped_facet(), b{a[1], Point3(2., 0., 0.6), Point3(2.1, 1., 0.5), a[2]};
  for (double s = 0.05; s < 1.; s += 0.05)
    {
      const Point3 q = (1. - s) * a[1] + s * a[2], p = q + Point3(0., 0., -0.2); // on the convex side of the fold
      const auto   to_a = compute_closest_point(p, a), to_b = compute_closest_point(p, b);
      EXPECT_LE(std::min(to_a.distance_squared, to_b.distance_squared), 0.04 + 1e-15);
      const Point3 exactly_on_edge = q;
      EXPECT_NEAR(compute_closest_point(exactly_on_edge, a).distance_squared, 0., 1e-30);
      EXPECT_NEAR(compute_closest_point(exactly_on_edge, b).distance_squared, 0., 1e-30);
    }
}

TEST(ClosestPoint, WeightsTellEdgesAndCornersByExactZeros)
{
  const Facet x     = warped_facet();
  const auto  edge  = compute_closest_point(Point3(0.5, -1., 0.), x),
             corner = compute_closest_point(Point3(-1., -1., 0.), x);
  EXPECT_EQ(edge.weights[2], 0.);
  EXPECT_EQ(edge.weights[3], 0.);
  EXPECT_GT(edge.weights[0], 0.);
  EXPECT_GT(edge.weights[1], 0.);
  EXPECT_EQ(corner.weights, (std::array<double, 4>{1., 0., 0., 0.}));
}

TEST(ClosestPoint, AlongAWholeEdgeTheZerosAreExact)
{
  // 1 - (1 - t) - t in round-off is positive for one in seven of these t: whoever asks for the feature would see the
  // inside
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> uniform(0.01, 0.99);
  for (unsigned int trial = 0; trial < 2000; ++trial)
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Facet  x = warped_facet();
        const Point3 a = x[k], b = x[(k + 1) % 4], centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
        const Point3 outward = (b - a).cross((b - a).cross(centre - a)); // in the fan's plane, away from the centre
        const double t       = uniform(random);
        const Point3 p       = (1. - t) * a + t * b + 0.3 * outward / outward.norm();
        const auto   scalar  = compute_closest_point(p, x);
        EXPECT_EQ(scalar.weights[(k + 2) % 4], 0.) << k << ' ' << t;
        EXPECT_EQ(scalar.weights[(k + 3) % 4], 0.) << k << ' ' << t;
        EXPECT_NEAR(scalar.weights[k], 1. - t, 1e-14);
        std::array<Vector3<Lanes>, 4> lanes;
        for (unsigned int n = 0; n < 4; ++n)
          lanes[n] = x[n].cast<Lanes>();
        const auto wide = compute_closest_point<Lanes>(p.cast<Lanes>(), lanes);
        EXPECT_TRUE(all(wide.weights[(k + 2) % 4] == Lanes(0.)));
        EXPECT_TRUE(all(wide.weights[(k + 3) % 4] == Lanes(0.)));
      }
}

TEST(ClosestPoint, ATriangleIsAQuadrilateralWithItsLastNodeTwice)
{
  const Facet  x{Point3(0., 0., 0.), Point3(1., 0., 0.), Point3(0., 1., 0.), Point3(0., 1., 0.)};
  std::mt19937 random(4);
  EXPECT_NEAR(compute_closest_point(Point3(0.2, 0.3, 0.7), x).distance_squared, 0.49, 1e-15);
  EXPECT_NEAR(compute_closest_point(Point3(1., 1., 0.), x).distance_squared, 0.5, 1e-15); // hypotenuse
  EXPECT_NEAR(compute_closest_point(Point3(0., 2., 0.), x).distance_squared, 1., 1e-15);  // the double node
  EXPECT_NEAR(compute_area_vector(x)[2], 0.5, 1e-16);
}

TEST(ClosestPoint, LanesAgreeWithDoubles)
{
  std::mt19937                  random(5);
  const Facet                   x = warped_facet();
  std::array<Vector3<Lanes>, 4> wide;
  for (unsigned int k = 0; k < 4; ++k)
    for (unsigned int d = 0; d < 3; ++d)
      wide[k][d] = Lanes(x[k][d]);
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      std::array<Point3, n_lanes> p;
      Vector3<Lanes>              wide_p;
      for (std::size_t j = 0; j < n_lanes; ++j)
        {
          p[j] = random_point(random, 1.5);
          for (unsigned int d = 0; d < 3; ++d)
            wide_p[d][j] = p[j][d];
        }
      const auto q = compute_closest_point(wide_p, wide);
      for (std::size_t j = 0; j < n_lanes; ++j)
        EXPECT_NEAR(q.distance_squared[j], compute_closest_point(p[j], x).distance_squared, 1e-14);
    }
}
