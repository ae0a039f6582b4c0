#include "report/target_error/asked_quantity.h"
#include "report/target_error/climb.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;

namespace
{
  /// f = 1 + c h^p on sizes that shrink by 1.5.
  ClimbAxis axis_of_power(const double p, const double c, const std::size_t n)
  {
    ClimbAxis axis{"bird", {}, {}};
    for (std::size_t k = 0; k < n; ++k)
      {
        axis.sizes.push_back(std::pow(1.5, -static_cast<double>(k)));
        axis.values.push_back(1. + c * std::pow(axis.sizes.back(), p));
      }
    return axis;
  }

  const ClimbAxis not_refined{"mesh", {0.}, {1.}};
} // namespace

TEST(Climb, ReadsTargets)
{
  const ErrorTarget target = read_error_target("tip peak = 2 %");
  EXPECT_EQ(find_quantity(target.quantity).name(), "Tip: peak (mid-chord)");
  EXPECT_DOUBLE_EQ(target.share, 0.02);
  EXPECT_DOUBLE_EQ(read_error_target("impulse=0.5%").share, 0.005);
  for (const char *text : {"tip peak", "tip peak = 2", "= 2 %", "tip peak = two %", "tip peak = 0 %", "tip peak = -1 %",
                           "tip peak = 60 %", "tip peak = 2 % or so", "tip peak = 2 mm"})
    EXPECT_THROW(read_error_target(text), InputError) << text;
}

TEST(Climb, KnowsBeforeAnyRunWhichQuantityIsMeant)
{
  for (const auto &[words, name] :
       std::vector<std::pair<std::string, std::string>>{{"tip peak", "Tip: peak (mid-chord)"},
                                                        {"Tip: peak (mid-chord)", "Tip: peak (mid-chord)"},
                                                        {"peak tip deflection", "Tip: peak (mid-chord)"},
                                                        {"tip deflection at the end", "Tip: deflection at the end"},
                                                        {"permanent deflection", "Tip: permanent deflection"},
                                                        {"tip time", "Tip: time of the peak"},
                                                        {"Root peak moment", "Root: peak bending moment"},
                                                        {"root stress", "Root: peak normal stress"},
                                                        {"contact peak force", "Contact: peak force"},
                                                        {"filtered peak force", "Contact: peak force, filtered"},
                                                        {"plastic work", "Plasticity: plastic work"},
                                                        {"impulse", "Contact: impulse (norm)"}})
    EXPECT_EQ(find_quantity(words).name(), name) << words;
  for (const char *words : {"tip of the iceberg", "impulze", "elements", "wall", "energy balance"})
    EXPECT_THROW(find_quantity(words), InputError) << words;
}

// Whichever of them a run has: permanent deflections are there of long runs only.
TEST(Climb, RefusesWordsOfSeveralMeaningsWithAllOfThem)
{
  for (const auto &[words, names] : std::vector<std::pair<std::string, std::vector<std::string>>>{
         {"tip deflection", {"Tip peak (mid-chord)", "Tip deflection at the end", "Tip permanent deflection"}},
         {"peak force", {"Root peak force", "Contact peak force", "Contact peak force, filtered"}},
         {"contact force", {"Contact peak force", "Contact peak force, filtered"}},
         {"plasticity", {"Plasticity peak plastic strain", "Plasticity plastic work"}},
         {"root peak", {"Root peak force", "Root peak bending moment", "Root peak normal stress"}}})
    try
      {
        find_quantity(words);
        ADD_FAILURE() << words;
      }
    catch (const InputError &error)
      {
        std::string list;
        for (const std::string &name : names)
          list += (list.empty() ? "" : "; ") + name;
        EXPECT_NE(std::string(error.what()).find("'" + words + "' is ambiguous.\n  It may be: " + list + "."),
                  std::string::npos)
          << error.what();
      }
}

TEST(Climb, ARunMayLackTheQuantity)
{
  const std::vector<ComparisonRow> rows{{"Case", "elements", "count", {1.}, {}},
                                        {"Tip", "peak (mid-chord)", "m", {0.3}, {}}};
  EXPECT_EQ(&find_row(rows, find_quantity("tip peak")), &rows[1]);
  EXPECT_THROW(find_row(rows, find_quantity("impulse")), InputError);
}

