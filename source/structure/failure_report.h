#pragma once

#include "structure/probes/sections.h"
#include <birdstrike/structure/reports.h>

#include <vector>

namespace birdstrike
{
  /// What has failed of a blade of shells or bricks; `mass` (kg) is that of its nodes.
  template <class Elements, class Root>
  FailureReport make_failure_report(const Elements &elements, const Root &root, const TipRow &tip,
                                    const std::vector<double> &mass, const bool can_fail)
  {
    FailureReport report;
    report.can_fail   = can_fail;
    report.n_elements = elements.n_failed();
    if (report.n_elements == 0)
      return report;
    report.n_collapsed = elements.n_collapsed();
    report.n_at_root   = root.count_failed(elements);
    report.mass        = elements.failed_mass();
    for (std::size_t n = 0; n < mass.size(); ++n)
      if (elements.is_free(n))
        {
          ++report.n_free_nodes;
          report.free_mass += mass[n];
        }
    report.has_lost_tip = tip.has_any([&](const std::uint32_t n) { return elements.is_free(n); });
    return report;
  }
} // namespace birdstrike
