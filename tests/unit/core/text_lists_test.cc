#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>

#include <gtest/gtest.h>

namespace birdstrike
{
  namespace
  {
    TEST(TextLists, ReadIdsNumbersAndPairs)
    {
      EXPECT_EQ(parse_ids(" 0, 12 7 ", "E"), (std::vector<unsigned int>{0, 12, 7}));
      EXPECT_TRUE(parse_ids("", "E").empty());
      EXPECT_EQ(parse_numbers("1e-3, -2 .5", 3, "E"), (std::vector<double>{1e-3, -2., 0.5}));
      const auto pairs = parse_pairs("tip: 1 2 3; root : 0 0 0;", "E");
      ASSERT_EQ(pairs.size(), 2u);
      EXPECT_EQ(pairs[1], (std::pair<std::string, std::string>("root", "0 0 0")));
      EXPECT_EQ(parse_components("uy, rz", "E"), (std::array<bool, 6>{{false, true, false, false, false, true}}));
      EXPECT_EQ(parse_components("hinged", "E"), (std::array<bool, 6>{{true, true, true, false, false, false}}));
    }

    TEST(TextLists, RefuseWhatTheyCannotRead)
    {
      EXPECT_THROW(parse_ids("-1", "E"), InputError);
      EXPECT_THROW(parse_ids("1.5", "E"), InputError);
      EXPECT_THROW(parse_numbers("1 2", 3, "E"), InputError);
      EXPECT_THROW(parse_numbers("1 2 3x", 3, "E"), InputError);
      EXPECT_THROW(parse_numbers("1 2 nan", 3, "E"), InputError);
      EXPECT_THROW(parse_pairs("a 1 2 3", "E"), InputError);
      EXPECT_THROW(parse_components("u", "E"), InputError);
    }

    TEST(Expression, EvaluatesInSpaceAndTime)
    {
      const double     x[3] = {1., 2., 3.};
      const Expression one("2*x + y*t - pi", 1, "E"), three("x; y; if(z > 2, t, 0)", 3, "E");
      EXPECT_NEAR(one.value(x, 5.), 2. + 10. - 3.14159265358979, 1e-14);
      EXPECT_EQ(three.value(x, 7., 2), 7.);
      EXPECT_THROW(Expression("1/x", 1, "E").value(std::array<double, 3>{}.data(), 0.), InputError);
    }

    TEST(Expression, IsPresentUnlessZero)
    {
      EXPECT_FALSE(is_present(""));
      EXPECT_FALSE(is_present(" 0; 0; 0.0"));
      EXPECT_TRUE(is_present("0; 0; 10"));
      EXPECT_TRUE(is_present("x"));
    }
  } // namespace
} // namespace birdstrike
