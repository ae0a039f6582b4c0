#include "self_masses.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::SelfMasses;

// Pieces of one surface that meet: what must hold whatever the law's constants are, and the exact answers of collisions
// in one dimension.
namespace
{
  constexpr double cell = 5e-3, thickness = 2e-3;
  constexpr int    n_cells = 6;

  /// Two parallel plates, `clearance` between their surfaces; the upper one is shifted by `shift` cells. Speed is the
  /// upper one's, downwards.
  struct Plates
  {
    SelfMasses    scene;
    std::size_t   n_lower = 0;
    double        mass_lower, mass_upper;
    static double offset(const double clearance)
    {
      return thickness + clearance;
    }
    Plates(const double mass_lower, const double mass_upper, const double speed, const double damping,
           const bool is_free, const double shift = 0.3, const double clearance = 0.5e-3)
      : scene(damping), mass_lower(mass_lower), mass_upper(mass_upper)
    {
      scene.masses.add_plate(n_cells, n_cells, cell, thickness);
      n_lower = scene.masses.node.size();
      scene.close_body(mass_lower, Point3(0., 0., 0.), is_free);
      scene.masses.add_plate(n_cells, n_cells, cell, thickness, Point3(shift * cell, shift * cell, offset(clearance)));
      scene.close_body(mass_upper, Point3(0., 0., -speed), is_free);
    }
    double gap() const
    {
      return scene.height(n_lower, scene.masses.node.size(), true) - scene.height(0, n_lower, false);
    }
    /// Runs until the plates have parted again or `most` steps are over.
    void run(const double step, const int most, const double speed)
    {
      const int enough = static_cast<int>(2.5 * (offset(0.5e-3)) / (speed * step)) + 60;
      scene.compute(step);
      for (int k = 0; k < std::min(most, enough); ++k)
        scene.advance(step);
    }
  };

  /// What the bodies have lost, against what contact says it has stored and dissipated, relative to `scale`.
  double energy_error(const SelfMasses &scene, const double scale)
  {
    const SelfContactReport report = scene.contact.report();
    return (-scene.work - report.stored_energy - report.dissipated_energy) / scale;
  }
} // namespace

TEST(SelfContact, ReportsTheWholeOfAHalf)
{
  Plates half(0.1, 0.1, 10., SelfContact::default_damping_ratio, false), all = half;
  half.scene.masses.plane = SymmetryPlane(true);
  half.run(2e-6, 28, 10.);
  all.run(2e-6, 28, 10.);
  const SelfContactReport whole = half.scene.contact.report(), part = all.scene.contact.report();
  ASSERT_GT(part.stored_energy, 0.);
  EXPECT_EQ(half.scene.work, all.scene.work);
  EXPECT_EQ(whole.stored_energy, 2. * part.stored_energy);
  EXPECT_EQ(whole.dissipated_energy, 2. * part.dissipated_energy);
  EXPECT_EQ(whole.n_touching, 2 * part.n_touching);
  EXPECT_EQ(whole.max_penetration, part.max_penetration);
}

TEST(SelfContact, EqualPlatesExchangeTheirVelocitiesWithoutADamper)
{
  for (const double speed : {5., 50., 500.})
    for (const double step : {1e-7, 4e-7})
      {
        Plates plates(1., 1., speed, 0., false);
        plates.run(step, 20000, speed);
        const auto &body = plates.scene.body;
        // momentum to round-off; the velocities but for the steps in which the springs set in and end, which take up to
        // a tenth of the energy of approach each (self_contact.h): (1 - sqrt(1 - 0.2))/2 of a speed
        EXPECT_NEAR(body[0].velocity[2] + body[1].velocity[2], -speed, 1e-12 * speed);
        EXPECT_NEAR(body[0].velocity[2], -speed, 0.053 * speed) << speed << " m/s, " << step << " s";
        EXPECT_NEAR(body[1].velocity[2], 0., 0.053 * speed);
        EXPECT_EQ(plates.scene.contact.report().n_touching, 0U);
      }
}

