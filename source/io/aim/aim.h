#pragma once

#include <birdstrike/structure/parameters.h>

#include <optional>
#include <string>

namespace birdstrike
{
  struct CaseParameters;

  /// Makes velocity, aim point and slice of what a person gives instead (Bird/Speed with Angle to surface or Flight
  /// direction; Aim span and chord fraction; Slice/Number of blades: RowSlice), writes them into their entries, and
  /// sets `aimed_surface` where the blade has one: for a built-in part always, of a file only where it is asked for.
  ///
  /// With n the normal and t the chord made tangent at the aim point, both unit, a bird of speed v and angle a flies
  /// with v (n sin a + t cos a).
  ///
  /// What is given in both ways must agree: speeds and directions within a thousandth, angles within 0.05 degrees, aim
  /// points within a thousandth of the blade's chord, planes of a slice within a thousandth of its thickness; then
  /// Velocity, Aim point, Slice/Normal and Between are what is used. Throws InputError,
  /// naming both entries, where they do not, for half an alternative, and for a blade that has no such surface.
  void resolve_aim(CaseParameters &parameters);

  /// Where the first bird aims and how it flies, for the signs of a blade that is computed without it. A bird whose
  /// slice cannot be cut (of a blade at rest there is none before it) flies as a whole. Nothing without a bird, and
  /// for one that cannot be placed at all; `why_unknown` then says why, after which no error is raised.
  std::optional<BladeParameters::StrikingBird> find_struck_side(const CaseParameters &parameters,
                                                                std::string          &why_unknown);
} // namespace birdstrike
