#include "../record.h"
#include "free_masses.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::g;
using birdstrike::test::plate_of_four;
using birdstrike::test::without_damper;

namespace
{
  /// D1: 10 g at 100 m/s against a free facet of 30 g; rho c^2 V^(1/3) = 1e8 N/m. They touch at the start.
  FreeMasses two_masses()
  {
    FreeMasses scene;
    scene.add_plate(1, 1, 0.01, 0.);
    for (auto &node : scene.node)
      node.inverse_mass = 1. / 0.0075;
    FreeMasses::Point point;
    point.position    = Point3(0.005, 0.005, 0.5e-3);
    point.velocity    = Point3(0., 0., -100.);
    point.mass        = 0.010;
    point.density     = 1000.;
    point.sound_speed = 1e4;
    scene.add_point(point);
    return scene;
  }
  const double omega = std::sqrt(1e8 / 0.0075);

  struct Rebound
  {
    double point_speed, facet_speed, duration, impulse;
  };

  Rebound rebound(FreeMasses &scene, Contact &contact, const double step)
  {
    ThreadPool pool;
    scene.compute_contact(contact, step, pool);
    double time = 0.;
    do
      {
        scene.advance(contact, step, pool);
        time += step;
      }
    while (contact.report().n_touching > 0 && time < 1e-3);
    return {-scene.v[2][0], -scene.node[0].velocity[2], time, 0.010 * (scene.v[2][0] + 100.)};
  }
} // namespace

// What is beyond the plane is as much again: forces on parts are those of the half, the report is of the whole.
TEST(Contact, ReportsTheWholeOfAHalf)
{
  ContactParameters parameters;
  parameters.patches = "on: 0 0 0 0.02; off: 0.005 0.005 0 0.02";
  FreeMasses half = two_masses(), all = half;
  half.plane = SymmetryPlane(true);
  Contact    of_half(parameters), of_all(parameters);
  ThreadPool pool;
  half.compute_contact(of_half, 1e-7, pool);
  all.compute_contact(of_all, 1e-7, pool);
  for (int k = 0; k < 3; ++k)
    {
      half.advance(of_half, 1e-7, pool);
      all.advance(of_all, 1e-7, pool);
    }
  const ContactReport &whole = of_half.report(), &part = of_all.report();
  ASSERT_GT(part.force[2] * part.force[2], 0.);
  EXPECT_EQ(half.force_on_point(0), all.force_on_point(0));
  EXPECT_EQ(whole.force, SymmetryPlane(true).whole(part.force));
  EXPECT_EQ(whole.stored_energy, 2. * part.stored_energy);
  EXPECT_EQ(whole.dissipated_energy, 2. * part.dissipated_energy);
  EXPECT_EQ(whole.n_touching, 2 * part.n_touching);
  EXPECT_EQ(whole.patch_pressures[0], 2. * part.patch_pressures[0]) << "the other half of the disc is the image's";
  EXPECT_EQ(whole.patch_pressures[1], part.patch_pressures[1]);
}

TEST(Contact, TwoMassesReboundElastically)
{
  // benchmark D1: period, depth, force, impulse exact; leapfrog's own error at omega dt = 0.01 is below 1e-4
  FreeMasses    scene = two_masses();
  Contact       contact(without_damper());
  const double  step  = 0.01 / omega;
  const Rebound after = rebound(scene, contact, step);
  record("duration", after.duration);
  record("penetration", contact.report().max_penetration);
  record("force", contact.report().peak_force);
  record("impulse", after.impulse);
  EXPECT_NEAR(after.duration, 2.720699e-5, 1.01 * step);
  EXPECT_NEAR(contact.report().max_penetration, 8.660254e-4, 1e-4 * 8.66e-4);
  EXPECT_NEAR(contact.report().peak_force, 86602.54, 1e-4 * 86602.);
  EXPECT_NEAR(contact.report().peak_force_time, 0.5 * 2.720699e-5, 1.01 * step);
  EXPECT_NEAR(after.impulse, 1.5, 1e-4 * 1.5);
  EXPECT_NEAR(after.point_speed, -50., 0.01);
  EXPECT_NEAR(after.facet_speed, 50., 0.01);
}

TEST(Contact, RestitutionStaysWithinHalfAPercentAtTheStabilityShare)
{
  for (const double omega_step : {0.05, 0.1, 0.2}) // D1, gate: 0.5 %
    {
      FreeMasses    scene = two_masses();
      Contact       contact(without_damper());
      const Rebound after = rebound(scene, contact, omega_step / omega);
      record("restitution " + std::to_string(omega_step).substr(0, 4), (after.facet_speed - after.point_speed) / 100.);
      EXPECT_NEAR((after.facet_speed - after.point_speed) / 100., 1., 5e-3) << omega_step;
    }
}