TEST(Climb, AMeshThatIsThereAndNotRefinedHasAnUnknownError)
{
  ClimbAxis mesh{"mesh", {0.}, {1.}};
  EXPECT_TRUE(mesh.is_unknown());
  mesh.is_there = false;
  EXPECT_FALSE(mesh.is_unknown()) << "a rigid plate has no mesh, and no error of one";
  EXPECT_FALSE(axis_of_power(1., 0.1, 4).is_unknown());
}

TEST(Climb, ErrorsOfALadderThatConvergesHoldTheTruth)
{
  for (const double p : {1., 2.})
    {
      const ClimbAxis           axis   = axis_of_power(p, 0.1, 4);
      const std::vector<double> errors = axis.errors();
      EXPECT_TRUE(axis.is_trusted(1e-9));
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_GE(errors[k], std::abs(axis.values[k] - 1.)) << "the limit is within the bar";
      EXPECT_NEAR(errors[3], 1.25 * (axis.values[3] - 1.), 1e-9);
      EXPECT_NEAR(axis.expected_gain(), errors[3] * (1. - std::pow(1.5, -p)), 1e-7) << "round-off of the order";
    }
}

TEST(Climb, BarsHoldTheScatterOfTheFinestLevel)
{
  ClimbAxis    three = axis_of_power(2., 0.1, 3);
  const double quiet = three.bar();
  three.noise        = 0.5 * quiet;
  EXPECT_DOUBLE_EQ(three.bar(), 1.5 * quiet) << "three levels do not know it";
  EXPECT_DOUBLE_EQ(three.errors().back(), 1.5 * quiet);
  EXPECT_FALSE(three.is_bar_noise());

  ClimbAxis    five      = axis_of_power(2., 0.1, 5);
  const double of_levels = five.bar();
  five.noise             = 0.5 * of_levels;
  EXPECT_DOUBLE_EQ(five.bar(), of_levels) << "a fit does";
  five.noise = 4. * of_levels;
  EXPECT_DOUBLE_EQ(five.bar(), five.noise);
  EXPECT_TRUE(five.is_bar_noise());

  ClimbAxis by_order    = axis_of_power(1., 0.1, 5);
  by_order.known_orders = OrderRange{1., 1.};
  EXPECT_FALSE(by_order.is_bar_noise());
  by_order.noise = 0.01;
  EXPECT_DOUBLE_EQ(by_order.bar(), 0.01) << "a straight line leaves no interval";
}

TEST(Climb, TrustsSwingsOnlyWhereTheyAreSmall)
{
  const ClimbAxis swings{"bird", {3., 2., 1.}, {1.001, 0.999, 1.}};
  EXPECT_NEAR(swings.errors()[2], 0.003, 1e-12) << "three times the largest change";
  EXPECT_TRUE(swings.is_trusted(0.0061));
  EXPECT_FALSE(swings.is_trusted(0.0059));
  const ClimbAxis grows{"bird", {3., 2., 1.}, {1., 1.001, 1.004}};
  EXPECT_NEAR(grows.bar(), 0.012, 1e-12);
  EXPECT_FALSE(grows.is_trusted(0.02));
}

// Energy that a plate absorbs, bird of 10, 7.1, 5 mm (J): the order of 3.1 is none that particles have, and five levels
// end at 504.7.
TEST(Climb, ThreeLevelsOfNoOrderCountByAllThatTheyAreApart)
{
  const ClimbAxis lucky{"bird", {10., 7.07107, 5.}, {546.3, 534.6, 530.7}};
  EXPECT_EQ(lucky.estimate().trend, Trend::not_asymptotic);
  EXPECT_NEAR(lucky.bar(), 3. * (546.3 - 530.7), 1e-9);
  EXPECT_FALSE(lucky.is_trusted(0.09 * 530.7));
  EXPECT_LT(lucky.values.back() - lucky.bar(), 504.7);
}

TEST(Climb, ThreeLevelsOfAHigherOrderThanTheMethodsAreNotTrusted)
{
  const ClimbAxis quick = axis_of_power(2.14, 0.1, 3), quadratic = axis_of_power(2., 0.1, 3);
  EXPECT_EQ(quick.estimate().trend, Trend::asymptotic);
  EXPECT_FALSE(quick.is_trusted(quick.bar()));
  EXPECT_NEAR(quick.bar(), 3. * (quick.values[0] - quick.values[2]), 1e-12);
  EXPECT_TRUE(quadratic.is_trusted(1e-9));
  EXPECT_TRUE(axis_of_power(2.05, 0.1, 5).is_trusted(1e-9)) << "a fit of five, as converge has it";
}

