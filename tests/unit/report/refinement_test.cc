#include "report/study/convergence_table.h"
#include "report/study/refinement.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

using namespace birdstrike;

namespace
{
  using Texts = std::vector<std::string>;

  class Refining : public ::testing::Test
  {
  protected:
    ScratchFolder     scratch;
    const std::string prm = scratch.write("plate.prm", "subsection Bird\n  set Particle spacing = 0.002\nend\n");

    std::vector<LadderLevel> ladder(const std::string &refinement, const std::size_t n = 3, const double ratio = 2.,
                                    const std::size_t n_finer = 0, const Texts &overrides = {}) const
    {
      CaseParameters parameters; // 28 x 8 elements
      parameters.read(prm, overrides);
      ConvergeRequest request;
      request.refinement = refinement;
      request.n_levels   = n;
      request.ratio      = ratio;
      request.n_finer    = n_finer;
      return make_ladder(parameters, request);
    }

    /// Runs whose tip peaks (m) are 0.2 + c h^2.
    std::vector<PointRun> record(const std::vector<LadderLevel> &levels, const double c) const
    {
      std::vector<PointRun> runs;
      for (const StudyPoint &point : make_ladder_points(levels, {{}}))
        {
          RecordedRun run;
          run.peak = 0.2 + c * std::pow(levels[runs.size()].size, 2.);
          runs.push_back({point, scratch.path() / point.folder, "done", true, false, 0});
          run.write(runs.back().folder, prm);
        }
      return runs;
    }
  };
} // namespace

TEST_F(Refining, TheCaseIsTheFinestLevelUnlessSomeAreFiner)
{
  const auto levels = ladder("particles");
  EXPECT_EQ(levels[0].overrides, Texts{"Bird/Particle spacing=0.008"});
  EXPECT_EQ(levels[2].overrides, Texts{"Bird/Particle spacing=0.002"});
  EXPECT_EQ(levels[2].size, 0.002);
  EXPECT_EQ(ladder("particles", 3, 2., 1)[2].size, 0.001);
}

TEST_F(Refining, SizesOfMeshesAreThoseOfWholeElements)
{
  const auto levels = ladder("mesh", 3, 1.5);
  EXPECT_EQ(levels[2].overrides, (Texts{"Blade/Mesh/Elements along span=28", "Blade/Mesh/Elements along chord=8"}));
  EXPECT_EQ(levels[0].overrides, (Texts{"Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=4"}));
  EXPECT_DOUBLE_EQ(levels[0].size / levels[2].size, std::sqrt(28. * 8. / (12. * 4.)));
  EXPECT_EQ(levels[0].name(), "Elements along span=12, Elements along chord=4");
  EXPECT_EQ(ladder("both", 3, 2.)[1].overrides.size(), 3u);
}

TEST_F(Refining, BothAreRefinedOrNeither)
{
  const auto levels = ladder("both", 3, 2.);
  EXPECT_EQ(levels[0].size, 0.008);
  EXPECT_DOUBLE_EQ(levels[0].mesh_size, 4. * levels[2].mesh_size);
  EXPECT_EQ(describe_rounded_meshes(levels), "");
  const auto rounded = ladder("both", 3, 1.5, 0, {"Blade/Mesh/Elements along chord=2"});
  EXPECT_NE(describe_rounded_meshes(rounded).find(", "), std::string::npos) << "1.5 of two elements is none";
  EXPECT_EQ(describe_rounded_meshes(ladder("particles")), "");
  const Texts few{"Blade/Mesh/Elements along span=3", "Blade/Mesh/Elements along chord=1"};
  EXPECT_THROW(ladder("both", 3, 1.1, 0, few), InputError) << "birds of three sizes on one mesh";
}

// Half a plate is cut between elements: numbers along the chord are even, as the case's own must be.
TEST_F(Refining, HalvesKeepPairsAlongTheChord)
{
  const auto levels = ladder("mesh", 4, 1.5, 0, {"Case/Symmetry plane=y"});
  EXPECT_EQ(levels[3].overrides[1], "Blade/Mesh/Elements along chord=8");
  EXPECT_EQ(levels[2].overrides[1], "Blade/Mesh/Elements along chord=6");
  EXPECT_EQ(levels[1].overrides[1], "Blade/Mesh/Elements along chord=4");
  EXPECT_EQ(levels[0].overrides[1], "Blade/Mesh/Elements along chord=2");
}

TEST_F(Refining, TimeStepsOnlyShrinkAndPointsAreOddNumbers)
{
  const auto steps = ladder("step");
  EXPECT_EQ(steps[0].overrides, (Texts{"Time/Step scale=0.9", "Time/Bird step scale=1"}));
  EXPECT_EQ(steps[2].overrides, (Texts{"Time/Step scale=0.225", "Time/Bird step scale=0.25"}));
  const auto points = ladder("points", 3, 1.5);
  EXPECT_EQ(points[0].overrides, Texts{"Blade/Element/Points through thickness=3"});
  EXPECT_EQ(points[2].overrides, Texts{"Blade/Element/Points through thickness=7"});
  EXPECT_LT(points[2].size, points[0].size);
  EXPECT_EQ(ladder("points", 3, 1.5, 1)[2].overrides, Texts{"Blade/Element/Points through thickness=11"});
}

