#include "structure/elements/shell/one_point_loop.h"

#include "structure/elements/shell/step_bound.h"
#include <birdstrike/core/simd/flatten.h>

namespace birdstrike
{
  // Apart, so that the elastic path has the registers for itself.
  BIRDSTRIKE_FLATTEN [[gnu::noinline]] ShellWork<Lanes>
  ShellGroup::update_points(const std::size_t b, const ShellVector<Lanes> &strain, const Lanes &area, const double dt)
  {
    if (points[b].empty())
      promote(b);
    if (erosion)
      return update_failing_points(b, strain, area, dt);
    return law.update_plastic(strain, dt, stress[b], points[b].data());
  }

  // One body, although long: all of it works on the same registers (BIRDSTRIKE_FLATTEN).
  template <bool physical>
  BIRDSTRIKE_FLATTEN void ShellGroup::update_batch(const std::size_t b, const double dt, ElementChunk &chunk)
  {
    Batch              &batch = batches[b];
    ShellStress<Lanes> &state = stress[b];
    const BatchNodes    nodes(place.records->position, batch.record);

    const auto x        = ShellModes<Lanes>::of_corners(nodes.position);
    const auto u        = ShellModes<Lanes>::of_corners(nodes.increment);
    const auto midpoint = compute_midpoint(x, u, nodes.midpoint_normal);
    const auto strain =
      compute_strain_increments<physical>(midpoint, state.thickness, section.hourglass_coefficient, u, nodes);
    // of the undeformed volume over the thickness, both of before the step; by itself: `midpoint` stays in registers
    Lanes area = midpoint.area * law.contraction(state) * (1. - 0.5 * (strain.membrane[0] + strain.membrane[1]));
    ShellWork<Lanes> work;
    if (!points[b].empty() || !law.update_elastic(strain, initial_yield, state, work))
      work = update_points(b, strain, area, dt);

    const auto  end         = ShellGeometry<Lanes>::of_modes(x, nodes.normal);
    const Lanes contraction = law.contraction(state);
    batch.bound =
      compute_eigenvalue_bound<false>(end, state.thickness, batch.inverse_mass, batch.radius2, law, contraction);
    chunk.bound = max(chunk.bound, Lanes(batch.owned * batch.bound));
    Corners force[2];
    compute_corner_forces<physical>(end, state, contraction, section.hourglass_coefficient, nodes.normal, force);
    store_corner_forces(force, batch.corner, place.corner_force);

    area *= batch.owned;
    chunk.plastic += area * work.plastic;
    chunk.hourglass += area * work.hourglass;

    if (!all(is_finite(force, batch.bound) && (end.area > Lanes(0.)) && looks_along(nodes.normal, end.e3)))
      report_failure(b);
  }

  void ShellGroup::update_chunk(const std::size_t c, const double dt)
  {
    const std::size_t end   = std::min(batches.size(), (c + 1) * ElementBlocks::batches_per_chunk);
    ElementChunk     &chunk = chunks[c];
    chunk.bound             = Lanes(0.);
    const auto for_batches  = [&](const auto &update) {
      for (std::size_t b = c * ElementBlocks::batches_per_chunk; b < end; ++b)
        update(b);
      if (can_collapse())
        take_collapsed(c);
    };
    switch (section.formulation)
      {
      case ShellFormulation::one_point_physical:
        return laminate ? for_batches([&](const std::size_t b) { update_laminate<true>(b, dt, chunk); })
                        : for_batches([&](const std::size_t b) { update_batch<true>(b, dt, chunk); });
      case ShellFormulation::belytschko_tsay:
        return laminate ? for_batches([&](const std::size_t b) { update_laminate<false>(b, dt, chunk); })
                        : for_batches([&](const std::size_t b) { update_batch<false>(b, dt, chunk); });
      case ShellFormulation::fully_integrated:
        return laminate ? for_batches([&](const std::size_t b) { update_fully_integrated_laminate(b, dt, chunk); })
                        : for_batches([&](const std::size_t b) { update_fully_integrated(b, dt, chunk); });
      }
  }
} // namespace birdstrike
