#include "free_masses.h"

#include <birdstrike/core/closest_point.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace birdstrike;
using birdstrike::test::FreeMasses;

TEST(Search, FindsWhatBruteForceFindsWhileEverythingMoves)
{
  std::mt19937                           random(11);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  FreeMasses                             scene;
  scene.add_patch(9, 7, 1e-3, [&](const unsigned int i, const unsigned int j) {
    return Point3(5e-3 * i, 4e-3 * j * (1. + 0.05 * i), 8e-3 * std::sin(0.6 * i + 0.2 * j));
  });
  for (auto &node : scene.node)
    node.velocity = Point3(300., 0., 30. * uniform(random)); // a common flight that must not cost searches
  for (unsigned int i = 0; i < 800; ++i)
    scene.add_point({Point3(0.022 + 0.025 * uniform(random), 0.016 + 0.02 * uniform(random), 0.02 * uniform(random)),
                     Point3(300. + 20. * uniform(random), 20. * uniform(random), 50. * uniform(random))});

  constexpr double range = 1.2e-3;
  CandidateSearch  search;
  ThreadPool       pool(2);
  std::size_t      n_close = 0;
  for (unsigned int step = 0; step < 80; ++step)
    {
      const PointsView points = scene.points();
      const FacetsView facets = scene.facets();
      search.update(points, facets, range, 1e-3, pool);
      std::set<std::pair<std::uint32_t, std::uint32_t>> found;
      for (const CandidateBlock &block : search.blocks())
        for (std::size_t k = 0; k < block.n_pairs(); ++k)
          EXPECT_TRUE(found.emplace(block.points[block.pair_near[k]], block.facets.keys()[block.pair_facet[k]]).second);
      for (std::uint32_t i = 0; i < points.n; ++i)
        for (std::uint32_t f = 0; f < facets.n_facets; ++f)
          if (compute_closest_point(scene.position(i), facet_nodes(facets, f)).distance_squared < range * range)
            {
              ++n_close;
              EXPECT_TRUE(found.count({i, f})) << step << ' ' << i << ' ' << f;
            }
      for (std::size_t i = 0; i < points.n; ++i)
        for (unsigned int d = 0; d < 3; ++d)
          scene.x[d][i] += 1e-6 * scene.v[d][i];
      for (auto &node : scene.node)
        node.position += 1e-6 * node.velocity;
    }
  EXPECT_GT(n_close, 1000u);
  // in the first node's frame points move by less than 58 + 30 m/s, nodes by 60: 0.148 mm a step. A margin of 1 mm with
  // one step in reserve serves five calls after the search; the common 300 m/s would serve two.
  EXPECT_LE(search.counts().searches, 14u);
  EXPECT_EQ(search.counts().searches + search.counts().reused, 80u);
}

TEST(Search, NothingIsDoneWhilePointsAndFacetsAreApart)
{
  FreeMasses scene;
  scene.add_plate(3, 3, 0.01, 2e-3);
  for (unsigned int i = 0; i < 100; ++i)
    scene.add_point({Point3(0.01 + 1e-4 * i, 0.01, 0.05), Point3(0., 0., -100.)});
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  scene.compute_contact(contact, 1e-6, pool);
  for (unsigned int n = 0; n < 400; ++n)
    scene.advance(contact, 1e-6, pool); // to z = 0.01, 8.5 mm above touch
  EXPECT_EQ(contact.report().skipped, 401u);
  EXPECT_EQ(contact.report().searches, 0u);
  EXPECT_EQ(contact.report().peak_force, 0.);
  for (unsigned int n = 0; n < 150; ++n)
    scene.advance(contact, 1e-6, pool);
  EXPECT_GT(contact.report().peak_force, 0.);
  EXPECT_EQ(contact.report().skipped + contact.report().searches + contact.report().reused, 551u);
}

TEST(Search, BoxesApartCostNoSearchAndNoPairAndNearnessIsCounted)
{
  FreeMasses scene;
  scene.add_plate(3, 3, 0.01, 2e-3, Point3(-2e-3, 0., 0.));
  for (unsigned int i = 0; i < 300; ++i) // two blocks: one over the plate, one 0.2 m away, all of them in flight
    scene.add_point({Point3(1e-4 * i, 0.01, i < 256 ? 0.01 : 0.2), Point3(0., 0., -100.)});
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  const auto call = [&](const double z) {
    for (std::size_t i = 0; i < 256; ++i)
      scene.place(i, Point3(1e-4 * i, 0.01, z));
    scene.compute_contact(contact, 1e-6, pool);
    return contact.report();
  };
  ContactReport report;
  for (unsigned int n = 0; n < 50; ++n)
    report = call(0.01 - 1e-4 * n);
  EXPECT_EQ(report.calls, 50u);
  EXPECT_EQ(report.skipped, 50u);
  EXPECT_EQ(report.searches + report.pairs_listed + report.pairs_tested + report.points_near + report.points_active,
            0u);
  EXPECT_EQ(report.mean_points_near(), 0.);

  report = call(1.6e-3); // 0.1 mm above touch: the far block is not on the list
  EXPECT_EQ(report.searches, 1u);
  EXPECT_EQ(report.points_near, 256u);
  EXPECT_EQ(report.mean_points_near(), 256.);
  EXPECT_GE(report.pairs_listed, 256u);
  EXPECT_EQ(report.pairs_tested, 0u); // out of reach they sleep

  const std::uint64_t n_listed = report.pairs_listed;
  report                       = call(1.4e-3); // 0.1 mm deep, on the same list
  EXPECT_EQ(report.searches, 1u);
  EXPECT_EQ(report.reused, 1u);
  EXPECT_EQ(report.touches, 256u);
  EXPECT_EQ(report.points_active, 256u);
  EXPECT_GE(report.pairs_tested, 256u);
  EXPECT_EQ(report.pairs_listed, 2 * n_listed);
  for (unsigned int n = 0; n < 3; ++n)
    report = call(0.01);
  EXPECT_GT(report.skipped, 50u); // and away again
}

TEST(Search, OneHugeFacetAndNoPointsAreServed)
{
  FreeMasses scene;
  scene.add_plate(1, 1, 100., 0., Point3(-50., -50., 0.));
  scene.add_point({Point3(0.3, -0.2, 4e-4)});
  scene.add_point({Point3(0.3, -0.2, 1.)});
  CandidateSearch search;
  ThreadPool      pool;
  search.update(scene.points(), scene.facets(), 5e-4, 1e-3, pool);
  EXPECT_EQ(search.n_pairs(), 1u);
  EXPECT_EQ(search.n_near(), 1u);

  FreeMasses empty;
  empty.add_plate(1, 1, 1., 0.);
  Contact contact{ContactParameters()};
  empty.compute_contact(contact, 1e-6, pool);
  empty.compute_contact(contact, 1e-6, pool);
  EXPECT_EQ(contact.report().skipped, 2u);
}

TEST(Search, RemovedPointsLeaveTheList)
{
  FreeMasses scene;
  scene.add_plate(2, 2, 0.01, 0.);
  for (unsigned int i = 0; i < 10; ++i)
    scene.add_point({Point3(1e-3 + 1.8e-3 * i, 0.005, 4e-4)});
  CandidateSearch search;
  ThreadPool      pool;
  search.update(scene.points(), scene.facets(), 5e-4, 1e-3, pool);
  EXPECT_EQ(search.n_near(), 10u);
  PointsView fewer = scene.points();
  fewer.n          = 4;
  fewer.revision   = 2;
  search.update(fewer, scene.facets(), 5e-4, 1e-3, pool);
  EXPECT_EQ(search.n_near(), 4u);
}
