#include "report/comparison/comparison_table.h"
#include "report/comparison/written_table.h"
#include "report/study/study_table.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include "../io/scratch_folder.h"

using namespace birdstrike;

// RFC 4180: fields with commas are quoted, a quote within is doubled.
TEST(WrittenTable, ReadsWhatCsvFieldsWrite)
{
  const ScratchFolder scratch;
  const std::string   odd = "0.15, 0, \"a\"";
  const auto file = scratch.write("table.csv", "point,where [m],state\n1," + csv_field(odd) + ",done\n2,,\n3\n");
  const WrittenTable table(file);
  EXPECT_EQ(table.headings(), (std::vector<std::string>{"point", "where [m]", "state"}));
  ASSERT_EQ(table.n_rows(), 3u);
  EXPECT_EQ(table.field(0, "where [m]"), odd);
  EXPECT_EQ(table.field(0, "state"), "done");
  EXPECT_EQ(table.field(1, "state"), "");
  EXPECT_EQ(table.field(2, "state"), "") << "a row that was cut off";
  EXPECT_EQ(table.field(0, "no such column"), "");
  EXPECT_EQ(WrittenTable(scratch.path() / "none.csv").n_rows(), 0u);
}

namespace
{
  /// Lost points of a table, for a new study of these entries.
  std::vector<std::string> lost(const std::string &table, const std::vector<std::string> &vary,
                                const bool are_pairs = false)
  {
    const ScratchFolder   scratch;
    const StudyPlan       plan = read_study_plan(vary, are_pairs);
    std::vector<PointRun> runs;
    for (const StudyPoint &point : make_points(plan))
      runs.push_back({point, {}, "", false, false, 0});
    return find_lost_points(scratch.write("study.csv", table), plan, runs);
  }

  const std::string table_of_two =
    "point,Bird/Mass [kg],Bird/Density [kg/m^3],Case: blade,still rising,warnings,state,folder\n"
    "1,0.1,900,shell,,,done,a/Mass=0.1-Density=900\n"
    "2,0.2,900,,,,lost: energy,a/Mass=0.2-Density=900\n";
} // namespace

TEST(LostPoints, AreThoseWithValuesThatTheNewStudyLacks)
{
  using Names            = std::vector<std::string>;
  const std::string mass = "Bird/Mass=0.1, 0.2", density = "Bird/Density=900, 950";
  EXPECT_EQ(lost(table_of_two, {mass, density}), Names()) << "all of them are there, and more";
  EXPECT_EQ(lost(table_of_two, {"Bird/Mass=100 g, 300 g", density}), Names())
    << "of a point that was lost there is no value";
  EXPECT_EQ(lost(table_of_two, {mass, density}, true), Names()) << "pairs that hold the point";
  EXPECT_EQ(lost(table_of_two, {"Bird/Mass=0.2, 0.3", density}), Names{"Mass=0.1-Density=900"});
  EXPECT_EQ(lost(table_of_two, {mass}), Names{"Mass=0.1-Density=900"}) << "its density is another one, or not known";
  EXPECT_EQ(lost(table_of_two, {density, mass}), Names{"Mass=0.1-Density=900"}) << "another order is another table";
  EXPECT_EQ(lost(table_of_two, {"Bird 2/Mass=0.1, 0.2", density}), Names{"Mass=0.1-Density=900"});
  EXPECT_EQ(lost("", {mass}), Names());
}

TEST(LostPoints, AreRefusedByName)
{
  const ReportKind kind{"study", {}, {}};
  EXPECT_NO_THROW(refuse_loss_of({}, "here", kind, "the same"));
  EXPECT_THROW(refuse_loss_of({"Mass=0.1"}, "here", kind, "the same"), InputError);
}
