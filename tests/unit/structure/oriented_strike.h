#pragma once

#include "oriented_file.h"

#include <birdstrike/structure/reports.h>

namespace birdstrike::test
{
  /// Quadrilaterals about +z or -z, beginning at any corner.
  std::vector<unsigned int> quadrilateral(bool is_reversed, unsigned int first);

  Listing always(const std::vector<unsigned int> &order);
  /// Every cell another way, cells and nodes shuffled.
  Listing mixed(const std::vector<std::vector<unsigned int>> &orders, unsigned int seed);
  Listing mixed_shell(unsigned int seed);

  struct Reports
  {
    TipDeflection       tip;
    RootSectionReport   root;
    std::vector<double> line; ///< m, deflection of the mid-chord line

    std::vector<double> figures() const;
    void                swap_edges(); ///< what was the leading edge is the trailing one
  };

  /// What a blade reports that a bird along its normal, or against it, has set moving that way, faster towards the edge
  /// 13. `turned`: how the blade stands in space. Forces of the root are means over the time: waves differ.
  Reports strike(BladeParameters p, int side, const Matrix3<double> &turned = Matrix3<double>::Identity());

  /// Sums in another order of nodes and cells: round-off of 150 steps, relative to the largest of its kind.
  void expect_same(const Reports &a, const Reports &b, double tolerance, const std::string &what);
} // namespace birdstrike::test
