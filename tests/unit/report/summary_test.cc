#include <birdstrike/report/summary.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <limits>

using birdstrike::Summary;

TEST(Summary, HasTheStableKeys)
{
  const nlohmann::json                                                json = Summary();
  const std::vector<std::pair<std::string, std::vector<std::string>>> keys{
    {"case", {}},
    {"program", {"version", "build"}},
    {"inputs", {}},
    {"end", {"time", "reason"}},
    {"blade", {"kind", "elements", "nodes", "mass", "added_rotary_inertia"}},
    {"bird", {"particles", "mass", "kinetic_energy", "momentum"}},
    {"steps", {"blade", "bird"}},
    {"tip", {"peak", "peak_time", "final"}},
    {"root", {"peak_normal_stress", "peak_normal_stress_time", "peak_moment", "peak_force"}},
    {"contact", {"impulse", "peak_force", "peak_force_time", "max_penetration", "max_penetration_over_spacing"}},
    {"plastic", {"max_strain", "position", "work"}},
    {"failed", {"elements", "collapsed", "at_root", "mass", "free_mass", "energy"}},
    {"energy",
     {"initial", "final", "max_relative_error", "max_hourglass_over_internal", "bird_internal", "parts",
      "error_origins"}},
    {"momentum", {"max_relative_error"}},
    {"angular_momentum", {"max_relative_error"}},
    {"retired", {"particles", "mass", "energy"}},
    {"skipped", {}},
    {"cost", {"wall", "threads", "ns_per_particle_step", "ns_per_element_step", "peak_memory"}}};
  EXPECT_EQ(json.size(), keys.size());
  for (const auto &[key, members] : keys)
    {
      ASSERT_TRUE(json.contains(key)) << key;
      EXPECT_TRUE(members.empty() || json[key].size() == members.size()) << key;
      for (const std::string &member : members)
        EXPECT_TRUE(json[key].contains(member)) << key << "/" << member;
    }
  EXPECT_TRUE(json["skipped"].is_object());
  EXPECT_TRUE(json["energy"]["parts"].is_object());
  EXPECT_EQ(json["bird"]["momentum"].size(), 3u);
}

TEST(Summary, NamesSkippedWork)
{
  Summary summary;
  summary.skipped = {{"flight", 2e-3, "s", 0.25}, {"bird", 1., "part", std::numeric_limits<double>::quiet_NaN()}};
  const auto json = nlohmann::json::parse(to_text(summary))["skipped"];
  EXPECT_EQ(json["flight"]["count"], 2e-3);
  EXPECT_EQ(json["flight"]["saved"], 0.25);
  EXPECT_TRUE(json["bird"]["saved"].is_null());
}

TEST(Summary, KeepsEveryDigitAndTurnsNanIntoNull)
{
  Summary summary;
  summary.case_name                     = "frontal \"strike\"";
  summary.tip.peak                      = 0.1 + 0.2;
  summary.root.peak_moment              = std::numeric_limits<double>::quiet_NaN();
  summary.contact.impulse               = {{1., 2., -3.}};
  summary.energy.parts["blade_plastic"] = 12.5;
  summary.steps.blade                   = 1234567890123;
  const auto json                       = nlohmann::json::parse(to_text(summary));
  EXPECT_EQ(json["case"], "frontal \"strike\"");
  EXPECT_EQ(json["tip"]["peak"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(json["root"]["peak_moment"].is_null());
  EXPECT_EQ(json["contact"]["impulse"], (std::vector<double>{1., 2., -3.}));
  EXPECT_EQ(json["energy"]["parts"]["blade_plastic"], 12.5);
  EXPECT_EQ(json["steps"]["blade"], 1234567890123);
}

TEST(Summary, PeakMemoryGrowsWithWhatIsTouched)
{
  const std::size_t       before = birdstrike::compute_peak_memory();
  const std::vector<char> block(2 * before, 'x');
  EXPECT_GE(birdstrike::compute_peak_memory(), 2 * before) << block.back();
}
