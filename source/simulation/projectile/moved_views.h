#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>
#include <birdstrike/structure/rotor.h>

#include <array>
#include <vector>

/// What bird and blade will be some time later, and what is said of birds that do not meet it.
namespace birdstrike
{
  /// Gap in particle spacings that is left before the first touch: on the touch itself round-off would say which of
  /// the particles that come at once push in the first step.
  constexpr double clearance = 1e-6;

  /// The surface of a blade as its hub will have turned it after some time.
  struct TurnedSurface
  {
    std::vector<double> position, velocity; // [n_nodes][3]
    FacetsView          view;

    TurnedSurface(const FacetsView &facets, const Rotor &rotor, const double time)
      : position(3 * facets.n_nodes), velocity(3 * facets.n_nodes), view(facets)
    {
      const Turn      turn = rotor.turn(time);
      const HubMotion hub  = rotor.motion(time);
      for (std::size_t n = 0; n < facets.n_nodes; ++n)
        {
          const Point3 x = turn.carried(Point3(facets.position + 3 * n)), v = hub.velocity(x);
          for (unsigned int d = 0; d < 3; ++d)
            {
              position[3 * n + d] = x[d];
              velocity[3 * n + d] = v[d];
            }
        }
      view.position        = position.data();
      view.velocity        = velocity.data();
      view.velocity_stride = 3;
    }
  };

  /// The points moved by `shift`, all with one velocity, and a view of them.
  struct MovedPoints
  {
    std::array<std::vector<double>, 3> position, velocity;
    PointsView                         view;

    MovedPoints(const PointsView &points, const Point3 &shift, const Point3 &common_velocity) : view(points)
    {
      for (int d = 0; d < 3; ++d)
        {
          position[d].assign(points.position[d], points.position[d] + points.n);
          for (double &x : position[d])
            x += shift[d];
          velocity[d].assign(points.n, common_velocity[d]);
          view.position[d] = position[d].data();
          view.velocity[d] = velocity[d].data();
        }
    }
  };

  /// Velocity (m/s) of the surface where it is closest to the aim point.
  Point3 find_velocity_at_aim(const Point3 &aim, const FacetsView &facets);

  [[noreturn]] void refuse_overlap(const Overlap &overlap, const BirdParameters &parameters);
  [[noreturn]] void refuse_miss(const FacetsView &facets, const BirdParameters &parameters);
} // namespace birdstrike
