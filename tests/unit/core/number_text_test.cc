#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text/number_text.h>

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace birdstrike;

TEST(NumberText, KeepsSixDigitsOfAnySize)
{
  EXPECT_EQ(number_text(1e-7), "1e-07");
  EXPECT_EQ(number_text(0.00427), "0.00427");
  EXPECT_EQ(number_text(123456.), "123456");
  EXPECT_EQ(number_text(-4.43e-9), "-4.43e-09");
  const std::array<double, 3> place{{0.1, -1e-9, 2.}};
  EXPECT_EQ(point_text(place.data()), "(0.1, -1e-09, 2)");
}

TEST(NumberText, IsUsedOfAFormulaThatHasNoValue)
{
  const Expression            law("1/(t-1e-7)", 1, "Loads/Pressure");
  const std::array<double, 3> place{{1e-8, 0., 0.}};
  try
    {
      law.value(place.data(), 1e-7);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("(1e-08, 0, 0), t = 1e-07 s"), std::string::npos) << error.what();
    }
}
