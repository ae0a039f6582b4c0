#pragma once

#include "structure/elements/shell/shell_section.h"
#include "structure/elements/solid/solid_section.h"
#include <birdstrike/core/prices.h>

namespace birdstrike
{
  /// Of an element and a step, while elastic and with points that yield, ns.
  struct Price
  {
    double elastic, yielding;
  };

  /// The table's prices are those of five points through the thickness; what yields grows with their number.
  inline Price with_points(const double elastic, const double with_five, const unsigned int n_points)
  {
    return {elastic, elastic + (with_five - elastic) / 5. * n_points};
  }

  inline Price price_of(const ShellSection &section)
  {
    if (section.laminate)
      {
        // measured beside those of the table, one core of the same kind
        const bool   is_full  = section.formulation == ShellFormulation::fully_integrated;
        const double sections = is_full ? 4. : 1., of_ply = section.can_fail() ? 2.2 : 0.;
        const double price = (is_full ? prices::fully_integrated_shell + 18. : prices::physical_shell + 11.) +
                             sections * of_ply * static_cast<double>(section.laminate->layers.size());
        return {price, price};
      }
    switch (section.formulation)
      {
      case ShellFormulation::belytschko_tsay:
        return with_points(prices::belytschko_tsay_shell, prices::belytschko_tsay_shell_yielding, section.n_points);
      case ShellFormulation::fully_integrated:
        return with_points(prices::fully_integrated_shell, prices::fully_integrated_shell_yielding, section.n_points);
      default:
        return with_points(prices::physical_shell, prices::physical_shell_yielding, section.n_points);
      }
  }

  inline Price price_of(const SolidSection &section)
  {
    switch (section.formulation)
      {
      case SolidFormulation::b_bar:
        return {prices::b_bar_brick, prices::b_bar_brick_yielding};
      case SolidFormulation::solid_shell:
        return with_points(prices::solid_shell, prices::solid_shell_yielding, section.n_points);
      default:
        return {prices::one_point_brick, prices::one_point_brick_yielding};
      }
  }
} // namespace birdstrike
