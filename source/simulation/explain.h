#pragma once

#include <birdstrike/report/text.h>

namespace birdstrike
{
  struct CaseParameters;
  struct Scene;

  /// What a case would compute, as a table, brief for the screen of a run: parts with mass, energy and momentum, first
  /// step and who limits it, expected steps and run time, memory and bytes on disk. Looks only: a run that was
  /// explained first is the same.
  ToldText explain(const CaseParameters &parameters, const Scene &scene);

  /// Expected run time on one core (s), from the start of the program to its end (run_forecast.cc).
  double compute_run_time(const CaseParameters &parameters, const Scene &scene);

  /// Most memory (bytes) that a run of this scene holds: what the process holds with the scene built, and what steps
  /// and output take besides. 0 where the system does not say.
  double compute_run_memory(const CaseParameters &parameters, const Scene &scene);

  /// Bytes of all field files before compression, at most.
  double compute_field_bytes(const CaseParameters &parameters, const Scene &scene);
} // namespace birdstrike