TEST(Climb, WhatBothAddIsTakenAsFarAsTheLadderGoes)
{
  const ClimbAxis axis{"bird", {4., 3., 2., 1.}, {10., 9., 8.5, 8.}};
  EXPECT_DOUBLE_EQ(axis.share_beyond(1), 2.);
  EXPECT_DOUBLE_EQ(axis.share_beyond(2), 2. / 1.5);
  EXPECT_EQ(axis.share_beyond(3), 1.);
  const ClimbAxis back{"mesh", {3., 2., 1.}, {1., 1.1, 1.}};
  EXPECT_EQ(back.share_beyond(1), 1.) << "it goes, and comes back";
  EXPECT_EQ(back.share_beyond(2), 1.);
  const ClimbAxis late{"mesh", {3., 2., 1.}, {10., 10., 9.}};
  EXPECT_TRUE(std::isinf(late.share_beyond(1))) << "nothing has come of it yet";
  EXPECT_EQ(late.share_beyond(2), 1.);

  EXPECT_FALSE(extrapolate_interaction(axis, back, {}));
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(axis, back, {{{1, 1}, 0.1}}), 0.2);
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(axis, back, {{{1, 1}, 0.1}, {{3, 1}, 0.15}}), 0.15) << "the nearer one";
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(axis, back, {{{1, 1}, 0.1}, {{3, 1}, 0.}}), 0.1) << "what was seen, was";
  const ClimbAxis swings{"bird", {5., 4., 3., 2., 1.}, {9., 9.4, 9.2, 9.3, 9.25}};
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(swings, back, {{{1, 2}, 0.01}, {{4, 2}, 0.3}}), 0.3) << "alike: the larger";
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(axis, late, {{{2, 1}, 0.01}, {{3, 2}, 0.5}}), 0.5);
  EXPECT_DOUBLE_EQ(*extrapolate_interaction(axis, late, {{{2, 1}, 0.01}}), 0.01) << "all that is known";
}

TEST(Climb, TrustsAFitOfFiveLevelsWithinItsScatter)
{
  // Impulse of an oblique strike (N s): the bar is that of the fit (grid_convergence_test.cc).
  const ClimbAxis cut{"bird", {5., 3.5, 2.5, 1.75, 1.25}, {11.01, 10.19, 9.44, 9.10, 8.89}};
  EXPECT_TRUE(cut.is_trusted(0.01 * 8.89));
  EXPECT_NEAR(cut.bar() / 8.89, 0.0719, 1e-4);
  const ClimbAxis before{"bird", {5., 3.5, 2.5, 1.75}, {11.01, 10.19, 9.44, 9.10}};
  EXPECT_FALSE(before.is_trusted(0.05 * 9.1)) << "one degree of freedom, and threes of other orders";
  // The same strike's by mesh: to and fro.
  const ClimbAxis mesh{"mesh", {9.958, 6.955, 4.979, 3.546, 2.489}, {11.011, 11.010, 11.064, 11.008, 11.048}};
  EXPECT_TRUE(mesh.is_trusted(0.01)) << "whose bar is";
  EXPECT_GT(mesh.bar(), 0.056) << "all that they are apart";
}

