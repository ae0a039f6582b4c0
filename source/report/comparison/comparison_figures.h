#pragma once

#include "report/comparison/comparison_table.h"
#include "report/comparison/figure.h"

namespace birdstrike
{
  /// The curves of several runs, overlaid, one colour a run: tip deflection, root bending moment, largest root stress,
  /// contact force and impulse (norms), energies; and two sections through the blade side by side: stress along the
  /// root chord when it peaks (face at minus normal full, other face dashed) and deflection of the mid-chord line at
  /// the tip peak, or at the end of a run whose tip never rose. Time 0 is first touch. Figures that no run fills are
  /// left out.
  std::vector<Figure> make_comparison_figures(const std::vector<ComparedRun> &runs);
} // namespace birdstrike