TEST_F(Refining, RefusesWhatIsNoLadder)
{
  EXPECT_THROW(ladder("mesh", 2), InputError);
  EXPECT_THROW(ladder("mesh", 9), InputError);
  EXPECT_THROW(ladder("mesh", 3, 1.), InputError);
  EXPECT_THROW(ladder("mesh", 3, NAN), InputError);
  EXPECT_THROW(ladder("mesh", 8, 2.), InputError) << "two of them are one element";
  EXPECT_THROW(ladder("points", 4, 1.5), InputError) << "one point";
  EXPECT_THROW(ladder("points", 3, 1.5, 3), InputError) << "23 points";
  EXPECT_THROW(ladder("particles", 3, 2., 0, {"Bird/Enabled=false"}), InputError);
  EXPECT_THROW(ladder("mesh", 3, 2., 0, {"Blade/Kind=none"}), InputError);
  EXPECT_THROW(ladder("mesh", 3, 2., 0, {"Blade/Kind=rigid"}), InputError) << "a plate of one facet";
  EXPECT_NO_THROW(ladder("mesh", 3, 2., 0, {"Blade/Kind=rigid", "Blade/Rigid/Surface=mesh"}));
}

TEST(Orders, AreOneOrTwoBounds)
{
  EXPECT_FALSE(read_orders("", "--order"));
  EXPECT_EQ(read_orders("1", "--order")->text(), "1");
  EXPECT_EQ(read_orders("0.5:2", "--order")->text(), "0.5:2");
  EXPECT_EQ(read_orders("2:2", "--order")->text(), "2");
  for (const char *wrong : {"0", "-1", "5", "nan", "one", "1:", ":2", "2:1", "1:2:3", "1,2", "1 "})
    try
      {
        read_orders(wrong, "--bird-order");
        ADD_FAILURE() << wrong;
      }
    catch (const InputError &error)
      {
        EXPECT_TRUE(std::string(error.what()).starts_with("--bird-order " + std::string(wrong) + "."));
      }
}

TEST_F(Refining, TheTableSaysWhatTheLevelsSay)
{
  const auto             levels = ladder("particles");
  const StudyPlan        plan   = make_ladder_plan(Refinement::particles, levels, 1);
  const auto             runs   = record(levels, 1000.);
  const StudyTable       table(plan, runs);
  const ConvergenceTable made(Refinement::particles, levels, 1, table, OrderRange{2., 2.});
  const auto             is_peak = [](const ConvergingRow &row) { return row.row->quantity == "peak (mid-chord)"; };
  const auto             peak    = std::ranges::find_if(made.rows(), is_peak);
  ASSERT_NE(peak, made.rows().end());
  EXPECT_NEAR(peak->estimate.order, 2., 1e-6) << "round-off over changes of a hundredth";
  EXPECT_NEAR(peak->estimate.extrapolated, 0.2, 1e-9);
  EXPECT_NEAR(peak->estimate.bar, 1.25 * 0.004, 1e-9);
  EXPECT_FALSE(peak->of_known_order) << "of three levels";
  EXPECT_NE(made.as_text().find("converges"), std::string::npos);
  const std::string csv   = made.as_csv();
  const std::size_t place = csv.find("\nTip: peak (mid-chord),m,");
  ASSERT_NE(place, std::string::npos) << csv;
  // All digits are written: of 0.264, 0.216 and 0.204 the last hangs on whether operations are fused.
  std::array<double, 3> values{};
  ASSERT_EQ(
    std::sscanf(csv.c_str() + place, "\nTip: peak (mid-chord),m,%lf,%lf,%lf,", &values[0], &values[1], &values[2]), 3);
  for (std::size_t level = 0; level < 3; ++level)
    EXPECT_NEAR(values[level], 0.2 + 1000. * std::pow(levels[level].size, 2.), 1e-15);
  const Figure       figure = made.make_figure();
  const FigurePanel &panel  = figure.panels[0];
  ASSERT_EQ(panel.lines.size(), 3u);
  EXPECT_NEAR(panel.lines[1].bar[0], 0.005, 1e-9);
  EXPECT_NEAR(panel.lines[2].y[0], 0.2, 1e-9) << "at h = 0";
}

TEST_F(Refining, TheTableSaysWhatAKnownOrderGives)
{
  const auto       levels = ladder("particles", 6, 1.5);
  const StudyPlan  plan   = make_ladder_plan(Refinement::particles, levels, 1);
  const auto       runs   = record(levels, 100.);
  const StudyTable table(plan, runs);
  const auto       peak_of = [&](const ConvergenceTable &made) {
    return *std::ranges::find_if(made.rows(),
                                       [](const ConvergingRow &row) { return row.row->quantity == "peak (mid-chord)"; });
  };
  const ConvergenceTable right(Refinement::particles, levels, 1, table, OrderRange{2., 2.}),
    wrong(Refinement::particles, levels, 1, table, OrderRange{1., 1.});
  ASSERT_TRUE(peak_of(right).of_known_order);
  EXPECT_NEAR(peak_of(right).of_known_order->limit, 0.2, 1e-9);
  EXPECT_FALSE(peak_of(right).of_known_order->rejects_order());
  EXPECT_NEAR(right.make_figure().panels[0].lines[3].y[0], 0.2, 1e-9) << "at h = 0";
  EXPECT_TRUE(peak_of(wrong).of_known_order->rejects_order());
  EXPECT_NE(wrong.as_text().find("; order 1 is rejected, p = "), std::string::npos) << wrong.as_text();
  EXPECT_EQ(right.as_text().find("; order 2 is rejected"), std::string::npos);
  EXPECT_NE(wrong.as_csv().find(",known order [-],extrapolated by known order,"), std::string::npos);
}
