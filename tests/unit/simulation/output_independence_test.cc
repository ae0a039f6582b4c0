#include "strike_harness.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

/// What comes out does not depend on when it is written.
namespace
{
  Strike run_quickstart(std::vector<std::string> more)
  {
    const std::vector<std::string> coarse{"Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=14",
                                          "Blade/Mesh/Elements along chord=4", "Time/End time=1e-3"};
    more.insert(more.begin(), coarse.begin(), coarse.end());
    return run_shipped("quickstart.prm", more);
  }

  /// All of summary.json but what a clock has measured.
  nlohmann::ordered_json without_clock(const Summary &summary)
  {
    nlohmann::ordered_json json = summary.json;
    json.erase("cost");
    for (auto &item : json["skipped"])
      item.erase("saved");
    return json;
  }
} // namespace

TEST(OutputIndependence, NoFigureOfTheSummaryDependsOnAnInterval)
{
  for (const std::vector<std::string> &scene : {std::vector<std::string>{},
                                                {"Case/Symmetry plane=y"},
                                                {"Blade/Mesh/Elements along chord=2", "Time/Multirate=true"}})
    {
      const auto with = [&](std::vector<std::string> entries) {
        entries.insert(entries.end(), scene.begin(), scene.end());
        return without_clock(run_quickstart(entries).summary);
      };
      const nlohmann::ordered_json reference = with({"Output/History interval=1e-5"});
      for (const std::string entry : {"Output/History interval=5e-6", "Output/History interval=0",
                                      "Output/History interval=1", "Output/Flush interval=0"})
        EXPECT_EQ(with({entry}), reference) << entry << "\n"
                                            << nlohmann::ordered_json::diff(reference, with({entry})).dump(2);
      EXPECT_EQ(with({"Output/Field interval=3e-5", "Output/Console interval=1e-9"}), reference);
    }
}

TEST(OutputIndependence, RowsShowThePeaksBetweenThem)
{
  const Strike often  = run_quickstart({"Output/History interval=0"}),
               seldom = run_quickstart({"Output/History interval=1e-4"});
  const auto largest  = [](const std::vector<double> &values) {
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_EQ(largest(often.curves.at("contact_force_peak")), often.summary.number("contact/peak_force"));
  EXPECT_EQ(largest(seldom.curves.at("contact_force_peak")), seldom.summary.number("contact/peak_force"));
  EXPECT_EQ(often.summary.number("contact/peak_force"), seldom.summary.number("contact/peak_force"));
  EXPECT_LT(largest(seldom.curves.at("contact_force_z")), 0.8 * seldom.summary.number("contact/peak_force"))
    << "samples miss it";

  const auto &tip = often.curves.at("tip_mid_chord"), &moment = often.curves.at("root_bending_moment");
  double      tip_peak = 0., moment_peak = 0.;
  for (std::size_t k = 0; k < tip.size(); ++k)
    {
      tip_peak    = std::abs(tip[k]) > std::abs(tip_peak) ? tip[k] : tip_peak;
      moment_peak = std::max(moment_peak, std::abs(moment[k]));
    }
  EXPECT_EQ(tip_peak, seldom.summary.number("tip/peak")) << "a row at every step misses nothing";
  EXPECT_EQ(moment_peak, seldom.summary.number("root/peak_moment"));
}

// The mirror image of the scene at the plane of the blade: all that has no direction is the same to round-off, which
// the bird's float pairs amplify (0.5 % as in the tests of symmetry).
TEST(OutputIndependence, NoFigureDependsOnTheSideThatIsStruck)
{
  const Summary below = run_quickstart({}).summary, above = run_quickstart({"Bird/Velocity=0,0,-177.4"}).summary;
  EXPECT_GT(below.number("tip/final"), 0.);
  EXPECT_NEAR(above.number("tip/final") / below.number("tip/final"), 1., 5e-3);
  EXPECT_NEAR(above.number("tip/peak") / below.number("tip/peak"), 1., 5e-3);
  EXPECT_NEAR(above.number("root/peak_moment") / below.number("root/peak_moment"), 1., 5e-3);
  EXPECT_NEAR(above.number("contact/peak_force") / below.number("contact/peak_force"), 1., 5e-3);
  EXPECT_NEAR(above.number("contact/impulse/2") / below.number("contact/impulse/2"), -1., 5e-3);
}
