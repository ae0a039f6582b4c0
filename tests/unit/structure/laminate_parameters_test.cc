#include "laminate_case.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

namespace laminate_parameters_test
{
  using namespace laminate_case;

  namespace
  {
    std::vector<PlyLayer> read(const std::string &plies)
    {
      LaminateParameters p = LaminateParameters::of_blade();
      p.plies              = plies;
      return p.layers();
    }

    std::vector<double> angles(const std::string &plies)
    {
      std::vector<double> result;
      for (const PlyLayer &layer : read(plies))
        result.push_back(layer.angle);
      return result;
    }
  } // namespace

  TEST(LaminateParameters, ReadStackingCodes)
  {
    using List = std::vector<double>;
    EXPECT_EQ(angles("[0/90]"), List({0., 90.}));
    EXPECT_EQ(angles("[0/90]s"), List({0., 90., 90., 0.}));
    EXPECT_EQ(angles("[0/90]2s"), List({0., 90., 0., 90., 90., 0., 90., 0.}));
    EXPECT_EQ(angles(" [0_2/+-45/-30.5] "), List({0., 0., 45., -45., -30.5}));
    EXPECT_EQ(angles("[+-30_2]"), List({30., -30., 30., -30.}));
    EXPECT_EQ(angles("0; 45; -45"), List({0., 45., -45.}));
    for (const PlyLayer &layer : read("[0/90]s"))
      EXPECT_DOUBLE_EQ(layer.share, 0.25);
  }

  TEST(LaminateParameters, ThicknessesAreShares)
  {
    const auto metres = read("0: 0.125e-3; 45: 0.375e-3"), parts = read("0: 1; 45: 3");
    for (int k = 0; k < 2; ++k)
      {
        EXPECT_DOUBLE_EQ(metres[k].share, k == 0 ? 0.25 : 0.75);
        EXPECT_DOUBLE_EQ(parts[k].share, metres[k].share);
      }
  }

  TEST(LaminateParameters, RefuseWhatIsNoStack)
  {
    for (const char *bad :
         {"[0/90", "[0/x]", "[0/90]t", "[0_0]", "[]", "0; ; 90", "0: -1", "0: 1; 90", "[500]", "[0_2000]"})
      EXPECT_THROW(read(bad), InputError) << bad;
  }

  TEST(LaminateParameters, SectionsTakeWhatTheyDoNotGiveFromTheBlade)
  {
    BladeParameters p;
    p.laminate.plies                           = "[0/90]s";
    p.laminate.ply                             = carbon();
    p.laminate.ply.strength                    = {2e9, 1e9, 5e7, 2e8, 8e7, 0.};
    p.sections[0].material_ids                 = "1";
    p.sections[1].material_ids                 = "2";
    p.sections[2].material_ids                 = "3";
    p.sections[0].material.name                = "Ti-6Al-4V";
    p.sections[1].laminate.plies               = "45";
    p.sections[1].laminate.ply.young_1         = 200e9;
    p.sections[1].laminate.reference_direction = "0 1 0";
    p.check();
    const auto of = p.by_section();
    EXPECT_TRUE(of.at(0).is_laminate());
    EXPECT_FALSE(of.at(1).is_laminate());
    EXPECT_EQ(of.at(1).density(), 4430.);
    EXPECT_FALSE(of.at(1).material_can_fail());
    EXPECT_EQ(of.at(2).laminate.ply.young_1, 200e9);
    EXPECT_EQ(of.at(2).laminate.ply.young_2, 9e9);
    EXPECT_EQ(of.at(2).laminate.reference()[1], 1.);
    EXPECT_TRUE(of.at(2).material_can_fail());
    EXPECT_EQ(of.at(3).laminate, of.at(0).laminate);
    EXPECT_EQ(of.at(3).density(), 1600.);
  }

  TEST(LaminateParameters, HalvesTakePliesThatAreTheirOwnMirrorImages)
  {
    LaminateParameters p         = LaminateParameters::of_blade();
    const auto         symmetric = [&](const char *plies, const char *direction) {
      p.plies               = plies;
      p.reference_direction = direction;
      return p.is_symmetric_about_y();
    };
    EXPECT_TRUE(symmetric("[0/90]s", "1 0 0"));
    EXPECT_TRUE(symmetric("[0/90/-90]", "0 1 0"));
    EXPECT_FALSE(symmetric("[45/-45]s", "1 0 0"));
    EXPECT_FALSE(symmetric("[0/90]s", "1 1 0"));
  }
} // namespace laminate_parameters_test