TEST(SelfContact, DissipatesAndMakesNoEnergyWhateverSpeedStepAndMasses)
{
  struct Case
  {
    double mass_lower, mass_upper, speed, step, shift;
  };
  for (const bool is_free : {false, true})
    for (const Case &c :
         {Case{1., 1., 5., 1e-7, 0.}, Case{1., 1., 50., 1e-6, 0.3}, Case{1., 1., 500., 4e-7, 0.5},
          Case{1e-4, 1., 100., 2e-7, 0.3}, Case{1., 1e-4, 100., 2e-7, 0.3}, Case{1., 1e-4, 500., 1e-6, 0.}})
      {
        Plates plates(c.mass_lower, c.mass_upper, c.speed, SelfContact::default_damping_ratio, is_free, c.shift);
        // of the kinetic energy that a collision can take: that of the reduced mass
        const double scale = 0.5 * c.speed * c.speed / (1. / c.mass_lower + 1. / c.mass_upper);
        const double start = plates.scene.kinetic();
        plates.scene.compute(c.step);
        double    last    = 0.;
        const int n_steps = static_cast<int>(1.5e-3 / (c.speed * c.step)) + 200; // thrice the way to the first touch
        for (int k = 0; k < n_steps; ++k)
          {
            plates.scene.advance(c.step);
            const SelfContactReport &report = plates.scene.contact.report();
            ASSERT_GE(report.dissipated_energy, last - 1e-12 * scale);
            last = report.dissipated_energy;
            // springs that set in or end within a step: a tenth of it at most (self_contact.h), and of what is made
            // then the dampers have taken more before
            ASSERT_LT(plates.scene.kinetic() + report.stored_energy - start, 0.02 * scale);
            ASSERT_NEAR(energy_error(plates.scene, scale), 0., 0.03) << c.speed << " m/s, step " << k;
          }
        EXPECT_GT(last, 0.);
        EXPECT_LT(plates.scene.kinetic(), start);
        if (!is_free) // apart again, the upper one above
          {
            EXPECT_GT(plates.gap(), thickness);
          }
      }
}

TEST(SelfContact, ForcesHaveNoSumAndNoMomentAndDoNotDependOnTheFrame)
{
  // a tilted plate on a flat one, one-sided touches at edges and nodes: round-off of forces and arms
  SelfMasses scenes[2];
  for (const int moving : {0, 1})
    {
      SelfMasses  &scene = scenes[moving];
      const Point3 drift(moving * 300., moving * -200., 0.);
      scene.masses.add_plate(n_cells, n_cells, cell, thickness);
      scene.close_body(1., drift);
      scene.masses.add_patch(4, 4, thickness, [](const unsigned int i, const unsigned int j) {
        return Point3(7e-3 + 4e-3 * i, 6e-3 + 4e-3 * j, 2.2e-3 + 1e-3 * i + 0.5e-3 * j);
      });
      scene.close_body(0.4, Point3(20., -10., -100.) + drift, true);
      scene.compute(2e-7);
      std::size_t most = 0;
      for (int k = 0; k < 200; ++k)
        {
          scene.advance(2e-7);
          most = std::max(most, scene.contact.report().n_touching);
          Point3       moment(0., 0., 0.);
          const double largest = scene.largest_force();
          EXPECT_LE(scene.force_sum(&moment).norm(), 1e-13 * largest);
          EXPECT_LE(moment.norm(), 1e-13 * largest * 0.05);
        }
      EXPECT_GT(most, 1U);
    }
  // the moving frame's positions have lost three digits of the gap; a wrong frame would show in the first digit
  EXPECT_NEAR(scenes[0].contact.report().dissipated_energy / scenes[1].contact.report().dissipated_energy, 1., 1e-6);
}

