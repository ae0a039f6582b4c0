#pragma once

#include "report/comparison/figure.h"
#include "report/study/error_fit.h"
#include "report/study/grid_convergence.h"
#include "report/study/refinement.h"
#include "report/study/study_table.h"

#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A quantity on a ladder.
  struct ConvergingRow
  {
    const ComparisonRow *row;
    std::vector<double>  values;  ///< from the finest level on, means over places
    double               scatter; ///< standard deviation of one run among places, of all levels; NaN of one place
    GridConvergence      estimate;

    std::optional<KnownOrderFit> of_known_order; ///< none where no order is known, or a level has no value

    /// Whether on a level it still rises, or is pushed, at the end: it may be no peak then.
    bool is_rising() const;

    /// The same by level, from the finest on: 1 where it does at any place, else 0; empty where it does on none.
    std::vector<double> rising_levels() const;
  };

  /// What the levels of a ladder say about every response of the scene.
  class ConvergenceTable
  {
  public:
    /// `levels` from the coarsest on, as the points of the table, each with `n_places` of the lattice; `orders` of the
    /// method, if they are known.
    ConvergenceTable(Refinement refinement, const std::vector<LadderLevel> &levels, std::size_t n_places,
                     const StudyTable &table, std::optional<OrderRange> orders);

    const std::vector<ConvergingRow> &rows() const;

    std::string as_text() const; ///< the headline: values, order, error bar, and what the ladder does
    std::string as_csv() const;  ///< a row a quantity, all digits, SI units

    /// Each quantity of the headline against h: values, the finest with its bar, Richardson's value at h = 0.
    Figure make_figure() const;

  private:
    Refinement                 refinement;
    std::size_t                n_places;
    std::optional<OrderRange>  known_orders;
    std::vector<double>        sizes; ///< from the finest on
    std::vector<ConvergingRow> all, headline;
  };
} // namespace birdstrike
