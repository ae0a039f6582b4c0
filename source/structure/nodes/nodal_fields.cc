#include "structure/nodes/nodal_vectors.h"
#include "structure/nodes/scaled_nodes.h"

namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::add_fields(std::vector<Field> &fields) const
  {
    const auto add = [&](const char *name, const char *unit, const double *values) {
      Field field{name, unit, false, 3, {}};
      field.values.reserve(3 * n_nodes);
      for (std::size_t n = 0; n < n_nodes; ++n)
        field.values.insert(field.values.end(), values + n_unknowns * n, values + n_unknowns * n + 3);
      fields.push_back(std::move(field));
    };
    add("displacement", "m", vectors->displacement.begin());
    add("velocity", "m/s", vectors->velocity.begin());
    // without damping; 0 where held or driven
    std::vector<double> acceleration(n_unknowns * n_nodes);
    const double *const f = scaled ? scaled->forces() : vectors->force.begin();
    const double *const c = scaled ? scaled->contact() : vectors->contact.begin();
    for (std::size_t k = 0; k < acceleration.size(); ++k)
      acceleration[k] = (f[k] + c[k] + vectors->external.begin()[k]) * vectors->inverse_mass.begin()[k];
    add("acceleration", "m/s^2", acceleration.data());
    add("contact_force", "N", vectors->contact.begin());
    std::vector<double> impulse(n_unknowns * n_nodes); // with what is in transit, as momenta() counts it
    for (std::size_t k = 0; k < impulse.size(); ++k)
      impulse[k] = vectors->received.begin()[k] + in_transit * vectors->contact.begin()[k];
    add("contact_impulse", "N s", impulse.data());
  }

  template void NodalMechanics<3>::add_fields(std::vector<Field> &) const;
  template void NodalMechanics<6>::add_fields(std::vector<Field> &) const;
} // namespace birdstrike
