#include "structure/nodes/nodal_vectors.h"

// A blade that turns with its hub: how it starts, and what somebody on the hub sees.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::turn_with_hub()
  {
    HubMotion  hub        = rotor.motion(0.);
    const auto set_motion = [this](const HubMotion &of_hub) {
      double *velocity = vectors->velocity.begin();
      for (std::size_t n = 0; n < n_nodes; ++n)
        {
          const Point3 v = of_hub.velocity(Point3(vectors->position.begin() + 3 * n)), w = of_hub.angular_velocity();
          for (unsigned int c = 0; c < n_unknowns; ++c)
            velocity[n_unknowns * n + c] = c < 3 ? v[c] : w[c - 3];
        }
    };
    hub.speed = 1.;
    set_motion(hub);
    moment_of_inertia = 2. * kinetic(0., 0.)[0];
    set_motion(rotor.motion(0.));
  }

  template <unsigned int n_unknowns>
  auto NodalMechanics<n_unknowns>::in_turning_frame() const -> const InTurningFrame &
  {
    const double *const f = support_forces(), *const u = displacements();
    const Turn turn = rotor.turn(time);
    for (const std::uint32_t n : reported_nodes)
      {
        const Point3 reference(vectors->reference.begin() + 3 * n);
        // of u less that of the hub, whose difference is small
        const Point3 moved(Point3(u + n_unknowns * n) - turn.displacement(reference));
        Point3::Map(&turned_back.displacement[n_unknowns * n]) = turn.back(moved);
        Point3::Map(&turned_back.position[3 * n]) =
          reference + Point3(turned_back.displacement.data() + n_unknowns * n);
        for (unsigned int c = 0; c < n_unknowns; c += 3)
          Point3::Map(&turned_back.force[n_unknowns * n + c]) = turn.back(Point3(f + n_unknowns * n + c));
        if constexpr (n_unknowns == 6)
          Point3::Map(&turned_back.displacement[6 * n + 3]) =
            turn.back(Point3(Point3(u + 6 * n + 3) - turn.rotation()));
      }
    return turned_back;
  }

  template void NodalMechanics<3>::turn_with_hub();
  template void NodalMechanics<6>::turn_with_hub();
  template auto NodalMechanics<3>::in_turning_frame() const -> const InTurningFrame &;
  template auto NodalMechanics<6>::in_turning_frame() const -> const InTurningFrame &;
} // namespace birdstrike
