#pragma once

#include <birdstrike/core/numerical_failure.h>

#include <utility>

namespace birdstrike
{
  /// Of an element that is turned inside out (`size`, of the unit, not positive), or whose force is no number.
  /// `can_erode`: its metal fails, so that it could go instead.
  inline NumericalFailure make_element_failure(const std::string &kind, const EntityPlace &where,
                                               const std::string &quantity, const double size, const char *unit,
                                               const bool can_erode)
  {
    FailureFacts facts{size > 0. ? "The force of a " + kind + " is not finite" : "A " + kind + " is turned inside out",
                       quantity,
                       size,
                       unit,
                       0.,
                       "allowed: more than"};
    facts.where  = where;
    facts.advice = std::string("The step was too large or the element collapsed: reduce Time/Step scale") +
                   (can_erode ? ", or let it erode (Material/Smallest step of its metal)." : ".");
    return NumericalFailure(std::move(facts));
  }
} // namespace birdstrike
