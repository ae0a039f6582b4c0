#include "free_masses.h"

#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <numbers>

using namespace birdstrike;
using birdstrike::test::FreeMasses;
using birdstrike::test::without_damper;

// A plate that has moved away by many radii and turned by half a turn about x = -y takes its discs along: what
// they read of the points that press on it is what they read before, to round-off. One of them lies half a millimetre
// off the surface, as a place on a shell's face does.
TEST(PressurePatches, GoWithTheSurface)
{
  const auto read = [](const bool is_moved) {
    const auto place = [&](const Point3 &x) -> Point3 {
      return is_moved ? Point3(0.5 - x[1], -0.3 - x[0], 0.1 - x[2]) : x;
    };
    FreeMasses scene;
    scene.add_plate(1, 1, 0.024, 0., Point3(-0.002, -0.002, 0.));
    ContactParameters parameters = without_damper();
    parameters.patches           = "middle: 0.0103 0.0103 0 0.0052; off: 0.0103 0.0101 5e-4 0.0043";
    Contact contact(parameters);
    contact.hold_patches(scene.facets());
    for (auto &node : scene.node)
      node.position = place(node.position);
    for (unsigned int i = 0; i < 20; ++i)
      for (unsigned int j = 0; j < 20; ++j)
        {
          FreeMasses::Point point;
          point.position = place(Point3(5e-4 + 1e-3 * i, 5e-4 + 1e-3 * j, 5.1e-4));
          scene.add_point(point);
        }
    ThreadPool pool;
    scene.compute_contact(contact, 1e-7, pool);
    for (std::size_t p = 0; p < 400; ++p)
      scene.x[2][p] += is_moved ? 1.1e-4 : -1.1e-4;
    scene.compute_contact(contact, 1e-7, pool);
    return contact.report().patch_pressures;
  };
  const auto before = read(false), after = read(true);
  for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_GT(before[k], 5e7) << k;
      EXPECT_NEAR(after[k], before[k], 1e-9 * before[k]) << k;
    }
}

TEST(PressurePatches, BesideTheSurfaceAreRefused)
{
  FreeMasses scene;
  scene.add_plate(1, 1, 0.024, 0.);
  for (const auto &[disc, is_on] :
       {std::pair("0.01 0.01 0.0019 0.002", true), std::pair("0.01 0.01 0.0021 0.002", false),
        std::pair("0.0261 0.01 0 0.002", false)})
    {
      ContactParameters parameters;
      parameters.patches = "here: 0.01 0.01 0 0.002; there: " + std::string(disc);
      Contact     contact(parameters);
      std::string said;
      try
        {
          contact.hold_patches(scene.facets());
        }
      catch (const InputError &error)
        {
          said = error.what();
        }
      EXPECT_EQ(said.empty(), is_on) << disc;
      EXPECT_TRUE(is_on || said.starts_with("Contact/Pressure patches: 'there' at (")) << said;
    }
}

// Half of a disc about a place on an edge covers the blade, a quarter of one about a corner: forces are over that, to
// one of the 4096 places by which the share is found in each of its rows across the disc.
TEST(PressurePatches, WhatLiesBeyondAnEdgeDoesNotCount)
{
  const auto read = [](const bool is_half) {
    FreeMasses scene;
    scene.add_plate(12, is_half ? 6 : 12, 0.002, 0., Point3(0., is_half ? 0. : -0.012, 0.));
    if (is_half)
      {
        scene.plane = SymmetryPlane(true);
        for (auto &neighbors : scene.neighbor)
          neighbors[0] = neighbors[0] == FacetsView::free_edge ? FacetsView::symmetry_edge : neighbors[0];
      }
    for (unsigned int i = 0; i < 8; ++i)
      for (int j = is_half ? 0 : -8; j < 8; ++j)
        {
          FreeMasses::Point point;
          point.position = Point3(3.5e-3 + 1e-3 * i, 5e-4 + 1e-3 * j, 5.1e-4); // no edge within their reach
          scene.add_point(point);
        }
    ContactParameters parameters = without_damper();
    parameters.patches           = "inside: 0.012 0 0 0.005; edge: 0 0 0 0.0052; corner: 0 0.012 0 0.008";
    Contact contact(parameters);
    contact.hold_patches(scene.facets());
    ThreadPool pool;
    scene.compute_contact(contact, 1e-7, pool);
    for (auto &z : scene.x[2])
      z = 4e-4;
    scene.compute_contact(contact, 1e-7, pool);
    return contact.report().patch_pressures;
  };
  const double force = 1e-6 * 1e9 * 0.1; // N of each point
  for (const bool is_half : {false, true})
    {
      const auto count = [](const double x, const double y, const double radius) {
        int n = 0;
        for (int i = 0; i < 8; ++i)
          for (int j = -8; j < 8; ++j)
            n += std::hypot(3.5 + i - x, 0.5 + j - y) <= radius;
        return n;
      };
      const auto   pressures = read(is_half);
      const double pi        = std::numbers::pi * 1e-6;
      EXPECT_NEAR(pressures[0], count(12., 0., 5.) * force / (25. * pi), 1e-9 * pressures[0]);
      EXPECT_NEAR(pressures[1], count(0., 0., 5.2) * force / (0.5 * 27.04 * pi), 0.01 * pressures[1]);
      EXPECT_NEAR(pressures[2], count(0., 12., 8.) * force / (0.25 * 64. * pi), 0.01 * pressures[2]);
      EXPECT_GT(count(0., 12., 8.), 5);
    }
}

TEST(PressurePatches, FeelThePressureOfTheirPoints)
{
  FreeMasses scene;
  scene.add_plate(1, 1, 0.024, 0., Point3(-0.002, -0.002, 0.)); // no edge within reach
  for (unsigned int i = 0; i < 20; ++i)
    for (unsigned int j = 0; j < 20; ++j)
      {
        FreeMasses::Point point;
        point.position = Point3(5e-4 + 1e-3 * i, 5e-4 + 1e-3 * j, 5.1e-4);
        scene.add_point(point);
      }
  ContactParameters parameters = without_damper();
  parameters.patches           = "middle: 0.01 0.01 0 0.005; corner: 0.0 0.0 0.0 0.002; below: 0.01 0.01 -0.004 0.005";
  Contact    contact(parameters);
  ThreadPool pool;
  contact.hold_patches(scene.facets());
  scene.compute_contact(contact, 1e-7, pool);
  for (auto &z : scene.x[2])
    z = 4e-4;
  scene.compute_contact(contact, 1e-7, pool);
  const double pressure = 1e9 * 0.1; // rho c^2 d / V^(1/3) on each square millimetre
  EXPECT_NEAR(contact.report().patch_pressures[0] / pressure, 80. / (std::numbers::pi * 25.),
              1e-9); // 80 centres in r = 5
  EXPECT_NEAR(contact.report().patch_pressures[1] / pressure, 4. / (std::numbers::pi * 4.), 0.26);
  EXPECT_EQ(contact.report().patch_pressures[2], contact.report().patch_pressures[0]) << "the same disc of the surface";
  EXPECT_NEAR(-contact.report().force[2], 400. * 1e-6 * pressure, 1e-6);
}
