#include "structure/elements/shell/group.h"
#include "structure/elements/solid/group.h"

#include <algorithm>

/// What the next step of elements depends on, whatever their kind. Bounds of collapse, masses, their scale and volumes
/// at rest follow from the undeformed mesh; which elements have failed tells what nodes have left.
namespace birdstrike
{
  template <class Group>
  void Elements<Group>::archive(Archive &archive, const double *position)
  {
    const auto of_blade = archive.group("elements");
    for (std::size_t i = 0; i < groups.size(); ++i)
      {
        const auto of_section = archive.group("section " + std::to_string(i));
        if (groups[i].erosion)
          archive_failed(archive, groups[i]);
        archive_elements(archive, groups[i]);
        groups[i].archive(archive);
      }
    archive.entities("nodes", n_nodes, [&](Archive::Row &row, const std::size_t n) {
      row("force", std::span<double, n_unknowns>(node_force[n].value, n_unknowns));
      nodes.archive(row, n);
      std::copy(position + 3 * n, position + 3 * n + 3, nodes.records[n].position);
    });
    if constexpr (requires { nodes.archive_folds(archive, position); })
      nodes.archive_folds(archive, position);
    if constexpr (requires(Group & group) { group.take_up_positions(); })
      if (archive.is_reading())
        for (Group &group : groups)
          group.take_up_positions();
    archive.entities("work of nodes", node_work.size(),
                     [&](Archive::Row &row, const std::size_t chunk) { row("work", node_work[chunk].value); });
  }

  template <class Group>
  void Elements<Group>::archive_failed(Archive &archive, Group &group)
  {
    Erosion &erosion = *group.erosion;
    archive.entities("failure", group.ids(1), [&](Archive::Row &row, const std::size_t e) {
      bool failed = erosion.is_failed(e);
      row("has failed", failed);
      row("eroded energy", erosion.batches[e / n_lanes].energy[e % n_lanes]);
      if (!archive.is_reading() || !failed)
        return;
      for (std::size_t slot = e; slot < group.batches.size() * n_lanes && group.element_of(slot) == e; ++slot)
        group.take_out(slot / n_lanes, slot % n_lanes);
      for (const auto n : group.place.cells[e])
        --n_left[n];
    });
    archive("failed", erosion.n_failed, erosion.n_collapsed);
    archive("failed mass", erosion.mass);
  }

  template <class Group>
  void Elements<Group>::archive_elements(Archive &archive, Group &group)
  {
    constexpr std::size_t per_chunk = ElementBlocks::batches_per_chunk * n_lanes;
    if (archive.is_reading())
      std::fill(group.chunks.begin(), group.chunks.end(), ElementChunk());
    archive.entities("elements", group.ids(1), [&](Archive::Row &row, const std::size_t e) {
      Lanes &bound = group.batches[e / n_lanes].bound;
      row("bound", group.lane_of(bound, e));
      if (archive.is_reading())
        group.chunks[e / per_chunk].bound = max(group.chunks[e / per_chunk].bound, bound);
    });
    archive.entities("dissipation", group.ids(1), [&](Archive::Row &row, const std::size_t e) {
      ElementChunk &chunk = group.chunks[e / per_chunk];
      const auto    share = [&](const char *name, Lanes &sum) {
        double value = e % per_chunk < n_lanes ? lane(sum, e % n_lanes) : 0.; // with the first of its lane
        row(name, value);
        if (archive.is_reading())
          sum[e % n_lanes] += value;
      };
      share("plastic work", chunk.plastic);
      share("hourglass energy", chunk.hourglass);
      share("viscous energy", chunk.viscous);
    });
  }

  template void Elements<ShellGroup>::archive(Archive &, const double *);
  template void Elements<SolidGroup>::archive(Archive &, const double *);
} // namespace birdstrike
