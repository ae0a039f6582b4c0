#include <birdstrike/core/errors.h>
#include <birdstrike/io/varied_entry.h>

#include <gtest/gtest.h>

#include <cmath>

using birdstrike::InputError;
using birdstrike::read_varied_entry;
using birdstrike::VariedEntry;

namespace
{
  std::string refusal_of_range(const std::string &text)
  {
    try
      {
        read_varied_entry(text);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  using Texts   = std::vector<std::string>;
  using Numbers = std::vector<double>;
} // namespace

TEST(VariedEntry, ReadsAListWithUnitsAndFormulas)
{
  const VariedEntry spacing = read_varied_entry("Bird/Particle spacing = 0.004, 0.005/2, 0.002");
  EXPECT_EQ(spacing.entry, "Bird/Particle spacing");
  EXPECT_EQ(spacing.unit, "m");
  EXPECT_EQ(spacing.values, (Texts{"0.004", "0.0025", "0.002"}));
  EXPECT_EQ(spacing.numbers, (Numbers{0.004, 0.0025, 0.002}));
}

TEST(VariedEntry, ReadsARangeWithBothEnds)
{
  EXPECT_EQ(read_varied_entry("Bird/Particle spacing=2 mm:5 mm:4").values, (Texts{"0.002", "0.003", "0.004", "0.005"}));
  EXPECT_EQ(read_varied_entry("Bird/Speed=300:100:3").numbers, (Numbers{300., 200., 100.}));
  // decimal steps stay decimal: 0.1 * 3 is not 0.3 in binary, the text of twelve digits is
  EXPECT_EQ(read_varied_entry("Bird/Density=100.1:100.4:4").values, (Texts{"100.1", "100.2", "100.3", "100.4"}));
}

TEST(VariedEntry, ReadsTextsAndVectors)
{
  const VariedEntry shape = read_varied_entry("Bird/Shape=cylinder, hemispherical cylinder");
  EXPECT_EQ(shape.values, (Texts{"cylinder", "hemispherical cylinder"}));
  EXPECT_TRUE(shape.numbers.empty());
  EXPECT_EQ(read_varied_entry("Bird/Velocity=0, 0, 150 | 0, 0, 180.5").values, (Texts{"0, 0, 150", "0, 0, 180.5"}));
  EXPECT_EQ(read_varied_entry("Bird/Velocity=0, 0, 150").values.size(), 1u) << "commas part the numbers of a vector";
  EXPECT_EQ(read_varied_entry("Blade/Material/Young's modulus=default, 73e9").values, (Texts{"table", "73e9"}));
  EXPECT_EQ(read_varied_entry("Blade/Thickness/By material=1: 0.004; 2: 0.003 | 1: 0.003").values.size(), 2u);
}

TEST(VariedEntry, TheUnitAfterTheLastHoldsForAll)
{
  EXPECT_EQ(read_varied_entry("Bird/Mass=50, 80, 100 g").values, (Texts{"0.05", "0.08", "0.1"}));
  EXPECT_EQ(read_varied_entry("Bird/Particle spacing=4, 5/2, 2 mm").values, (Texts{"0.004", "0.0025", "0.002"}));
  EXPECT_EQ(read_varied_entry("Bird/Particle spacing=4 mm, 0.25 cm, 2 mm").values, (Texts{"0.004", "0.0025", "0.002"}));
  EXPECT_EQ(read_varied_entry("Blade/Thickness/Value=4, 3 mm").values, (Texts{"0.004", "0.003"})) << "a formula's";
  EXPECT_EQ(read_varied_entry("Bird/Aim span fraction=20, 50 %").values, (Texts{"0.2", "0.5"})) << "at most one number";
  // 540 km/h / 3.6 = 150 m/s; 720 / 3.6 = 200
  EXPECT_EQ(read_varied_entry("Bird/Velocity=0, 0, 540 | 0, 0, 720 km/h").values, (Texts{"0, 0, 150", "0, 0, 200"}));
  EXPECT_EQ(read_varied_entry("Blade/Material/Young's modulus=table, 200 GPa").values, (Texts{"table", "2e+11"}));
}

TEST(VariedEntry, AUnitAtEitherEndOfARangeHoldsForBoth)
{
  const Texts expected{"0.002", "0.003", "0.004", "0.005"};
  EXPECT_EQ(read_varied_entry("Bird/Particle spacing=2:5 mm:4").values, expected);
  EXPECT_EQ(read_varied_entry("Bird/Particle spacing=2 mm:5:4").values, expected);
  // 2 pi / 60 rad/s a turn a minute, to the twelve digits that a range is written with
  const Numbers speeds = read_varied_entry("Blade/Spin/Speed=1000:5000 rpm:3").numbers;
  ASSERT_EQ(speeds.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(speeds[k], (1000. + 2000. * static_cast<double>(k)) * M_PI / 30., 1e-9);
}

TEST(VariedEntry, RefusesUnitsOfSomeNumbersOnly)
{
  for (const char *text : {"Bird/Particle spacing=4 mm, 2.5 mm, 0.002", "Bird/Mass=50 g, 80, 100 g",
                           "Bird/Mass=50 g, 80", "Bird/Velocity=0, 0, 540 km/h | 0, 0, 150"})
    EXPECT_NE(refusal_of_range(text).find("has no unit, others have one"), std::string::npos)
      << text << ": " << refusal_of_range(text);
  EXPECT_EQ(read_varied_entry("Bird/Chordwise offset=5 mm, 0, -5 mm").values, (Texts{"0.005", "0", "-0.005"}));
}

TEST(VariedEntry, RefusesInWords)
{
  for (const auto &[text, word] :
       std::vector<std::pair<std::string, std::string>>{{"Bird/Mas=1", "'Mass'"},
                                                        {"Brd/Mass=1", "'Bird'"},
                                                        {"Bird/Mass", "no values"},
                                                        {"Bird/Mass=", "no values"},
                                                        {"Bird/Mass=1,,2", "empty value"},
                                                        {"Bird/Mass=-1,1", "above 0"},
                                                        {"Bird/Mass=1 m", "unit"},
                                                        {"Bird/Mass=1, 1.0", "occurs twice"},
                                                        {"Bird/Mass=1:2", "cannot be"},
                                                        {"Bird/Mass=1:2:x", "whole number"},
                                                        {"Bird/Mass=1:2:1.5", "whole number"},
                                                        {"Bird/Mass=1:2:1e9", "at most 10000"},
                                                        {"Bird/Mass=1:1:3", "occurs twice"},
                                                        {"Bird/Shape=a:b:2", "cannot be"}})
    EXPECT_NE(refusal_of_range(text).find(word), std::string::npos) << text << ": " << refusal_of_range(text);
}

TEST(VariedEntry, MayRepeatInPairs)
{
  EXPECT_EQ(read_varied_entry("Bird/Mass=1, 2, 1", true).numbers, (Numbers{1., 2., 1.}));
}
