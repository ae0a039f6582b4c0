#include "strike_harness.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

// Nothing in the equations of a strike has a length or a time of its own: with lengths and times f times as large, and
// the same speeds, moduli and densities, impulses and energies are f^3 times, deflections f times as large. By powers
// of two every product is the same to the last bit, so what differs comes from a constant in m, s or J.
namespace
{
  /// The coarse frontal strike with all its lengths and times f times as large, until the bird has gone.
  Strike run_scaled(const double f)
  {
    const auto entry = [](const std::string &name, const double value) {
      return fmt::format("{}={:.17g}", name, value);
    };
    return run_shipped("quickstart.prm",
                       {"Blade/Mesh/Elements along span=20", "Blade/Mesh/Elements along chord=6",
                        entry("Blade/Mesh/Length", 0.3112 * f), entry("Blade/Mesh/Chord", 0.0889 * f),
                        entry("Blade/Thickness/Value", 0.00427 * f), entry("Bird/Mass", 0.1005 * f * f * f),
                        entry("Bird/Particle spacing", 0.006 * f),
                        fmt::format("Bird/Aim point={:.17g}, 0, 0", 0.21784 * f), entry("Time/End time", 4e-3 * f),
                        entry("Output/History interval", 5e-6 * f), "Output/Channel class=none"});
  }

  void expect_same(const Strike &one, const Strike &other, const char *quantity, const double factor)
  {
    const double here = one.summary.number(quantity), there = other.summary.number(quantity) / factor;
    EXPECT_NEAR(there, here, 1e-5 * std::abs(here)) << quantity << " at scale " << std::cbrt(factor);
  }
} // namespace

TEST(Scale, AStrikeOfOtherLengthsAndTimesIsTheSame)
{
  const Strike here = run_scaled(1.);
  EXPECT_GT(here.summary.number("retired/particles"), 0.) << "what is removed, and when, must be seen";
  for (const double f : {1024., 1. / 1024.})
    {
      const Strike there = run_scaled(f);
      expect_same(here, there, "contact/impulse/2", f * f * f);
      expect_same(here, there, "plastic/work", f * f * f);
      expect_same(here, there, "energy/parts/blade_kinetic", f * f * f);
      expect_same(here, there, "energy/parts/bird_kinetic", f * f * f);
      expect_same(here, there, "tip/final", f);
      expect_same(here, there, "contact/peak_force", f * f);
      expect_same(here, there, "retired/particles", 1.);
      expect_same(here, there, "steps/bird", 1.);
    }
}
