#pragma once

#include <birdstrike/core/warning.h>

namespace birdstrike
{
  struct RunView;

  /// The code of contact that still acts at the end of a run, by more than 1 % of the filtered force's peak.
  constexpr auto unfinished_contact = "contact/unfinished";

  /// What a run that has ended should not be believed in without a look: errors of the balance, peaks that are only the
  /// end of the run, metal strained beyond what breaks it in tension, elements that have failed in part, contact that
  /// still acts. Codes "balance/...", "peak/...", "metal/...", "contact/...".
  Warnings find_run_warnings(const RunView &run);
} // namespace birdstrike
