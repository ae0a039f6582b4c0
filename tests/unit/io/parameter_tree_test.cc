#include "io/parameter_tree.h"

#include <gtest/gtest.h>

#include "small_parameters.h"

using birdstrike::ParameterTree;
using birdstrike::SectionPath;

TEST(ParameterTree, HoldsEntriesInTheOrderOfDeclaration)
{
  const SmallCase     small;
  const ParameterTree tree = small.file.tree();
  EXPECT_EQ(tree.entry_names({"Bird"}), (std::vector<std::string>{"Mass", "Shape", "Title"}));
  EXPECT_EQ(tree.subsection_names({}), (std::vector<std::string>{"Bird", "Blade"}));
  EXPECT_EQ(tree.sections_with("Velocity"), (std::vector<SectionPath>{{"Bird", "Flight"}}));
  EXPECT_TRUE(tree.has_section({"Bird", "Flight"}));
  EXPECT_FALSE(tree.has_section({"Flight"}));
  ASSERT_NE(tree.find({"Blade"}, "Count"), nullptr);
  EXPECT_TRUE(tree.find({"Blade"}, "Count")->allows("7"));
  EXPECT_FALSE(tree.find({"Blade"}, "Count")->allows("8"));
  EXPECT_EQ(tree.find({"Bird"}, "Count"), nullptr);
}

TEST(ParameterTree, SplitsTextAndUnitAndPutsRangesInWords)
{
  using namespace dealii::Patterns;
  dealii::ParameterHandler prm;
  prm.declare_entry("Point", "0, 0, 0", List(Double(), 3, 3), "A point. [m]");
  prm.declare_entry("Angle", "0", Double(-90., std::numeric_limits<double>::max()), "An angle [sic] of a path. [deg]");
  prm.declare_entry("Factor", "0", Double(std::numeric_limits<double>::lowest(), 1.), "A factor.");
  prm.declare_entry("Length", "1", Double(1e-300), "A length. [m]");
  prm.declare_entry("File", "", FileName(), "A file. [-]");
  const ParameterTree tree(prm);
  EXPECT_EQ(tree.find({}, "Point")->range, "3 items separated by ',', each a number");
  EXPECT_EQ(tree.find({}, "Point")->unit, "m");
  EXPECT_EQ(tree.find({}, "Angle")->range, "a number, at least -90");
  EXPECT_EQ(tree.find({}, "Angle")->text, "An angle [sic] of a path.");
  EXPECT_EQ(tree.find({}, "Angle")->unit, "deg");
  EXPECT_EQ(tree.find({}, "Factor")->range, "a number, at most 1");
  EXPECT_EQ(tree.find({}, "Length")->range, "a number above 0");
  EXPECT_EQ(tree.find({}, "Factor")->unit, "");
}

TEST(ParameterTree, NearestNameByEditDistance)
{
  const std::vector<std::string> names{"Mass", "Density", "Particle spacing"};
  EXPECT_EQ(birdstrike::nearest_name("mass", names), "Mass");
  EXPECT_EQ(birdstrike::nearest_name("Denisty", names), "Density");
  EXPECT_EQ(birdstrike::nearest_name("Particles spacing", names), "Particle spacing");
  EXPECT_EQ(birdstrike::nearest_name("Young's modulus", names), "");
  EXPECT_EQ(birdstrike::nearest_name("x", {}), "");
}
