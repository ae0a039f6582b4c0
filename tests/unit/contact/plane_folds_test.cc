#include <birdstrike/contact/plane_folds.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace birdstrike;

namespace
{
  /// What is said of one facet beside the plane, at y > 0: its normal leans by half the `angle` (degrees) between it
  /// and its mirror image, away from the plane where it is positive, as the sides of a roof do.
  std::string refusal(const double angle, const bool is_skin, const bool is_half = true)
  {
    const double        half = 0.5 * angle * std::numbers::pi / 180., s = std::sin(half), c = std::cos(half);
    std::vector<double> position{0.1, 0., 0.02, 0.2, 0., 0.02, 0.2, c, 0.02 - s, 0.1, c, 0.02 - s};
    const std::array<std::uint32_t, 4> nodes{{0, 1, 2, 3}};
    const std::array<std::int32_t, 4>  neighbor{{FacetsView::symmetry_edge, -1, -1, -1}};
    FacetsView                         view;
    view.n_nodes   = 4;
    view.position  = position.data();
    view.n_facets  = 1;
    view.nodes     = &nodes;
    view.neighbor  = &neighbor;
    view.two_sided = !is_skin;
    view.plane     = SymmetryPlane(is_half);
    try
      {
        refuse_folds_on_plane(view);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(PlaneFolds, ARidgeOfASkinIsRefusedWhereTheWholeWouldHaveASharpEdge)
{
  EXPECT_EQ(refusal(0., true), "");
  EXPECT_EQ(refusal(29., true), "");
  const std::string text = refusal(62., true);
  EXPECT_NE(text.find("feature edge of 62 degrees"), std::string::npos) << text;
  EXPECT_NE(text.find("(0.15, 0, 0.02)"), std::string::npos) << text;
  EXPECT_NE(text.find("Case/Symmetry plane"), std::string::npos) << text;
  EXPECT_NE(refusal(31., true), "");
  EXPECT_EQ(refusal(62., true, false), ""); // the whole
}

TEST(PlaneFolds, AGrooveIsRefusedWherePointsOfTheWholeWouldTouchBothSides)
{
  EXPECT_EQ(refusal(-59., true), "");
  EXPECT_NE(refusal(-61., true).find("fold of 61 degrees"), std::string::npos);
}

TEST(PlaneFolds, AFoldedShellHasAGrooveOnEitherSide)
{
  for (const double sign : {-1., 1.})
    {
      EXPECT_EQ(refusal(sign * 59., false), "");
      EXPECT_NE(refusal(sign * 61., false).find("fold of 61 degrees"), std::string::npos);
    }
}
