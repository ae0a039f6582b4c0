#pragma once

#include <birdstrike/report/text.h>

namespace birdstrike
{
  struct RunView;
  struct Summary;

  /// What a run came to, as a table.
  ToldText closing_report(const RunView &run, const Summary &summary);
} // namespace birdstrike