TEST(SelfContact, ClosedBlocksPushEachOtherApart)
{
  // skins of half thickness 0, normals outwards: inside is what came from outside
  SelfMasses scene;
  scene.masses.two_sided = false;
  const auto add_cube    = [&](const Point3 &corner, const double size) {
    const auto         first = static_cast<std::uint32_t>(scene.masses.node.size());
    const std::int32_t f     = static_cast<std::int32_t>(scene.masses.facet.size());
    for (unsigned int k = 0; k < 8; ++k)
      scene.masses.node.push_back({corner + size * Point3(k & 1, k >> 1 & 1, k >> 2 & 1)});
    for (const auto &face : {std::array<std::uint32_t, 4>{{0, 2, 3, 1}},
                             {{4, 5, 7, 6}},
                             {{0, 1, 5, 4}},
                             {{2, 6, 7, 3}},
                             {{0, 4, 6, 2}},
                             {{1, 3, 7, 5}}})
      {
        scene.masses.facet.push_back({{first + face[0], first + face[1], first + face[2], first + face[3]}});
        scene.masses.half_thickness.push_back(0.);
      }
    // faces by number: bottom 0, top 1, front 2, back 3, left 4, right 5
    for (const auto &n : {std::array<std::int32_t, 4>{{4, 3, 5, 2}},
                          {{2, 5, 3, 4}},
                          {{0, 5, 1, 4}},
                          {{4, 1, 5, 0}},
                          {{2, 1, 3, 0}},
                          {{0, 3, 1, 2}}})
      scene.masses.neighbor.push_back({{f + n[0], f + n[1], f + n[2], f + n[3]}});
  };
  add_cube(Point3(0., 0., 0.), 10e-3);
  scene.close_body(1., Point3(0., 0., 0.));
  add_cube(Point3(2e-3, 3e-3, 10.3e-3), 5e-3); // its corners strike the face
  scene.close_body(1., Point3(0., 0., -80.));
  const double start = scene.kinetic();
  scene.compute(2e-7);
  double deepest = 1.;
  for (int k = 0; k < 300; ++k)
    {
      scene.advance(2e-7);
      deepest = std::min(deepest, scene.height(8, 16, true) - scene.height(0, 8, false));
    }
  EXPECT_GT(deepest, -0.1e-3); // five steps' flight: a depth of u sqrt(m/k)
  EXPECT_LT(deepest, 0.);      // there is no thickness: it must have been inside
  EXPECT_GT(scene.height(8, 16, true), scene.height(0, 8, false));
  EXPECT_NEAR(scene.body[0].velocity[2] + scene.body[1].velocity[2], -80., 1e-11);
  EXPECT_GT(scene.body[1].velocity[2] - scene.body[0].velocity[2], 0.5 * 80.); // damped, not stuck
  EXPECT_LT(scene.kinetic(), start);
}

TEST(SelfContact, WhatOverlapsUndeformedCarriesNoForce)
{
  Plates plates(1., 1., 0., 0.1, false, 0.3, -0.5e-3); // mid-surfaces 1.5 mm apart, 2 mm thick
  plates.scene.compute(1e-7);
  plates.scene.compute(1e-7);
  EXPECT_TRUE(plates.scene.contact.forces().empty());
  for (std::size_t n = plates.n_lower; n < plates.scene.masses.node.size(); ++n)
    plates.scene.masses.node[n].position[2] -= 0.1e-3;
  plates.scene.compute(1e-7);
  EXPECT_NEAR(plates.scene.contact.report().max_penetration, 0.1e-3, 1e-12); // and from there on it does
}

