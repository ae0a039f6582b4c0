#include "report/comparison/comparison_figures.h"
#include "report/comparison/comparison_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/report_folder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

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
  EXPECT_NEAR(row.values[0], 0.1 - 0.05, 1e-6) << "less what there was before the strike, as of a blade that turns";
  EXPECT_NEAR(row.values[1], 0.12 - 0.06, 1e-6);
  EXPECT_TRUE(std::any_of(table.notes().begin(), table.notes().end(),
                          [](const std::string &note) { return note.find("first: 10 ms") != std::string::npos; }));
}

// What the tip swings about while it is pushed upon is no permanent deflection, however many periods there are.
TEST_F(Comparison, ABladeThatIsStillPushedHasNoPermanentDeflection)
{
  RecordedRun pushed;
  pushed.warnings = {"peak/not_reached", "contact/unfinished"};
  pushed.write(scratch.path() / "second", scratch.write("plate.prm", ""));
  runs[1].record = RunRecord(scratch.path() / "second");
  const ComparisonTable table(runs);
  const ComparisonRow  &row = find(table, "permanent deflection");
  EXPECT_NEAR(row.values[0], 0.05, 1e-6) << "as in PermanentDeflectionIsTheMeanOfTheLastPeriod";
  EXPECT_TRUE(std::isnan(row.values[1]));
  const std::string text = table.as_text();
  EXPECT_NE(text.find("Permanent deflection: none for 'second', where the bird still loads the blade"),
            std::string::npos)
    << text;
  EXPECT_EQ(text.find("second: 10 ms"), std::string::npos) << text;
}

// Its tip swings about where it was: the mean over a period, of modes that no whole period fits, is their beat.
TEST_F(Comparison, ABladeThatHasNotYieldedHasNoPermanentDeflection)
{
  for (const auto &[work, expected] :
       {std::pair(std::vector<double>{3., 3.}, 0.), std::pair(std::vector<double>{3., 3.1}, 0.05)})
    {
      RecordedRun run;
      run.plastic_work = work; // what spin had made flow before the strike does not count
      run.write(scratch.path() / "first", scratch.write("plate.prm", ""));
      runs[0].record = RunRecord(scratch.path() / "first");
      const ComparisonTable table(runs);
      EXPECT_NEAR(find(table, "permanent deflection").values[0], expected, 1e-6);
      EXPECT_EQ(table.as_text().find("zero for 'first', where nothing has yielded") != std::string::npos,
                expected == 0.);
    }
}