TEST(Contact, AStrongDamperMergesTheMassesAndDoesNotReverseThem)
{
  FreeMasses        scene = two_masses();
  ContactParameters parameters;
  parameters.damping_scale = 1e6;
  Contact    contact(parameters);
  ThreadPool pool;
  scene.compute_contact(contact, 1e-9, pool);
  for (unsigned int step = 0; step < 3; ++step)
    scene.advance(contact, 1e-9, pool);
  EXPECT_NEAR(scene.v[2][0], -25., 0.01); // D1: 25 m/s, three steps of spring change it by 1e-3
  EXPECT_NEAR(scene.node[0].velocity[2], -25., 0.01);
}

TEST(Contact, WorkOfBothSidesGoesIntoTheSpringAndComesBack)
{
  FreeMasses   scene = two_masses();
  Contact      contact(without_damper());
  ThreadPool   pool;
  const double step = 1e-3 / omega, energy = 0.5 * 0.010 * 100. * 100.;
  scene.compute_contact(contact, step, pool);
  double largest = 0.;
  for (unsigned int n = 0; n < 3300; ++n)
    {
      const double before = scene.contact_work;
      scene.advance(contact, step, pool);
      // the second half kick is booked with the force of the new position: work and spring are at the same instant
      EXPECT_NEAR(scene.contact_work + contact.report().stored_energy, 0., 1e-6 * energy) << n;
      largest = std::max(largest, contact.report().stored_energy);
      if (n > 3200)
        {
          EXPECT_EQ(scene.contact_work, before);
        }
    }
  EXPECT_NEAR(largest, 0.75 * energy, 1e-5 * energy); // all of the energy of the relative motion, m_red u^2 / 2
  EXPECT_EQ(contact.report().stored_energy, 0.);
}

TEST(Contact, WhatTheDamperTakesIsReported)
{
  FreeMasses scene     = two_masses();
  scene.density[0]     = 1e5; // the same stiffness, ten times the damper
  scene.sound_speed[0] = 1e3;
  Contact      contact{ContactParameters()};
  ThreadPool   pool;
  const double step       = 2e-4 / omega;
  double       dissipated = 0.;
  scene.compute_contact(contact, step, pool);
  double power = contact.report().dissipation_power;
  for (unsigned int n = 0; n < 40000; ++n)
    {
      scene.advance(contact, step, pool);
      dissipated += 0.5 * step * (power + contact.report().dissipation_power);
      power = contact.report().dissipation_power;
      // the damper lags by half a step: first order in the step
      ASSERT_NEAR(scene.contact_work + contact.report().stored_energy + dissipated, 0., 2e-3 * 37.5) << n;
    }
  EXPECT_GT(dissipated, 1.);
}

TEST(Contact, MomentumAndAngularMomentumAreKeptOnASkewedDeformableSurface)
{
  for (const double friction : {0., 0.3})
    {
      std::mt19937                           random(7);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      FreeMasses                             scene;
      scene.add_patch(4, 3, 1e-3, [&](const unsigned int i, const unsigned int j) {
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        return Point3(0.004 * i + 0.001 * j + 6e-4 * a, 0.004 * j + 6e-4 * b, 0.3 + 5e-4 * c);
      });
      for (auto &node : scene.node)
        {
          node.inverse_mass = 1. / (2e-5 * (1.5 + uniform(random)));
          node.velocity     = 20. * Point3(uniform(random), uniform(random), uniform(random));
        }
      for (unsigned int i = 0; i < 400; ++i)
        {
          FreeMasses::Point point;
          point.position =
            Point3(0.009 + 0.01 * uniform(random), 0.006 + 0.008 * uniform(random), 0.3 + 2e-3 * uniform(random));
          point.velocity = 100. * Point3(uniform(random), uniform(random), uniform(random));
          scene.add_point(point);
        }
      ContactParameters parameters;
      parameters.friction = friction;
      Contact    contact(parameters);
      ThreadPool pool;
      scene.compute_contact(contact, 1e-7, pool); // first call: references
      const Point3 before = scene.momentum();
      for (unsigned int n = 0; n < 50; ++n)
        {
          scene.advance(contact, 1e-7, pool);
          Point3 force(0., 0., 0.), moment(0., 0., 0.), on_facets(0., 0., 0.);
          double scale = 0.;
          for (std::size_t i = 0; i < scene.id.size(); ++i)
            {
              force += scene.force_on_point(i);
              moment += scene.position(i).cross(scene.force_on_point(i));
              scale += scene.force_on_point(i).norm();
            }
          for (std::size_t k = 0; k < scene.node.size(); ++k)
            {
              on_facets += scene.force_on_node(k);
              moment += scene.node[k].position.cross(scene.force_on_node(k));
            }
          ASSERT_GT(scale, 0.);
          EXPECT_LT((force + on_facets).norm(), 1e-12 * scale);
          EXPECT_LT(moment.norm(), 1e-10 * scale * 0.3); // lever arm of the origin
          EXPECT_NEAR((on_facets - Point3(contact.report().force.data())).norm(), 0., 1e-12 * scale);
        }
      EXPECT_LT((scene.momentum() - before).norm(), 1e-12 * 400 * 1e-6 * 100. * 50);
    }
}