TEST(Climb, TakesALadderOfAKnownOrderToItsLimit)
{
  // The strike above, whose order a fit finds to be 1.29: the line over h ends at 8.10 (scipy.stats.linregress:
  // intercept 8.098235, standard error 0.085243; Student's 97.5 % quantile of three degrees 3.182446).
  ClimbAxis cut{"bird", {5., 3.5, 2.5, 1.75, 1.25}, {11.01, 10.19, 9.44, 9.10, 8.89}, OrderRange{1., 1.}};
  ASSERT_TRUE(cut.limit());
  EXPECT_NEAR(cut.limit()->limit, 8.098235, 1e-6);
  EXPECT_NEAR(cut.bar(), 3.182446 * 0.085243, 2e-6);
  EXPECT_TRUE(cut.is_trusted(1e-9));
  EXPECT_NEAR(cut.values[4] + cut.correction(4), cut.limit()->limit, 1e-12);
  EXPECT_EQ(cut.errors()[4], cut.bar());
  for (std::size_t k = 0; k < 4; ++k)
    {
      EXPECT_EQ(cut.correction(k), 0.) << "the finest alone is corrected";
      EXPECT_NEAR(cut.errors()[k], cut.values[k] - cut.limit()->limit + cut.bar(), 1e-12);
      if (k > 0)
        {
          EXPECT_NEAR(cut.share_beyond(k), (11.01 - 8.098235) / (11.01 - cut.values[k]), 1e-6);
        }
    }
  EXPECT_NEAR(cut.share_beyond(4), (11.01 - 8.098235) / (11.01 - 8.89), 1e-6)
    << "of the way to the limit, to the finest";
  cut.sizes.resize(3);
  cut.values.resize(3);
  EXPECT_FALSE(cut.limit()) << "of three";
  EXPECT_FALSE(cut.is_trusted(1.)) << "so a fourth is run, whatever their own estimate says";
  EXPECT_EQ(cut.correction(2), 0.);
  EXPECT_EQ(axis_of_power(1., 0.1, 5).correction(4), 0.) << "no order is known";
  ClimbAxis parts    = axis_of_power(-1., 0.05, 5);
  parts.known_orders = OrderRange{1., 1.};
  EXPECT_FALSE(parts.is_trusted(1.)) << "a line can be laid through values that have no limit";
}

TEST(Climb, TrustsNoOrderThatItsLevelsContradict)
{
  ClimbAxis second    = axis_of_power(2., 0.1, 5);
  second.known_orders = OrderRange{2., 2.};
  EXPECT_TRUE(second.is_trusted(1e-9));
  second.known_orders = OrderRange{1., 1.};
  EXPECT_FALSE(second.is_trusted(1.)) << "exactly of the second order";
  // A line that ends below zero: 0.9, 0.5 less a unit.
  ClimbAxis beyond{"bird", {5., 4., 3., 2., 1.}, {0.9, 0.7001, 0.5, 0.2999, 0.1}, OrderRange{1., 1.}};
  EXPECT_LT(beyond.limit()->limit, 0.);
  EXPECT_FALSE(beyond.is_trusted(1.)) << "of another sign than the finest";
}

TEST(Climb, ChoosesTheCoarsestMeshForEachBirdAndNeverBothAtTheirCoarsest)
{
  const ClimbAxis bird = axis_of_power(2., 0.1, 4), mesh = axis_of_power(1., 0.1, 4);
  for (const ClimbChoice &choice : find_choices(bird, mesh, 0.15))
    {
      EXPECT_GE(choice.bird, 1u);
      EXPECT_GE(choice.mesh, 1u);
      EXPECT_LE(bird.errors()[choice.bird] + mesh.errors()[choice.mesh], 0.15);
      if (choice.mesh > 1)
        {
          EXPECT_GT(bird.errors()[choice.bird] + mesh.errors()[choice.mesh - 1], 0.15) << "one coarser would not do";
        }
    }
  EXPECT_FALSE(find_choices(bird, mesh, 0.15).empty());
  EXPECT_TRUE(find_choices(bird, mesh, 0.01).empty());
  EXPECT_TRUE(find_choices(bird, mesh, -1.).empty());
  EXPECT_EQ(find_choices(bird, not_refined, 0.2)[0].mesh, 0u);
}

// A zero that nobody has measured is none.
TEST(Climb, SaysWhatNoRunHasMeasured)
{
  EXPECT_NE(describe_interaction(std::nullopt, "N s").find("were not run: the value is the sum of both ladders"),
            std::string::npos);
  EXPECT_EQ(describe_interaction(0., "N s"), "  What both together add to it: 0 N s.\n");
  const ClimbAxis bird = axis_of_power(2., 0.1, 4), mesh = axis_of_power(1., 0.1, 4);
  EXPECT_EQ(name_refinements(bird, not_refined), "a smaller Bird/Particle spacing");
  EXPECT_EQ(name_refinements(bird, mesh),
            "a smaller Bird/Particle spacing and more Blade/Mesh/Elements along span and chord");
}
