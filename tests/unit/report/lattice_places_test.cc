#include "report/study/convergence_table.h"
#include "report/study/lattice_places.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

using namespace birdstrike;

namespace
{
  using Texts = std::vector<std::string>;

  std::vector<Texts> places(const std::size_t n, const Texts &overrides = {})
  {
    const ScratchFolder scratch;
    CaseParameters      parameters;
    parameters.read(scratch.write("plate.prm", ""), overrides);
    return make_lattice_places(parameters, n);
  }

  std::string refusal(const std::size_t n, const Texts &overrides)
  {
    try
      {
        places(n, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

// By hand: of 1, 2, 3, 4 the standard deviation is sqrt(5/3), Student's t of three degrees of freedom 3.182446.
TEST(LatticePlaces, AMeanIsKnownByStudentsT)
{
  EXPECT_NEAR(interval_of_mean({1., 2., 3., 4.}), 3.182446 * std::sqrt(5. / 3.) / 2., 1e-6);
  EXPECT_NEAR(interval_of_mean({1., 2.}), 12.706205 * 0.5, 1e-6);
  EXPECT_EQ(interval_of_mean({7.}), 0.);
  EXPECT_EQ(interval_of_mean({7., 7., 7.}), 0.);
}

TEST(LatticePlaces, BeginWithTheCaseAndGoOnWhenThereAreMore)
{
  const auto four = places(4), eight = places(8);
  EXPECT_EQ(four[0], Texts());
  EXPECT_EQ(four[1], Texts{"Bird/Lattice shift=-0.2451, -0.4302"});
  EXPECT_TRUE(std::equal(four.begin(), four.end(), eight.begin()));
  EXPECT_EQ(std::set<Texts>(eight.begin(), eight.end()).size(), 8u);
  EXPECT_EQ(places(2, {"Bird/Lattice shift=0.25, 0.5"})[1], Texts{"Bird/Lattice shift=0.0049, 0.0698"});
}

TEST(LatticePlaces, SeveralBirdsDoNotShareOne)
{
  const auto two = places(3, {"Bird 2/Enabled=true", "Bird 2/Aim point=0.1, 0, 0"});
  ASSERT_EQ(two[1].size(), 2u);
  EXPECT_EQ(two[1][0], "Bird/Lattice shift=-0.2451, -0.4302");
  EXPECT_TRUE(two[1][1].starts_with("Bird 2/Lattice shift="));
  EXPECT_NE(two[1][0].substr(4), two[1][1].substr(6));
  EXPECT_NE(two[1][1].substr(6), two[2][0].substr(4));
}

TEST(LatticePlaces, RefuseWhatHasNone)
{
  EXPECT_THROW(places(0), InputError);
  EXPECT_THROW(places(65), InputError);
  EXPECT_NE(refusal(2, {"Bird/Enabled=false"}).find("no bird"), std::string::npos);
  EXPECT_NE(refusal(2, {"Case/Symmetry plane=y"}).find("half a bird"), std::string::npos);
  EXPECT_NE(refusal(2, {"Bird/Shape=slab", "Bird/Slab lengths=0.02, 0.02, 0.02"}).find("slab"), std::string::npos);
  EXPECT_EQ(refusal(1, {"Case/Symmetry plane=y"}), "");
}

TEST(LatticePlaces, MeansHaveTheVarianceOfARun)
{
  const auto means = mean_over_places({1., 3., 5., 10., 10., 10.}, 3);
  ASSERT_EQ(means.size(), 2u);
  EXPECT_EQ(means[0].mean, 3.);
  EXPECT_EQ(means[0].variance, 4.);
  EXPECT_EQ(means[1].variance, 0.);
  EXPECT_TRUE(std::isnan(mean_over_places({1., 2.}, 1)[0].variance));
  EXPECT_TRUE(std::isnan(mean_over_places({1., NAN}, 2)[0].mean));
}

// Tip peaks 0.2 + c h^2, half of the runs 1 mm above and half 1 mm below: the ladder is that of the means.
TEST(LatticePlaces, ALadderOfMeansConverges)
{
  const ScratchFolder scratch;
  const std::string   prm = scratch.write("plate.prm", "subsection Bird\n  set Particle spacing = 0.002\nend\n");
  CaseParameters      parameters;
  parameters.read(prm, {});
  ConvergeRequest request;
  request.refinement               = "particles";
  request.n_levels                 = 4;
  const auto            levels     = make_ladder(parameters, request);
  const auto            of_lattice = make_lattice_places(parameters, 2);
  const StudyPlan       plan       = make_ladder_plan(Refinement::particles, levels, 2);
  std::vector<PointRun> runs;
  for (const StudyPoint &point : make_ladder_points(levels, of_lattice))
    {
      RecordedRun run;
      run.peak = 0.2 + 1000. * std::pow(levels[point.at[0]].size, 2.) + (point.at[1] == 0 ? 1e-3 : -1e-3);
      runs.push_back({point, scratch.path() / point.folder, "done", true, false, 0});
      run.write(runs.back().folder, prm);
    }
  ASSERT_EQ(runs.size(), 8u);
  EXPECT_EQ(plan.shape(), (std::vector<std::size_t>{4, 2}));
  const StudyTable       table(plan, runs);
  const ConvergenceTable made(Refinement::particles, levels, 2, table, std::nullopt);
  const auto             peak =
    std::ranges::find_if(made.rows(), [](const ConvergingRow &row) { return row.row->quantity == "peak (mid-chord)"; });
  ASSERT_NE(peak, made.rows().end());
  EXPECT_NEAR(peak->estimate.order, 2., 1e-6);
  EXPECT_NEAR(peak->values[0], 0.204, 1e-12);
  EXPECT_NEAR(peak->scatter, std::sqrt(2.) * 1e-3, 1e-12);
  EXPECT_NE(made.as_text().find("one run"), std::string::npos);
  EXPECT_NE(made.as_text().find("+- 0.69"), std::string::npos) << made.as_text();
  EXPECT_NE(made.as_csv().find(",places,standard deviation of a run,"), std::string::npos);
}
