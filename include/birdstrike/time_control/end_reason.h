#pragma once

#include <birdstrike/core/named_choices.h>

namespace birdstrike
{
  /// Why a run has ended; the names are those of summary.json, "end/reason".
  enum class EndReason
  {
    none, ///< it has not
    end_time,
    signal,    ///< ended from outside: the results are not those of its parameters
    wall_time, ///< its time was up on the wall's clock, likewise
    tip_peak
  };

  inline const NamedChoices<EndReason> &end_reasons()
  {
    static const NamedChoices<EndReason> names{{"", EndReason::none},
                                               {"end time reached", EndReason::end_time},
                                               {"stopped by a signal", EndReason::signal},
                                               {"maximum wall time reached", EndReason::wall_time},
                                               {"tip peak passed", EndReason::tip_peak}};
    return names;
  }
} // namespace birdstrike
