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
  parameters.patches           = "middle: 0.01 0.01 0 0.005; corner: 0.0 0.0 0.0 0.002";
  Contact    contact(parameters);
  ThreadPool pool;
  scene.compute_contact(contact, 1e-7, pool);
  for (auto &z : scene.x[2])
    z = 4e-4;
  scene.compute_contact(contact, 1e-7, pool);
  const double pressure = 1e9 * 0.1; // rho c^2 d / V^(1/3) on each square millimetre
  EXPECT_NEAR(contact.report().patch_pressures[0] / pressure, 80. / (std::numbers::pi * 25.),
              1e-9); // 80 centres in r = 5
  EXPECT_NEAR(contact.report().patch_pressures[1] / pressure, 4. / (std::numbers::pi * 4.), 0.26);
  EXPECT_NEAR(-contact.report().force[2], 400. * 1e-6 * pressure, 1e-6);
}