TEST(SelfContact, ABentSheetDoesNotTouchItself)
{
  // elements finer than the thickness, rolled up to three quarters of a circle of a radius of one thickness and a half
  SelfMasses   scene;
  const double h = 0.5e-3, radius = 1.5 * thickness;
  scene.masses.add_plate(28, 4, h, thickness);
  scene.close_body(1., Point3(0., 0., 0.), true);
  scene.compute(1e-7);
  const auto flat = scene.masses.node;
  for (int k = 1; k <= 60; ++k)
    {
      const double curvature = k / (60. * radius);
      for (std::size_t n = 0; n < flat.size(); ++n)
        {
          const double s = flat[n].position[0] * curvature;
          scene.masses.node[n].position =
            Point3(std::sin(s) / curvature, flat[n].position[1], (1. - std::cos(s)) / curvature);
        }
      scene.compute(1e-7);
      ASSERT_EQ(scene.contact.report().n_touching, 0U) << "curvature " << curvature;
    }
}

TEST(SelfContact, ASheetFoldedFlatTouchesItselfAtItsThickness)
{
  // hinged along its middle: the outer half turns about y until both halves lie on one another
  SelfMasses scene;
  scene.masses.add_plate(2 * n_cells, 4, cell, thickness);
  scene.close_body(1., Point3(0., 0., 0.), true);
  scene.compute(1e-7);
  const auto   flat   = scene.masses.node;
  const double middle = n_cells * cell;
  double       first  = 0.;
  for (int k = 1; k <= 1000 && first == 0.; ++k)
    {
      const double angle = k * M_PI / 1000.;
      for (std::size_t n = 0; n < flat.size(); ++n)
        if (const double r = flat[n].position[0] - middle; r > 0.)
          scene.masses.node[n].position =
            Point3(middle + r * std::cos(angle), flat[n].position[1], r * std::sin(angle));
      scene.compute(1e-7);
      if (scene.contact.report().n_touching > 0)
        first = angle;
    }
  // the first nodes off the hinge are those of the second row: their facets' neighbourhood ends at two thicknesses.
  // Their distance from the other half is r sin(pi - angle): a thickness at r = 5 mm makes 156.4 degrees; a step of the
  // fold is 0.18 degrees
  EXPECT_NEAR(first * 180. / M_PI, 180. - std::asin(thickness / cell) * 180. / M_PI, 0.2);
}

TEST(SelfContact, LooksOnlyAsOftenAsPartsMove)
{
  Plates plates(1., 1., 10., 0.1, false, 0.3, 0.5);
  plates.scene.compute(1e-6);
  EXPECT_EQ(plates.scene.contact.report().looks, 1U);
  for (FreeMasses::Node &node : plates.scene.masses.node)
    node.position += Point3(1., -2., 3.);
  plates.scene.compute(1e-6); // all as one: nothing has come nearer
  EXPECT_EQ(plates.scene.contact.report().looks, 1U);
  for (int k = 0; k < 1000; ++k) // 10 mm; a look every 0.375 of half a cell's side (0.94 mm): the other could move
    plates.scene.advance(1e-6);
  EXPECT_LE(plates.scene.contact.report().looks, 12U);
  EXPECT_EQ(plates.scene.contact.report().pairs_tested, 0U);
}

TEST(SelfContact, AFacetThatGoesTakesNoEnergyWithItUnbooked)
{
  Plates plates(1., 1., 50., 0.1, false);
  plates.scene.compute(1e-7);
  while (plates.scene.contact.report().stored_energy < 1.)
    plates.scene.advance(1e-7);
  const SelfContactReport before = plates.scene.contact.report();
  while (plates.scene.masses.facet.size() > n_cells * n_cells) // the upper plate's
    plates.scene.masses.remove_facet(n_cells * n_cells);
  while (plates.scene.masses.facet.size() > 0)
    plates.scene.masses.remove_facet(0);
  plates.scene.compute(1e-7);
  const SelfContactReport &after = plates.scene.contact.report();
  EXPECT_TRUE(plates.scene.contact.forces().empty());
  EXPECT_EQ(after.stored_energy, 0.);
  EXPECT_GE(after.dissipated_energy, before.dissipated_energy + before.stored_energy);
}
