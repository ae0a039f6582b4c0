#include "structure/nodes/nodal_vectors.h"

// A blade that turns with its hub: how it starts, and what somebody on the hub sees.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::turn_with_hub()
  {
    double *velocity = vectors->velocity.begin();
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        const Point3 v = rotor.velocity(Point3(vectors->position.begin() + 3 * n)), w = rotor.angular_velocity();
        for (unsigned int c = 0; c < n_unknowns; ++c)
          velocity[n_unknowns * n + c] = c < 3 ? v[c] : w[c - 3];
      }
    booked.driven = kinetic(0., 0.)[0];
  }

  template <unsigned int n_unknowns>
  auto NodalMechanics<n_unknowns>::in_turning_frame() const -> const InTurningFrame &
  {
    const double *const f = element_forces(), *const u = displacements();
    turned_back.position.resize(3 * n_nodes);
    turned_back.displacement.resize(n_unknowns * n_nodes);
    turned_back.force.resize(n_unknowns * n_nodes);
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        const Point3 reference(vectors->reference.begin() + 3 * n);
        // of u less that of the hub, whose difference is small
        const Point3 moved(Point3(u + n_unknowns * n) - rotor.displacement(reference, time));
        Point3::Map(&turned_back.displacement[n_unknowns * n]) = rotor.turned_back(moved, time);
        Point3::Map(&turned_back.position[3 * n]) =
          reference + Point3(turned_back.displacement.data() + n_unknowns * n);
        for (unsigned int c = 0; c < n_unknowns; c += 3)
          Point3::Map(&turned_back.force[n_unknowns * n + c]) = rotor.turned_back(Point3(f + n_unknowns * n + c), time);
        if constexpr (n_unknowns == 6)
          Point3::Map(&turned_back.displacement[6 * n + 3]) =
            rotor.turned_back(Point3(Point3(u + 6 * n + 3) - time * rotor.angular_velocity()), time);
      }
    return turned_back;
  }

  template void NodalMechanics<3>::turn_with_hub();
  template void NodalMechanics<6>::turn_with_hub();
  template auto NodalMechanics<3>::in_turning_frame() const -> const InTurningFrame &;
  template auto NodalMechanics<6>::in_turning_frame() const -> const InTurningFrame &;
} // namespace birdstrike
