#pragma once

namespace birdstrike
{
  struct CaseParameters;
  struct Scene;

  /// Throws InputError, naming the entry, for a run whose results would not fit, known in closed form before its
  /// first step (steps without end are refused by the first plan, the scene's own memory before it is built,
  /// io/scene_size.h):
  ///
  ///   rows      8 bytes for each of 50 columns at least, kept until results.h5 is written, > memory that is there
  ///   fields    bytes before compression > 20 times what is free on the disk
  void require_bounded_run(const CaseParameters &parameters, const Scene &scene);
} // namespace birdstrike
