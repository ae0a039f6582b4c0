#include "io/parameter_tree.h"
#include <birdstrike/io/parameter_file.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scratch_folder.h"
#include "small_parameters.h"

TEST(ParameterFile, ReadsValuesAndOverrides)
{
  const ScratchFolder scratch;
  SmallCase           small;
  const std::string   text = "subsection Bird\n  set Mass = 2.5\n  set Shape = flat\nend\n";
  small.file.read(scratch.write("case.prm", text),
                  {"Bird/Flight/Velocity = 300", " Bird / Mass=3", "Blade/Friction=on"});
  EXPECT_EQ(small.values.mass, 3.);
  EXPECT_EQ(small.values.shape, "flat");
  EXPECT_EQ(small.values.velocity, 300.);
  EXPECT_EQ(small.values.count, 5u);
  EXPECT_TRUE(small.values.friction);
  EXPECT_EQ(small.file.original(), text);
}

TEST(ParameterFile, PrintedFileGivesTheSameValuesToTheLastDigit)
{
  const ScratchFolder scratch;
  SmallCase           first, second;
  first.file.read(scratch.write("case.prm", "subsection Bird\n set Title = of clay, 1 \\\n  2\nend\n"),
                  {"Bird/Mass=0.12345678901234567", "Bird/Flight/Velocity=-1.7976931348623157e+308",
                   "Blade/Thickness=4.9406564584124654e-324", "Blade/Count=7", "Blade/Friction=yes"});
  const std::string printed = first.file.as_prm();
  second.file.read(scratch.write("parameters.prm", printed));
  EXPECT_EQ(second.values.mass, 0.12345678901234567);
  EXPECT_EQ(second.values.velocity, -1.7976931348623157e+308);
  EXPECT_EQ(second.values.thickness, 4.9406564584124654e-324);
  EXPECT_EQ(second.values.count, 7u);
  EXPECT_TRUE(second.values.friction);
  EXPECT_EQ(second.values.shape, first.values.shape);
  EXPECT_EQ(second.values.title, "of clay, 1 2");
  EXPECT_EQ(second.file.as_prm(), printed);
}

TEST(ParameterFile, PrintsTextUnitRangeAndDefault)
{
  SmallCase         small;
  const std::string printed = small.file.as_prm();
  EXPECT_NE(printed.find("subsection Bird\n"
                         "  # Mass of the bird. [kg]\n"
                         "  # Range: a number from 0 to 10. Default: 1.8.\n"
                         "  set Mass = 1.8\n"),
            std::string::npos)
    << printed;

  const auto json = nlohmann::json::parse(small.file.as_json());
  EXPECT_EQ(json["Bird"]["Flight"]["Velocity"]["unit"], "m/s");
  EXPECT_EQ(json["Bird"]["Mass"]["default"], "1.8");
  EXPECT_EQ(json["Bird"]["Mass"]["text"], "Mass of the bird.");
  EXPECT_EQ(json["Bird"]["Shape"]["range"], "one of flat, hemispherical");
}

TEST(ParameterFile, ChecksRulesBetweenEntriesAndNamesTheFile)
{
  const ScratchFolder scratch;
  SmallCase           small;
  try
    {
      small.file.read(scratch.write("case.prm", "subsection Bird\n  set Mass = 0\nend\n"));
      FAIL() << "a bird without mass was accepted";
    }
  catch (const birdstrike::InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("case.prm: Bird/Mass is 0."), std::string::npos) << error.what();
    }
}

// "Shape" stands for a name that the other entries of its section belong to.
TEST(ParameterFile, KnowsWhatWasSetBesideAnotherValue)
{
  using Names = std::vector<std::string>;
  const ScratchFolder scratch;
  scratch.write("base.prm", "subsection Bird\n set Mass = 2\n set Title = default\nend\n");
  const std::string base = "include base.prm\n", flat = "subsection Bird\n set Shape = flat\nend\n";
  const auto        before = [&](const std::string &text, const std::vector<std::string> &overrides) {
    SmallCase small;
    small.file.read(scratch.write("case.prm", text), overrides);
    return small.file.set_before("Bird", "Shape");
  };
  EXPECT_EQ(before(base + flat, {}), Names{"Mass"}) << "an included file";
  EXPECT_EQ(before(flat + base, {}), Names{}) << "set after it";
  EXPECT_EQ(before(base, {"Bird/Shape=flat"}), Names{"Mass"});
  EXPECT_EQ(before(base, {"Bird/Mass=3", "Bird/Shape=flat"}), Names{}) << "the command line is one source";
  EXPECT_EQ(before(flat + base, {"Bird/Shape=default"}), (Names{"Mass"})) << "given back";
  EXPECT_EQ(before(base, {"Bird/Shape=hemispherical"}), Names{}) << "the default";
  EXPECT_EQ(before(base + flat, {"Bird/Shape=flat"}), Names{}) << "as the file has it";
  EXPECT_EQ(before("subsection Bird\n set Mass = 2\n set Shape = flat\nend\n", {}), Names{}) << "one file";
  EXPECT_EQ(before(base, {"Bird/Shape=flat", "Bird/Mass=1.8"}), Names{}) << "its default";
  EXPECT_EQ(before(base, {}), Names{});
}

TEST(ParameterFile, EntersASectionForGroupsThatDoNot)
{
  SmallParameters           values;
  birdstrike::ParameterFile file({birdstrike::ParameterGroup::of(values, "Outer")});
  EXPECT_NE(file.tree().find({"Outer", "Bird", "Flight"}, "Velocity"), nullptr);
  EXPECT_EQ(file.tree().find({"Bird", "Flight"}, "Velocity"), nullptr);
}