TEST(Contact, AnObliqueFrictionlessHitKeepsTheTangentialSpeed)
{
  FreeMasses        scene = plate_of_four();
  FreeMasses::Point point;
  const double      angle = 36.4 * std::numbers::pi / 180.;
  point.position          = Point3(0.004, 0.002, g);
  point.velocity          = 200. * Point3(0., std::cos(angle), -std::sin(angle));
  scene.add_point(point);
  Contact    contact{ContactParameters()};
  ThreadPool pool;
  scene.compute_contact(contact, 2e-7, pool);
  for (unsigned int n = 0; n < 200; ++n)
    scene.advance(contact, 2e-7, pool);
  EXPECT_NEAR(scene.v[1][0], 200. * std::cos(angle), 1e-10); // D4, round-off: it crosses the facets' common edge
  EXPECT_NEAR(scene.v[0][0], 0., 1e-10);
  EXPECT_GT(scene.v[2][0], 0.);
}

TEST(Contact, FrictionTakesItsShareOfTheNormalImpulse)
{
  FreeMasses        scene = plate_of_four();
  FreeMasses::Point point;
  point.position = Point3(0.004, 0.002, g);
  point.velocity = Point3(0., 100., -50.);
  scene.add_point(point);
  ContactParameters parameters;
  parameters.friction = 0.2;
  Contact    contact(parameters);
  ThreadPool pool;
  scene.compute_contact(contact, 2e-7, pool);
  for (unsigned int n = 0; n < 200; ++n)
    scene.advance(contact, 2e-7, pool);
  EXPECT_GT(scene.v[2][0], 0.);
  EXPECT_NEAR(100. - scene.v[1][0], 0.2 * (scene.v[2][0] + 50.), 1e-10); // it slides all the time
}

TEST(Contact, PointsThatStartInsideFeelNoForceUntilTheyGoDeeper)
{
  FreeMasses        scene = plate_of_four();
  FreeMasses::Point point;
  point.position = Point3(0.005, 0.005, 0.8 * g);
  scene.add_point(point);
  Contact    contact(without_damper());
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  EXPECT_EQ(scene.force_on_point(0).norm(), 0.);
  scene.place(0, Point3(0.005, 0.005, 0.7 * g));
  scene.compute_contact(contact, 1e-7, pool);
  EXPECT_NEAR(scene.force_on_point(0)[2], 1e9 * 1e-3 * 0.1 * g, 1e-6); // rho c^2 V^(1/3) d
  scene.place(0, Point3(0.005, 0.005, 0.9 * g));                       // on the way out the reference follows
  scene.compute_contact(contact, 1e-7, pool);
  EXPECT_EQ(scene.force_on_point(0).norm(), 0.);
  scene.place(0, Point3(0.005, 0.005, 0.8 * g));
  scene.compute_contact(contact, 1e-7, pool);
  EXPECT_NEAR(scene.force_on_point(0)[2], 1e9 * 1e-3 * 0.1 * g, 1e-6);
}

TEST(Contact, ThreadsDoNotChangeABit)
{
  const auto run = [](const std::size_t n_threads) {
    FreeMasses scene;
    scene.add_patch(12, 10, 1e-3, [](const unsigned int i, const unsigned int j) {
      return Point3(4e-3 * i, 4e-3 * j, 1e-3 * std::sin(0.7 * i) * std::cos(0.5 * j));
    });
    for (auto &node : scene.node)
      node.inverse_mass = 1e5;
    for (unsigned int i = 0; i < 3000; ++i)
      {
        FreeMasses::Point point;
        point.position = Point3(4e-4 + 8e-4 * (i % 60), 4e-4 + 8e-4 * (i / 60), 2.4e-3);
        point.velocity = Point3(10., 5., -150.);
        scene.add_point(point);
      }
    Contact    contact{ContactParameters()};
    ThreadPool pool(n_threads);
    scene.compute_contact(contact, 2e-7, pool);
    for (unsigned int n = 0; n < 60; ++n)
      scene.advance(contact, 2e-7, pool);
    auto result = scene.node_force;
    for (unsigned int d = 0; d < 3; ++d)
      result.insert(result.end(), scene.x[d].begin(), scene.x[d].end());
    result.push_back(contact.report().stored_energy);
    result.push_back(contact.report().peak_force);
    EXPECT_GT(contact.report().n_touching, 100u);
    return result;
  };
  EXPECT_EQ(run(1), run(2)); // bitwise
}
