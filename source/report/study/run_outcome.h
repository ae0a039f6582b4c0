#pragma once

#include "report/study/study_runs.h"
#include <birdstrike/core/child_process.h>

namespace birdstrike
{
  /// State and exit code of a point's run from what its process left: done, lost, refused, stopped, or to run anew.
  void judge(PointRun &run, const ChildResult &result);
} // namespace birdstrike
