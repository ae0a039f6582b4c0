#pragma once

namespace birdstrike
{
  /// Which half of a velocity-Verlet kick: the first precedes the drift, the second follows it. Works are booked with
  /// the velocity of the adjoining drift (see core/energy_report.h): after the first half, before the second.
  enum class HalfKick
  {
    first,
    second
  };
} // namespace birdstrike
