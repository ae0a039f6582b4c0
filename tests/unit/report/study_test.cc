#include "report/study/study_figures.h"
#include "report/study/study_points.h"
#include "report/study/study_table.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../io/scratch_folder.h"
#include "recorded_run.h"
#include "report/histories/history_hdf5.h"

using namespace birdstrike;

namespace
{
  const std::vector<std::string> two_entries{"Bird/Mass=0.1, 0.2", "Bird/Shape=cylinder, sphere, ellipsoid"};

  /// Two masses, three shapes; the second point was lost.
  class Study : public ::testing::Test
  {
  protected:
    ScratchFolder         scratch;
    const StudyPlan       plan = read_study_plan(two_entries, false);
    std::vector<PointRun> runs;

    Study()
    {
      const std::string prm = scratch.write("plate.prm", "subsection Bird\n  set Mass = 0.1\nend\n");
      for (const StudyPoint &point : make_points(plan))
        {
          RecordedRun run;
          run.peak = 0.1 + 0.01 * static_cast<double>(runs.size());
          runs.push_back({point, scratch.path() / point.folder, "done", true, false, 0});
          run.write(runs.back().folder, prm);
        }
      runs[1].is_done = false;
      runs[1].state   = "lost: energy grew, in one step";
    }
  };

  std::string refusal(const std::vector<std::string> &vary, const bool are_pairs = false)
  {
    try
      {
        make_points(read_study_plan(vary, are_pairs));
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(StudyPoints, EachWithEachTheLastEntryFastest)
{
  const auto points = make_points(read_study_plan(two_entries, false));
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[1].name, "Mass=0.1, Shape=sphere");
  EXPECT_EQ(points[1].folder, "Mass=0.1-Shape=sphere");
  EXPECT_EQ(points[3].at, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(points[5].overrides, (std::vector<std::string>{"Bird/Mass=0.2", "Bird/Shape=ellipsoid"}));
}

TEST(StudyPoints, PairsGoTogether)
{
  const auto points = make_points(read_study_plan({"Bird/Mass=1, 1, 2", "Bird/Density=900, 950, 900"}, true));
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[2].name, "Mass=2, Density=900");
}

TEST(StudyPoints, RefusesWhatIsNoStudy)
{
  EXPECT_NE(refusal({}).find("Nothing is varied"), std::string::npos);
  EXPECT_NE(refusal({"Bird/Mass=1", "Bird/Mass=2"}).find("varied twice"), std::string::npos);
  EXPECT_NE(refusal({"Case/Name=a, b"}).find("cannot be varied"), std::string::npos);
  EXPECT_NE(refusal({"Bird/Mass=1, 2", "Bird/Density=1, 2, 3"}, true).find("Bird/Mass has 2, Bird/Density has 3"),
            std::string::npos);
  EXPECT_NE(refusal({"Bird/Mass=1, 1", "Bird/Density=2, 2"}, true).find("occurs twice"), std::string::npos);
  EXPECT_NE(refusal({"Bird/Mass=1:2:101", "Bird/Density=1:2:100"}).find("10100 points"), std::string::npos);
}

TEST(StudyPoints, TellFoldersApart)
{
  EXPECT_EQ(make_folder_name("Speed=-5, Roll=1.5"), "Speed=-5-Roll=1.5");
  EXPECT_NE(make_folder_name("law=s*2"), make_folder_name("law=s/2"));
  EXPECT_EQ(make_folder_name("../a").find('/'), std::string::npos);
  EXPECT_LT(make_folder_name(std::string(1000, 'a')).size(), 120u);
  EXPECT_NE(make_folder_name(std::string(1000, 'a')), make_folder_name(std::string(1001, 'a')));
}

TEST(StudyPoints, HaveFoldersOfTheirOwn)
{
  const auto points = make_points(read_study_plan({"Blade/Mesh/File=plate 1.msh | plate-1.msh | plate 2.msh"}, false));
  EXPECT_NE(points[0].folder, points[1].folder);
  EXPECT_TRUE(points[1].folder.starts_with("File=plate-1.msh-"));
  EXPECT_EQ(points[2].folder, "File=plate-2.msh") << "nothing else is called so";
}

TEST_F(Study, TextsOfAnEntryWithAUnitStandAtWholePlaces)
{
  const StudyPlan plan = read_study_plan({"Bird/Aim point=0.15, 0, 0 | 0.2, 0, 0"}, false);
  ASSERT_EQ(plan.entries[0].unit, "m");
  std::vector<PointRun> both(runs.begin(), runs.begin() + 2);
  both[0].point.at   = {0};
  both[1].point.at   = {1};
  const auto figures = make_study_figures(plan, both, StudyTable(plan, both));
  ASSERT_FALSE(figures.empty());
  EXPECT_EQ(figures[0].panels[0].x.factor, 1.);
  EXPECT_EQ(figures[0].panels[0].x.shown_unit, "m") << "as the texts are";
  EXPECT_EQ(figures[0].panels[0].x.ticks, (std::vector<std::string>{"0.15, 0, 0", "0.2, 0, 0"}));
}

TEST_F(Study, TableHasEveryPointAndSaysWhyOneIsMissing)
{
  const StudyTable  table(plan, runs);
  const std::string csv = table.as_csv();
  EXPECT_EQ(std::ranges::count(csv, '\n'), 7);
  EXPECT_TRUE(csv.starts_with("point,Bird/Mass [kg],Bird/Shape [-],"));
  EXPECT_NE(csv.find("\"lost: energy grew, in one step\""), std::string::npos);
  EXPECT_NE(table.as_text().find("lost: energy grew"), std::string::npos);
  const auto &rows = table.rows();
  const auto  peak = std::ranges::find(rows, "peak (mid-chord)", &ComparisonRow::quantity);
  ASSERT_NE(peak, rows.end());
  EXPECT_TRUE(std::isnan(peak->values[1]));
  EXPECT_DOUBLE_EQ(peak->values[5], 0.15);
  EXPECT_EQ(table.headline()[0]->quantity, "peak (mid-chord)");
}

TEST_F(Study, Hdf5HasTheGridsShape)
{
  const auto file = scratch.path() / "study.h5";
  StudyTable(plan, runs).write_hdf5(file);
  EXPECT_EQ(read_result(file, "varied/Bird/Mass"), (std::vector<double>{0.1, 0.1, 0.1, 0.2, 0.2, 0.2}));
  EXPECT_EQ(read_result(file, "varied/Bird/Shape"), (std::vector<double>{0., 1., 2., 0., 1., 2.}));
  EXPECT_EQ(read_result(file, "state/done"), (std::vector<double>{1., 0., 1., 1., 1., 1.}));
  EXPECT_DOUBLE_EQ(read_result(file, "quantities/Tip/peak (mid-chord)")[4], 0.14);
}

TEST_F(Study, DrawsFamiliesAndMaps)
{
  const auto figures = make_study_figures(plan, runs, StudyTable(plan, runs));
  ASSERT_EQ(figures.size(), 2u);
  const FigurePanel &curves = figures[0].panels[0], &map = figures[1].panels[0];
  EXPECT_EQ(curves.lines.size(), 3u) << "a curve a shape";
  EXPECT_EQ(curves.lines[1].x, (std::vector<double>{0.1, 0.2}));
  EXPECT_TRUE(std::isnan(curves.lines[1].y[0]));
  EXPECT_EQ(map.lines[0].colour.size(), 6u);
  EXPECT_EQ(map.y.ticks, (std::vector<std::string>{"cylinder", "sphere", "ellipsoid"}));
  const std::string script = script_of(figures);
  EXPECT_NE(script.find("with image pixels"), std::string::npos);
  EXPECT_NE(script.find("set ytics ('cylinder' 1, 'sphere' 2, 'ellipsoid' 3)"), std::string::npos);
}

TEST_F(Study, WritesNumbersAsShortAsTheyAreToldApart)
{
  const auto ticks = [&](const std::string &vary) {
    const StudyPlan of_mass = read_study_plan({vary, "Bird/Shape=cylinder, sphere, ellipsoid"}, false);
    return make_study_figures(of_mass, runs, StudyTable(of_mass, runs))[1].panels[0].x.ticks;
  };
  EXPECT_EQ(ticks("Bird/Mass=0.11111111111, 122.222222222"), (std::vector<std::string>{"0.1111", "122.2"}));
  EXPECT_EQ(ticks("Bird/Mass=1.000001, 1.000002"), (std::vector<std::string>{"1.000001", "1.000002"}));
}

TEST_F(Study, ShowsRowsThatOnlySomePointsHave)
{
  RecordedRun rigid;
  rigid.kind = "rigid";
  rigid.write(runs[0].folder, (scratch.path() / "plate.prm").string()); // the first of them lacks all of the blade
  const StudyTable table(plan, runs);
  const auto      &rows  = table.rows();
  const auto       place = [&](const std::string &group) {
    return std::ranges::find(rows, group, &ComparisonRow::group) - rows.begin();
  };
  EXPECT_LT(place("Tip"), place("Contact"));
  const auto peak = std::ranges::find(rows, "peak (mid-chord)", &ComparisonRow::quantity);
  EXPECT_TRUE(std::isnan(peak->values[0]));
  EXPECT_DOUBLE_EQ(peak->values[2], 0.12);
}

TEST_F(Study, SaysWhichPeaksAreNoneYet)
{
  EXPECT_EQ(StudyTable(plan, runs).as_text().find("still rising"), std::string::npos);
  RecordedRun rising;
  rising.is_rising = true;
  rising.write(runs[2].folder, (scratch.path() / "plate.prm").string());
  const StudyTable table(plan, runs);
  const auto      &rows = table.rows();
  const auto       peak = std::ranges::find(rows, "peak (mid-chord)", &ComparisonRow::quantity);
  EXPECT_TRUE(peak->is_rising(2));
  EXPECT_FALSE(peak->is_rising(1) || peak->is_rising(3));
  EXPECT_FALSE(std::ranges::find(rows, "plastic work", &ComparisonRow::quantity)->is_rising(2));
  EXPECT_NE(table.as_text().find("150 mm+"), std::string::npos);
  EXPECT_NE(table.as_text().find("+: still rising at the end"), std::string::npos);
  EXPECT_NE(table.as_csv().find(",Tip: peak (mid-chord),,done,"), std::string::npos);
}

// A blade that would tear at the fastest strike tears in no other place of the table than this.
TEST_F(Study, SaysWhichPointsWarnOfWhat)
{
  EXPECT_EQ(StudyTable(plan, runs).warnings_as_text(), "");
  RecordedRun pushed, torn;
  pushed.warnings = {"peak/not_reached", "peak/not_reached", "contact/unfinished"};
  torn.warnings   = {"contact/unfinished", "metal/elongation"};
  pushed.write(runs[0].folder, (scratch.path() / "plate.prm").string());
  torn.write(runs[3].folder, (scratch.path() / "plate.prm").string());
  const StudyTable  table(plan, runs);
  const std::string csv = table.as_csv(), text = table.as_text();
  EXPECT_NE(csv.find(",still rising,warnings,state,folder\n"), std::string::npos);
  EXPECT_NE(csv.find(",peak/not_reached contact/unfinished,done,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",contact/unfinished metal/elongation,done,"), std::string::npos) << csv;
  EXPECT_NE(text.find("\nmetal/elongation at Mass=0.2, Shape=cylinder: Something is doubtful.\n"), std::string::npos)
    << text;
  EXPECT_NE(text.find("\ncontact/unfinished at Mass=0.1, Shape=cylinder; Mass=0.2, Shape=cylinder. At Mass=0.1, "
                      "Shape=cylinder: Something is doubtful.\n"),
            std::string::npos)
    << text;
}

TEST(StudyRuns, AReasonIsTheRefusalsOwnSentence)
{
  EXPECT_EQ(find_refusal("No shock of 9e4 m/s.\nLower the speed.\n"), "No shock of 9e4 m/s.");
  EXPECT_EQ(find_refusal("Warning: Fast.\nWarning: Thin.\nNo shock of 9e4 m/s.\nLower the speed.\n"),
            "No shock of 9e4 m/s.");
  EXPECT_EQ(find_refusal("Warning: Fast."), "");
  EXPECT_EQ(find_refusal(""), "");
}
