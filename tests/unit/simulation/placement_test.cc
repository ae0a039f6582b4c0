#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;

/// Where a bird is when the clock starts: touching, nowhere inside, having passed through nothing.
namespace
{
  const std::vector<std::string> square_plate{"Blade/Mesh/Length=0.3",
                                              "Blade/Mesh/Chord=0.3",
                                              "Blade/Mesh/Elements along span=10",
                                              "Blade/Mesh/Elements along chord=10",
                                              "Blade/Thickness/Value=0.01",
                                              "Blade/Supports/Clamped=0,1,2,3",
                                              "Bird/Particle spacing=0.008",
                                              "Bird/Aim point=0.15, 0, 0"};

  void expect_first_touch(std::vector<std::string> entries)
  {
    entries.insert(entries.begin(), square_plate.begin(), square_plate.end());
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", entries);
    Scene            scene(parameters);
    const PointsView points = scene.birds.front().bird->points();
    const FacetsView facets = scene.blade->facets();
    // placed a millionth of a spacing before it, to round-off of a flight of less than a metre
    const auto  &v      = parameters.bird.velocity;
    const double before = 1e-6 * parameters.bird.spacing / std::hypot(v[0], v[1], v[2]);
    EXPECT_EQ(initial_overlap(points, facets).depth, 0.) << entries.back();
    EXPECT_NEAR(time_to_first_touch(points, facets), before, 1e-12) << entries.back();
  }

  std::string refusal(std::vector<std::string> entries)
  {
    entries.insert(entries.begin(), square_plate.begin(), square_plate.end());
    CaseParameters parameters;
    parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", entries);
    try
      {
        Scene scene(parameters);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(Placement, ABirdOfAnyIncidenceStartsAtFirstTouch)
{
  for (const double degree : {0.5, 1., 5., 10., 30., 60., 90., 175., -5.})
    {
      const double a = degree * std::acos(-1.) / 180.;
      expect_first_touch(
        {"Bird/Velocity=0, " + std::to_string(200. * std::cos(a)) + ", " + std::to_string(200. * std::sin(a))});
      expect_first_touch(
        {"Bird/Velocity=" + std::to_string(200. * std::cos(a)) + ", 0, " + std::to_string(200. * std::sin(a))});
    }
}

TEST(Placement, ABirdWiderThanTheBladeOrAimedBesideItStartsAtFirstTouch)
{
  expect_first_touch({"Bird/Mass=20", "Bird/Particle spacing=0.03", "Bird/Velocity=0, 199, 17"});
  expect_first_touch({"Bird/Mass=20", "Bird/Particle spacing=0.03", "Bird/Velocity=199, 0, 0"});
  expect_first_touch({"Bird/Velocity=0, 199, 17", "Bird/Aim point=0.15, 0, 0.015"});
  expect_first_touch({"Bird/Velocity=0, 0, 177.4", "Bird/Aim point=0.15, 0, 0.5"}); // 0.5 m behind the blade
  expect_first_touch({"Bird/Yaw=80", "Bird/Velocity=0, 199, 17"});
}

TEST(Placement, ABirdThatStandsStillIsRefusedAsSuch)
{
  for (const std::string entry : {"Bird/Stand-off=0", "Bird/Stand-off=0.5"})
    {
      const std::string still = refusal({"Bird/Velocity=0, 0, 0", entry});
      EXPECT_NE(still.find("does not close in"), std::string::npos) << still;
      EXPECT_EQ(still.find("inside"), std::string::npos) << still;
    }
}

TEST(Placement, AdviceIsNeverWhatIsSetAlready)
{
  const std::string near = refusal({"Bird/Velocity=0, 199, 17", "Bird/Stand-off=0.01"});
  EXPECT_NE(near.find("Enlarge Bird/Stand-off, or set it to 0"), std::string::npos) << near;
  const std::string slab = refusal({"Bird/Shape=slab", "Bird/Slab lengths=0.04,0.04,0.04", "Bird/Velocity=0, 0, 100"});
  EXPECT_NE(slab.find("inside"), std::string::npos) << slab;
  EXPECT_EQ(slab.find("Stand-off"), std::string::npos) << slab;
}
