#include "report/comparison/comparison_figures.h"
#include "report/comparison/comparison_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/comparison_folder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

using namespace birdstrike;

namespace
{
  /// A run, one that deflects by a fifth more, and one that was lost.
  class Comparison : public ::testing::Test
  {
  protected:
    ScratchFolder            scratch;
    std::vector<ComparedRun> runs;

    void SetUp() override
    {
      const std::string prm = scratch.write("plate.prm", "");
      RecordedRun       first, second;
      first.more   = {{"energy/max_relative_error", 0.}, {"steps/blade", 12345.}};
      second.stays = 0.12;
      second.peak  = 0.18;
      first.write(scratch.path() / "first", prm);
      second.write(scratch.path() / "second", prm);
      {
        RunFolder lost(scratch.path() / "lost");
        first.write_history(lost.path());
        lost.fail("the energy error at t = 1 ms is 7 %");
      }
      for (const std::string name : {"first", "second", "lost"})
        runs.push_back({name, RunRecord(scratch.path() / name)});
    }

    static const ComparisonRow &find(const ComparisonTable &table, const std::string &quantity)
    {
      const auto found = std::find_if(table.rows().begin(), table.rows().end(),
                                      [&](const ComparisonRow &row) { return row.quantity == quantity; });
      if (found == table.rows().end())
        throw std::out_of_range(quantity);
      return *found;
    }
  };
} // namespace

TEST_F(Comparison, PutsSummariesSideBySide)
{
  const ComparisonTable table(runs);
  const ComparisonRow  &peak = find(table, "peak (mid-chord)");
  EXPECT_EQ(peak.unit, "m");
  EXPECT_EQ(peak.values[0], 0.15);
  EXPECT_EQ(peak.values[1], 0.18);
  EXPECT_TRUE(std::isnan(peak.values[2]));
  EXPECT_NEAR(peak.difference(1), 0.2, 1e-15);
  EXPECT_TRUE(std::isnan(peak.difference(2)));
  EXPECT_EQ(find(table, "impulse (norm)").values[0], 5.) << "of (3, 0, -4) N s";
  EXPECT_EQ(find(table, "absorbed by the blade (end less start)").values[0], 42. - 2.5)
    << "neither the bird's energy nor what the blade brought";
  EXPECT_TRUE(std::isnan(find(table, "largest energy error").difference(1))) << "no share of nothing";
}

TEST_F(Comparison, SaysWhosePeakIsStillToCome)
{
  const auto says = [&] {
    const std::string text = ComparisonTable(runs).as_text();
    return text.find("Tip peak of 'first': still rising at the end") != std::string::npos;
  };
  EXPECT_FALSE(says());
  RecordedRun rising;
  rising.is_rising = true;
  rising.write(scratch.path() / "first", scratch.write("plate.prm", ""));
  runs[0].record = RunRecord(scratch.path() / "first");
  EXPECT_TRUE(says());
}

TEST_F(Comparison, PermanentDeflectionIsTheMeanOfTheLastPeriod)
{
  const ComparisonTable table(runs);
  const ComparisonRow  &row = find(table, "permanent deflection");
  // a cosine by 1000 samples a period: the trapezoidal rule is exact over whole periods but for its two ends
  EXPECT_NEAR(row.values[0], 0.1, 1e-6);
  EXPECT_NEAR(row.values[1], 0.12, 1e-6);
  EXPECT_TRUE(std::any_of(table.notes().begin(), table.notes().end(),
                          [](const std::string &note) { return note.find("first: 10 ms") != std::string::npos; }));
}

TEST_F(Comparison, SaysWhichCaseWasLostAndWhy)
{
  const ComparisonTable table(runs);
  EXPECT_EQ(find(table, "ended").texts, (std::vector<std::string>{"end time reached", "end time reached", "lost"}));
  const std::string text = table.as_text();
  EXPECT_NE(text.find("'lost' was lost: failed: the energy error at t = 1 ms is 7 %"), std::string::npos) << text;
}

