#include "bird_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace birdstrike;
using namespace birdstrike::test;

// Spray that crosses the plane of symmetry: of the whole, a particle and its image change places; half of it keeps what
// is then on its side.
TEST(SymmetryPlane, HalfABirdThatCrossesThePlaneStaysHalfOfTheWhole)
{
  const auto fly = [](const bool is_half, ThreadPool &pool) {
    BirdParameters parameters;
    parameters.spacing        = 0.004;
    parameters.aim_point      = {0., 0., 0.};
    parameters.pair_precision = PairPrecision::as_double;
    parameters.is_halved      = is_half;
    auto bird                 = std::make_unique<Bird>(parameters, EosParameters(), pool);
    bird->set_state([](Point3 &x, Point3 &v, double &mu) {
      mu = -0.5; // far apart, without pressure: they pass one another
      x *= 4.;
      v = Point3(100. * x[0], (x[1] < 0. ? 60. : -60.) * (1. + 5. * x[0]), 177. - 500. * std::abs(x[1]));
    });
    for (int k = 0; k < 400; ++k)
      step(*bird, 6e-7);
    return bird;
  };
  ThreadPool  pool(2);
  const auto  whole = fly(false, pool), half = fly(true, pool);
  const auto &of_whole = whole->state(), &of_half = half->state();
  ASSERT_EQ(of_whole.size(), 2 * of_half.size());
  std::size_t n_crossed = 0;
  for (std::size_t p = 0; p < of_whole.size(); ++p)
    n_crossed += of_whole.x[1][p] * of_whole.v[1][p] > 0.; // they came towards it
  EXPECT_GT(n_crossed, of_whole.size() / 10);
  for (std::size_t p = 0; p < of_half.size(); ++p)
    {
      ASSERT_GE(of_half.x[1][p], 0.);
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t q = 0; q < of_whole.size(); ++q)
        {
          double squared = 0.;
          for (int d = 0; d < 3; ++d)
            squared += std::pow(of_half.x[d][p] - of_whole.x[d][q], 2) +
                       std::pow(1e-6 * (of_half.v[d][p] - of_whole.v[d][q]), 2);
          nearest = std::min(nearest, squared);
        }
      ASSERT_LT(std::sqrt(nearest), 1e-9 * 0.004) << p;
    }
}
