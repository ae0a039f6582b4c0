#pragma once

#include "report/comparison/figure.h"
#include "report/study/study_table.h"

#include <vector>

namespace birdstrike
{
  /// The headline of a study over what was varied, a panel a quantity: curves ("responses") over the one entry, over
  /// the first of two for each value of the second, or over the number of the pair; and of two entries a map of cells
  /// ("maps"). Points without a result are gaps. Nothing for more than two entries that are varied each with each.
  std::vector<Figure> make_study_figures(const StudyPlan &plan, const std::vector<PointRun> &runs,
                                         const StudyTable &table);

  /// How values of an SI unit are shown: m in mm, Pa in MPa, N in kN, s in ms.
  FigureAxis make_axis(const std::string &quantity, const std::string &unit);
} // namespace birdstrike
