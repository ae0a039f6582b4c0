#pragma once

#include <array>

namespace birdstrike
{
  class Bird;
  class Blade;
  struct BirdParameters;

  /// How bird and blade met.
  struct FirstTouch
  {
    double flight_time   = 0.; ///< s, skipped before first touch
    double closing_speed = 0.; ///< m/s, of the bird relative to the blade where it aims

    std::array<double, 3> closing_velocity{}; ///< likewise
    std::array<double, 3> moved_by{};         ///< m, of the aim: what spin and steady loads have done to its place

    double share_in_the_way = 0.; ///< of the bird's mass, by straight paths from there (contact/mass_in_the_way.h)
  };

  /// Whether an edge of the blade cuts a bird of which this share of the mass is in the way: more than grazes or
  /// passes.
  constexpr bool is_cut_by_edge(const double share_in_the_way)
  {
    return share_in_the_way > 0.02 && share_in_the_way < 0.98;
  }

  /// Moves the bird in closed form to where its first particle touches the blade as it lies at the start, along its
  /// velocity relative to the blade's node nearest to the aim point: a blade that moves as a whole is met as in its own
  /// frame. Without a stand-off of the user's, a bird that would have touched before its automatic start (at grazing
  /// incidence, wider than the blade) is taken back to that touch.
  ///
  /// Of a blade that turns with its hub the velocity is that of the rotation where the bird aims, and its approach is
  /// taken as straight in that frame; the bird then comes through the aim point as the blade sees it, whose place in
  /// the mesh is that of the first touch.
  ///
  /// An aim by shares of span and chord (BirdParameters::aimed_place) has gone with that place of the surface, as spin
  /// and steady loads moved it.
  ///
  /// A bird that arrives later meets the blade as it lies at the start then, of a blade that turns after as much of its
  /// rotation, and is taken back along its path by that time.
  ///
  /// @throws InputError for a bird that misses the blade or starts inside it.
  FirstTouch place_at_first_touch(Bird &bird, Blade &blade, const BirdParameters &parameters);
} // namespace birdstrike
