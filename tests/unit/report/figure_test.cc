#include "report/comparison/figure.h"
#include <birdstrike/core/child_process.h>

#include <gtest/gtest.h>

#include <set>

#include "../io/scratch_folder.h"

using birdstrike::Figure;
using birdstrike::script_of;

namespace
{
  Figure make_figure()
  {
    return {"tip",
            2,
            {{"Tip", {"time", "s", "ms", 1e3}, {"deflection", "m", "mm", 1e3}, {}},
             {"Root",
              {"time", "s", "ms", 1e3},
              {"moment", "N m", "N m", 1.},
              {{"it's a_case, here", {0., 0.001, 0.1 + 0.2}, {0., 1., 2.}, 0}, {"other", {0., 0.002}, {3., 4.}, 1}}}}};
  }
} // namespace

TEST(Figure, DataHaveEveryDigitAndEmptyFieldsWhereACurveEnds)
{
  EXPECT_EQ(data_of(make_figure()), "# 1: it's a_case, here: time [s]\n# 2: it's a_case, here: moment [N m]\n"
                                    "# 3: other: time [s]\n# 4: other: moment [N m]\n"
                                    "\"it's a_case, here: time [s]\",\"it's a_case, here: moment [N m]\","
                                    "other: time [s],other: moment [N m]\n"
                                    "0,0,0,3\n0.001,1,0.002,4\n0.30000000000000004,2,,\n");
}

TEST(Figure, ScriptNamesFilesColumnsAndUnits)
{
  const std::string script = script_of({make_figure()});
  for (const char *text :
       {"'tip.csv' using ($1*1000):($2*1)", "'tip.csv' using ($3*1000):($4*1)", "title 'it''s a_case, here'",
        "'time [ms]'", "'moment [N m]'", "set output 'tip.svg'", "layout 1,2", "set multiplot next"})
    EXPECT_NE(script.find(text), std::string::npos) << text << "\n" << script;
}

TEST(Figure, TwentyEightCurvesAreAllDistinct)
{
  Figure figure{"many", 1, {{"Many", {"time", "s", "s"}, {"value", "-", "-"}, {}}}};
  for (unsigned int k = 0; k < 28; ++k)
    figure.panels[0].lines.push_back({std::to_string(k), {0.}, {1.}, k});
  const std::string     script = script_of({figure});
  std::set<std::string> styles;
  for (std::size_t at = 0; (at = script.find(" dt ", at + 1)) != std::string::npos;)
    styles.insert(script.substr(at, script.find("title", at) - at));
  EXPECT_EQ(styles.size(), 28u);
}

TEST(Figure, LevelsAreDrawnInTheShownUnit)
{
  Figure figure             = make_figure();
  figure.panels[1].y.factor = 1e-6;
  figure.panels[1].levels   = {{"yield stress", 880e6}};
  const std::string script  = script_of({figure});
  EXPECT_NE(script.find("880 with lines"), std::string::npos) << script;
  EXPECT_NE(script.find("title 'yield stress'"), std::string::npos);
}

TEST(Figure, TicksAreTextsAndNeitherFormatsNorMarkup)
{
  Figure figure            = make_figure();
  figure.panels[1].x.ticks = {"100%d", "a_b {/Symbol x}^2"};
  const std::string script = script_of({figure});
  EXPECT_NE(script.find("('100%%d' 1, 'a_b {/Symbol x}^2' 2)"), std::string::npos) << script;
  EXPECT_NE(script.find("set xtics noenhanced"), std::string::npos);
}

TEST(Figure, LeavesTicksOutWhereTheyWouldOverlap)
{
  Figure figure = make_figure();
  for (int k = 1; k <= 40; ++k)
    {
      figure.panels[1].x.ticks.push_back(std::to_string(100 + k)); // 160 letters in room for 70
      figure.panels[1].y.ticks.push_back(std::to_string(100 + k));
    }
  const std::string script = script_of({figure});
  EXPECT_NE(script.find("set xtics ('101' 1, '104' 4, '107' 7, "), std::string::npos) << script;
  EXPECT_NE(script.find("set ytics ('101' 1, '102' 2, "), std::string::npos);
}

TEST(Figure, AValueThatStillRisesHasAnOpenMarkerAndAColumn)
{
  Figure figure                       = make_figure();
  figure.panels[1].lines[0].is_rising = {0., 1., 0.};
  EXPECT_NE(data_of(figure).find("\n# 3: it's a_case, here: still rising, no peak yet: moment [-]\n"),
            std::string::npos)
    << data_of(figure);
  const std::string script = script_of({figure});
  for (const char *text :
       {"'tip.csv' using ($1*1000):($3>0 ? $2*1 : NaN) with points pt 6",
        "title 'still rising at the end of the run, no peak yet'", "'tip.csv' using ($4*1000):($5*1)"})
    EXPECT_NE(script.find(text), std::string::npos) << text << "\n" << script;
}

TEST(Figure, ACellThatStillRisesHasAPlus)
{
  Figure figure{"map", 1, {{"Map", {"a", "-", "-", 1., {"1", "2"}}, {"b", "-", "-", 1., {"3", "4"}}, {{}}}}};
  figure.panels[0].colour          = {"peak", "m", "mm", 1e3};
  figure.panels[0].lines[0].x      = {1., 2., 1., 2.};
  figure.panels[0].lines[0].y      = {1., 1., 2., 2.};
  figure.panels[0].lines[0].colour = {0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(script_of({figure}).find("'+'"), std::string::npos) << "nothing rises";
  figure.panels[0].lines[0].is_rising = {0., 1., 0., 0.};
  EXPECT_NE(script_of({figure}).find("sprintf('%.4g%s',($3*1000),$4>0 ? '+' : '')"), std::string::npos);
  const ScratchFolder scratch;
  scratch.write("map.csv", data_of(figure));
  scratch.write("figures.gp", script_of({figure}));
  const auto result = birdstrike::run_child({{"gnuplot", "figures.gp"}, scratch.path().string(), true});
  EXPECT_EQ(result.output, "");
  const std::string svg = read_text(scratch.path() / "map.svg");
  for (const char *text : {">100<", ">200+<", "+: still rising at the end of the run, no peak yet"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Figure, GnuplotDrawsIt)
{
  const ScratchFolder scratch;
  Figure              figure          = make_figure();
  figure.panels[1].levels             = {{"yield stress", 3.5}};
  figure.panels[1].lines[1].is_rising = {1., 0.};
  scratch.write("tip.csv", data_of(figure));
  scratch.write("figures.gp", script_of({figure}));
  const auto result = birdstrike::run_child({{"gnuplot", "figures.gp"}, scratch.path().string(), true});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "") << "warnings, too, are faults of the script";
  const std::string svg = read_text(scratch.path() / "tip.svg");
  EXPECT_NE(svg.find("moment [N m]"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}
