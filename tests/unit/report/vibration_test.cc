#include <birdstrike/report/vibration.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;

namespace vibration_test
{
  /// At each speed the shapes e_0, e_1, ... of a space of `n` dimensions, in the order of their frequencies.
  ModesAtSpeed at(const double speed, const std::vector<std::pair<double, std::vector<double>>> &modes)
  {
    ModesAtSpeed result{speed, {}};
    for (const auto &[frequency, shape] : modes)
      result.modes.modes.push_back({frequency, shape, {}});
    return result;
  }

  const std::vector<double> flap{1., 0., 0.}, torsion{0., 1., 0.}, edgewise{0., 0., 1.};
} // namespace vibration_test

// Flap rises with the speed through torsion and edgewise: its curve stays flap's, and theirs theirs, though each speed
// counts them anew, and though edgewise is none of the two that are asked for.
TEST(Vibration, ModesThatAreCrossedFromAboveKeepTheirShapes)
{
  using namespace vibration_test;
  const std::vector<ModesAtSpeed> speeds{at(0., {{100., flap}, {110., torsion}, {130., edgewise}}),
                                         at(1., {{110., torsion}, {120., flap}, {130., edgewise}}),
                                         at(2., {{110., torsion}, {130., edgewise}, {140., flap}})};
  const auto                      followed = follow_modes(speeds, 2);
  EXPECT_EQ(followed, (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 0}, {2, 0}}));
  EXPECT_GE(n_spare_modes(2, 3), 3U);
  EXPECT_EQ(n_spare_modes(2, 1), 0U);
}

// Where flap is no longer among those that were found its curve ends; edgewise, unlike it, does not take its place.
TEST(Vibration, AModeToWhichNoneIsLikeEnds)
{
  using namespace vibration_test;
  const std::vector<ModesAtSpeed> speeds{at(0., {{100., flap}, {110., torsion}}),
                                         at(1., {{110., torsion}, {130., edgewise}}),
                                         at(2., {{110., torsion}, {140., flap}})};
  EXPECT_EQ(follow_modes(speeds, 2), (std::vector<std::vector<std::size_t>>{{0, 1}, {no_mode, 0}, {no_mode, 0}}));
}

// Of two curves that want one mode the more alike has it: 0.9 of torsion and the rest of flap.
TEST(Vibration, TheMostAlikeGoFirst)
{
  using namespace vibration_test;
  const double                    c = std::sqrt(0.9), s = std::sqrt(0.1);
  const std::vector<ModesAtSpeed> speeds{at(0., {{100., flap}, {110., torsion}}),
                                         at(1., {{105., {s, c, 0.}}, {106., {c, -s, 0.}}})};
  EXPECT_EQ(follow_modes(speeds, 2), (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 0}}));
}

// An unstable mode has no frequency, and no engine order: the table says so and how fast it grows.
TEST(Vibration, AnUnstableModeIsCalledSo)
{
  using namespace vibration_test;
  ModesAtSpeed at_speed               = at(100., {{0., flap}, {110., torsion}});
  at_speed.modes.modes[0].growth_rate = 100. * std::log(10.); // tenfold in 10 ms
  const std::string text              = describe_modes(at_speed, 2);
  EXPECT_NE(text.find("unstable"), std::string::npos) << text;
  EXPECT_NE(text.find("tenfold in 10 ms"), std::string::npos) << text;
  EXPECT_NE(text.find("110"), std::string::npos) << text;
  EXPECT_EQ(text.find(" -1"), std::string::npos) << text;
}
