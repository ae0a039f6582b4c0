#include <birdstrike/bird/neighbor_list.h>

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  constexpr double support = 1., skin = 0.15;

  Particles scatter(const std::size_t n, const double edge)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> uniform(0., edge);
    Particles                              particles;
    particles.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        particles.id[p] = p;
        for (int d = 0; d < 3; ++d)
          particles.x[d][p] = uniform(generator);
      }
    return particles;
  }

  double distance(const Particles &particles, const std::size_t i, const std::size_t j, const Period &period)
  {
    double r2 = 0.;
    for (int d = 0; d < 3; ++d)
      {
        double x = particles.x[d][i] - particles.x[d][j];
        if (period[d] > 0.)
          x -= period[d] * std::round(x / period[d]);
        r2 += x * x;
      }
    return std::sqrt(r2);
  }

  /// Every pair within `reach` is listed once, no particle lists itself, padding is the dummy.
  void expect_complete(const Particles &particles, const NeighborList &list, const double reach)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
      {
        std::set<std::uint32_t> listed;
        for (std::size_t k = 0; k < list.padded_count(i); ++k)
          if (list.neighbors(i)[k] != particles.size())
            {
              EXPECT_TRUE(listed.insert(list.neighbors(i)[k]).second);
            }
        EXPECT_EQ(list.padded_count(i) % n_lanes, 0u);
        EXPECT_EQ(listed.count(i), 0u);
        for (std::size_t j = 0; j < particles.size(); ++j)
          if (j != i && distance(particles, i, j, list.period()) < reach)
            {
              EXPECT_TRUE(listed.count(j) == 1) << i << ' ' << j;
            }
      }
  }

  void move(Particles &particles, const std::size_t p, const Point3 &u)
  {
    for (int d = 0; d < 3; ++d)
      particles.x[d][p] += u[d];
  }

  void expect_complete_in_motion(const Period &period)
  {
    ThreadPool                             pool(2);
    Particles                              particles = scatter(700, 6.);
    NeighborList                           list(support, skin, period);
    std::mt19937                           generator(3);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<Point3>                    velocity(particles.size());
    for (Point3 &v : velocity) // 5 fast strays among slow ones, all in a fast frame
      v = Point3(3., 0., 0.) +
          (&v - velocity.data() < 5 ? 0.3 : 0.02) * Point3(uniform(generator), uniform(generator), uniform(generator));
    list.update(particles, pool);
    expect_complete(particles, list, support + skin);
    for (int step = 0; step < 60; ++step)
      {
        for (std::size_t p = 0; p < particles.size(); ++p)
          move(particles, p, 0.1 * velocity[particles.id[p]]);
        if (list.is_outdated(particles, pool))
          list.update(particles, pool);
        expect_complete(particles, list, support);
      }
    EXPECT_GT(list.n_builds(), 2u);
    EXPECT_LT(list.n_builds(), 60u);
  }
} // namespace

TEST(NeighborList, HoldsEveryPairOfABruteForceSearchAfterMotion)
{
  expect_complete_in_motion({0., 0., 0.});
}

TEST(NeighborList, HoldsEveryPairAcrossPeriodicFaces)
{
  expect_complete_in_motion({6., 0., 6.});
  expect_complete_in_motion({6., 6., 6.});
}

TEST(NeighborList, ACommonMotionNeverOutdatesIt)
{
  ThreadPool   pool(1);
  Particles    particles = scatter(500, 5.);
  NeighborList list(support, skin, {0., 0., 0.});
  list.update(particles, pool);
  for (int step = 0; step < 100; ++step)
    {
      for (std::size_t p = 0; p < particles.size(); ++p)
        move(particles, p, Point3(100., -30., 7.));
      ASSERT_FALSE(list.is_outdated(particles, pool));
    }
}

TEST(NeighborList, OneStrayAcrossAnEmptyGapOutdatesIt)
{
  ThreadPool pool(1);
  Particles  particles = scatter(200, 3.);
  for (int d = 0; d < 3; ++d)
    particles.x[d][0] = 30.; // alone, ten ranges away
  NeighborList list(support, skin, {0., 0., 0.});
  list.update(particles, pool);
  const std::size_t stray = std::find(particles.id.begin(), particles.id.end(), 0u) - particles.id.begin();
  int               steps = 0;
  for (; steps < 100 && !list.is_outdated(particles, pool); ++steps)
    move(particles, stray, Point3::Constant(-0.3));
  EXPECT_LT(steps, 90) << "the stray has met the others unseen";
}