TEST_F(Comparison, SaysWhichRunsWarnOfWhat)
{
  RecordedRun torn;
  torn.warnings = {"metal/elongation", "contact/unfinished"};
  torn.write(scratch.path() / "second", scratch.write("plate.prm", ""));
  runs[1].record = RunRecord(scratch.path() / "second");
  const ComparisonTable table(runs);
  const std::string     csv = table.as_csv(), text = table.as_text(), markdown = table.as_markdown();
  EXPECT_NE(csv.find(",warnings\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",metal/elongation contact/unfinished\n"), std::string::npos) << csv;
  EXPECT_NE(text.find("metal/elongation at 'second': Something is doubtful.\n"), std::string::npos) << text;
  EXPECT_NE(markdown.find("| second | metal/elongation contact/unfinished |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("| first | - |"), std::string::npos) << markdown;
}

TEST_F(Comparison, SaysWhereFilteredForcesAreNotAlike)
{
  EXPECT_EQ(ComparisonTable(runs).as_text().find("Filtered forces"), std::string::npos);
  RecordedRun unfiltered;
  unfiltered.channel_class = "none";
  unfiltered.write(scratch.path() / "second", scratch.write("plate.prm", ""));
  runs[1].record         = RunRecord(scratch.path() / "second");
  const std::string text = ComparisonTable(runs).as_text();
  EXPECT_NE(text.find("Filtered forces are not alike, by Output/Channel class: 'first' CFC 1000, 'second' none."),
            std::string::npos)
    << text;
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

TEST_F(Comparison, CsvHasARowARunWithEveryDigitInSi)
{
  const ComparisonTable                 table(runs);
  std::istringstream                    csv(table.as_csv());
  std::vector<std::vector<std::string>> cells;
  for (std::string line; std::getline(csv, line);)
    {
      cells.push_back({""});
      bool is_quoted = false;
      for (const char letter : line)
        if (letter == '"')
          is_quoted = !is_quoted;
        else if (letter == ',' && !is_quoted)
          cells.back().emplace_back();
        else
          cells.back().back() += letter;
    }
  ASSERT_EQ(cells.size(), 4u) << "a head, and three runs";
  const auto column = [&](const std::string &name) {
    const auto found = std::ranges::find(cells[0], name);
    EXPECT_NE(found, cells[0].end()) << name;
    std::vector<std::string> values;
    for (std::size_t run = 1; run < cells.size(); ++run)
      values.push_back(cells[run].at(static_cast<std::size_t>(found - cells[0].begin())));
    return values;
  };
  using Values = std::vector<std::string>;
  EXPECT_EQ(column("case"), (Values{"first", "second", "lost"}));
  EXPECT_EQ(column("Root: peak normal stress [Pa]"), (Values{"900000000", "900000000", ""}));
  EXPECT_EQ(column("difference of Root: peak normal stress [%]"), (Values{"0", "0", ""}));
  EXPECT_EQ(column("Case: ended"), (Values{"end time reached", "end time reached", "lost"}));
  EXPECT_EQ(csv_field("a, \"b\""), "\"a, \"\"b\"\"\"");
}

TEST_F(Comparison, MarkdownHasATableAGroupAndALineARun)
{
  runs[1].name               = "a|b";
  const std::string markdown = ComparisonTable(runs).as_markdown();
  EXPECT_NE(markdown.find("| Tip | peak (mid-chord) |  |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("\n| a\\|b | 180 mm | +20 % |"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("Differences are to 'first'."), std::string::npos);
}

TEST_F(Comparison, SaysWhatRootStressOfShellAndSolidIs)
{
  EXPECT_EQ(ComparisonTable(runs).as_text().find("Root stress of a shell"), std::string::npos);
  RecordedRun solid;
  solid.kind = "solid";
  solid.write(scratch.path() / "second", scratch.write("plate.prm", ""));
  runs[1].record         = RunRecord(scratch.path() / "second");
  const std::string text = ComparisonTable(runs).as_text();
  EXPECT_NE(text.find("Root stress of a shell"), std::string::npos);
  // outermost abscissa of Gauss-Legendre with seven points, the default: 0.9491 (Abramowitz and Stegun, table 25.4)
  EXPECT_NE(text.find("0.95 with seven Gauss points"), std::string::npos) << text;
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
  const FigurePanel &struck = figures[4].panels[0], &rear = figures[4].panels[1], &mid_chord = figures[4].panels[2];
  EXPECT_EQ(struck.lines[0].y, (std::vector<double>{1e8, 2e8}));
  EXPECT_EQ(rear.lines[0].y, (std::vector<double>{-1e8, -2e8}));
  EXPECT_EQ(mid_chord.lines[1].y, (std::vector<double>{0., 0.18}));
}

TEST_F(Comparison, ContactIsDrawnUntilItsImpulseIsGiven)
{
  for (ComparedRun &run : runs) // 1 kN for 5 ms, then nothing: the impulse stays
    {
      const auto history = run.record.folder() / "history.csv";
      std::ofstream(history)
        << "time,contact_force_x,contact_impulse_x,contact_impulse_y,contact_impulse_z\n0,0,0,0,0\n"
           "0.004,0,4,0,0\n0.005,0,5,0,0\n0.01,0,5,0,0\n";
      run.record = RunRecord(run.record.folder());
    }
  const auto figures = make_comparison_figures(runs);
  const auto contact = std::ranges::find(figures, "contact", &Figure::stem);
  ASSERT_NE(contact, figures.end());
  EXPECT_NEAR(contact->panels[0].x_end, 1.1 * 4e-3, 1e-12) << "the last row that has not the last impulse";
}

TEST_F(Comparison, AVectorOfWhichAColumnIsAbsentIsNotDrawn)
{
  for (ComparedRun &run : runs)
    {
      std::ofstream(run.record.folder() / "history.csv")
        << "time,contact_force_peak,contact_impulse_x,contact_impulse_z\n0,1,0,0\n0.004,2,4,0\n";
      run.record = RunRecord(run.record.folder());
    }
  const auto figures = make_comparison_figures(runs);
  const auto contact = std::ranges::find(figures, "contact", &Figure::stem);
  ASSERT_NE(contact, figures.end());
  for (const FigurePanel &panel : contact->panels)
    EXPECT_NE(panel.title, "Contact impulse");
}

TEST_F(Comparison, DrawsTheYieldStressOfEachMetalOnce)
{
  RecordedRun run;
  run.metals = {{"Ti", 880e6}, {"Al", 276e6}};
  for (const char *name : {"first", "second"})
    run.write(scratch.path() / name, scratch.write("plate.prm", ""));
  for (ComparedRun &each : runs)
    each.record = RunRecord(each.record.folder());
  const auto figures  = make_comparison_figures(runs);
  const auto profiles = std::ranges::find(figures, "profiles", &Figure::stem);
  ASSERT_NE(profiles, figures.end());
  const auto &levels = profiles->panels[0].levels;
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels[0].title, "yield stress of Al");
  EXPECT_EQ(levels[0].y, 276e6);
  EXPECT_EQ(levels[1].y, -276e6);
  EXPECT_EQ(levels[2].title, "yield stress of Ti");
}

TEST(ReportFolder, IsTakenAgainButNeverFromARunOrAStranger)
{
  const ScratchFolder scratch;
  const auto          own = scratch.path() / "own";
  const ReportKind    kind{"comparison", {"tip_deflection"}};
  ReportFolder(own, kind).write_text("tip_deflection.csv", "old");
  ReportFolder(own, kind).write_text("notes.txt", "mine");
  ReportFolder{own, kind};
  EXPECT_FALSE(std::filesystem::exists(own / "tip_deflection.csv")) << "figures of an earlier comparison go";
  EXPECT_EQ(read_text(own / "notes.txt"), "mine");
  RunFolder(scratch.path() / "run").finish("{}");
  EXPECT_THROW((ReportFolder{scratch.path() / "run", kind}), InputError);
  EXPECT_THROW((ReportFolder{scratch.path(), kind}), InputError);
  EXPECT_THROW((ReportFolder{own / "notes.txt", kind}), InputError);
  EXPECT_THROW((ReportFolder{own, {"study", {}}}), InputError) << "a study would mix with it";
  EXPECT_EQ(ReportFolder::run_folder("out", "a b/c"), std::filesystem::path("out/a-b-c"));
}
