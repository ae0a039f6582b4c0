#pragma once

#include <string>

namespace birdstrike
{
  struct CaseParameters;
  struct Scene;

  /// What a case would compute, as a table: parts with mass, energy and momentum, first step and who limits it,
  /// expected steps and run time, memory and bytes on disk. Takes no step and writes nothing; the scene's rates are
  /// evaluated, its state does not change.
  std::string explain(const CaseParameters &parameters, Scene &scene);
} // namespace birdstrike
