#include "structure/nodes/nodal_vectors.h"

/// What the nodes' next step depends on. Positions, and what mass scaling makes of forces, follow from it; the
/// increment of displacement is nothing between steps.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::archive(Archive &archive)
  {
    const auto group = archive.group("motion");
    archive("time", time);
    archive("internal half step", internal_half);
    archive("contact half steps", contact_half, left_half);
    archive("staggered half step", staggered_half);
    archive.entities("nodes", n_nodes, [this](Archive::Row &row, const std::size_t n) {
      const auto unknowns = [&](const char *name, auto &vector) {
        row(name, std::span<double, n_unknowns>(vector.begin() + n_unknowns * n, n_unknowns));
      };
      unknowns("displacement", vectors->displacement);
      unknowns("velocity", vectors->velocity);
      unknowns("internal force", vectors->force);
      unknowns("contact force", vectors->contact);
      unknowns("contact impulse", vectors->received);
      if (loads.is_active())
        unknowns("load", vectors->external);
    });
    archive.records("added forces", added, [](Archive::Row &row, NodalForce &one) {
      row("node", one.node);
      row("force", one.force);
    });
    birdstrike::archive(archive, "energy", booked);
    birdstrike::archive(archive, "momentum", impulses);
    if (!archive.is_reading())
      return;
    for (std::size_t n = 0; n < n_nodes; ++n)
      for (unsigned int d = 0; d < 3; ++d)
        vectors->position.begin()[3 * n + d] =
          vectors->reference.begin()[3 * n + d] + vectors->displacement.begin()[n_unknowns * n + d];
    if (scaled)
      {
        scaled->update_forces(vectors->force.begin(), vectors->external.begin());
        scaled->clear_contact();
        scaled->update_contact(vectors->contact.begin());
      }
  }

  template class NodalMechanics<3>;
  template class NodalMechanics<6>;
} // namespace birdstrike