TEST_F(Comparison, TextHasPrefixesAndDifferences)
{
  const std::string text = ComparisonTable(runs).as_text();
  for (const char *part : {"150 mm", "180 mm", "+20 %", "900 MPa", "12 345"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(Comparison, CsvHasEveryDigitInSi)
{
  const std::string csv = ComparisonTable(runs).as_csv();
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "group,quantity,unit,first,second,lost,difference of second [%],difference of lost [%]");
  EXPECT_NE(csv.find("Root,peak normal stress,Pa,900000000,900000000,,0,\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("Case,ended,,end time reached,end time reached,lost,,\n"), std::string::npos) << csv;
  EXPECT_EQ(csv_field("a, \"b\""), "\"a, \"\"b\"\"\"");
}

TEST_F(Comparison, MarkdownLinesHaveOneCellAColumn)
{
  runs[1].name               = "a|b";
  const std::string markdown = ComparisonTable(runs).as_markdown();
  EXPECT_EQ(markdown.substr(0, markdown.find('\n')), "|  | first | a\\|b | difference | lost | difference |");
  EXPECT_NE(markdown.find("\n| Tip: peak (mid-chord) | 150 mm | 180 mm | +20 % | - | - |\n"), std::string::npos)
    << markdown;
}

TEST_F(Comparison, RowsThatNobodyFillsAreLeftOut)
{
  runs.erase(runs.begin(), runs.begin() + 2); // the lost one alone
  const ComparisonTable table(runs);
  EXPECT_THROW(find(table, "peak (mid-chord)"), std::out_of_range);
  EXPECT_NO_THROW(find(table, "ended"));
}

TEST_F(Comparison, FiguresOverlayTheRuns)
{
  const std::vector<Figure> figures = make_comparison_figures(runs);
  std::vector<std::string>  stems;
  for (const Figure &figure : figures)
    stems.push_back(figure.stem);
  ASSERT_EQ(stems, (std::vector<std::string>{"tip_deflection", "root_moment", "contact", "energies", "profiles"}))
    << "only what the runs recorded";
  ASSERT_EQ(figures[0].panels[0].lines.size(), 3u) << "of a lost run, too, up to its end";
  EXPECT_EQ(figures[0].panels[0].lines[1].y[500], runs[1].record.column("tip_mid_chord")[500]);
  EXPECT_NEAR(figures[2].panels[0].lines[0].y[7], 1000. * std::sqrt(3.), 1e-9) << "norm of (1, 1, 1) kN";
  EXPECT_NEAR(figures[2].panels[0].x_end, 26e-3, 11e-6) << "this force never falls";
  const FigurePanel &root = figures[4].panels[0], &mid_chord = figures[4].panels[1];
  EXPECT_EQ(root.lines[0].y, (std::vector<double>{1e8, 2e8}));
  EXPECT_EQ(root.lines[1].y, (std::vector<double>{-1e8, -2e8}));
  EXPECT_TRUE(root.lines[1].is_dashed);
  EXPECT_EQ(mid_chord.lines[1].y, (std::vector<double>{0., 0.18}));
}

TEST(ComparisonFolder, IsTakenAgainButNeverFromARunOrAStranger)
{
  const ScratchFolder scratch;
  const auto          own = scratch.path() / "own";
  ComparisonFolder(own).write_text("tip_deflection.csv", "old");
  ComparisonFolder(own).write_text("notes.txt", "mine");
  ComparisonFolder{own};
  EXPECT_FALSE(std::filesystem::exists(own / "tip_deflection.csv")) << "figures of an earlier comparison go";
  EXPECT_EQ(read_text(own / "notes.txt"), "mine");
  RunFolder(scratch.path() / "run").finish("{}");
  EXPECT_THROW(ComparisonFolder{scratch.path() / "run"}, InputError);
  EXPECT_THROW(ComparisonFolder{scratch.path()}, InputError);
  EXPECT_THROW(ComparisonFolder{own / "notes.txt"}, InputError);
  EXPECT_EQ(ComparisonFolder::run_folder("out", "a b/c"), std::filesystem::path("out/a-b-c"));
}
