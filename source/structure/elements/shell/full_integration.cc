#include "structure/elements/shell/full_integration_loop.h"
#include "structure/elements/shell/step_bound.h"
#include <birdstrike/core/simd/flatten.h>

#include <algorithm>

namespace birdstrike
{
  using full_integration::PlaneGeometry;
  constexpr int n_points = full_integration::n_points;

  // Apart, so that the elastic path has the registers for itself.
  BIRDSTRIKE_FLATTEN [[gnu::noinline]] Lanes
  ShellGroup::update_section(const std::size_t k, const SectionVector<Lanes> &strain, const double dt)
  {
    if (points[k].empty())
      promote(k);
    if (erosion)
      return update_failing_section(k, strain, dt);
    return law.update_plastic(strain, dt, sections[k], points[k].data());
  }

  // One body and `flatten`, as in the loop of the one-point elements (loops.cc). Strains and resultants of the
  // points lie in memory between the three passes, which costs less than the geometry of the end held beside that of
  // the midpoint.
  BIRDSTRIKE_FLATTEN void ShellGroup::update_fully_integrated(const std::size_t b, const double dt, ElementChunk &chunk)
  {
    Batch           &batch = batches[b];
    const BatchNodes nodes(place.records->position, batch.record);
    const double     poisson = law.elasticity.poisson;

    const auto           x        = ShellModes<Lanes>::of_corners(nodes.position);
    const auto           u        = ShellModes<Lanes>::of_corners(nodes.increment);
    const auto           midpoint = compute_midpoint(x, u, nodes.midpoint_normal);
    PlaneGeometry<Lanes> plane(midpoint, poisson);
    SectionVector<Lanes> section_of_point[n_points];
    full_integration::compute_strain_increments(plane, midpoint, u, nodes, section_of_point);

    SectionVector<Lanes> strain[n_points]; // kept where something may fail
    if (erosion)
      std::copy(section_of_point, section_of_point + n_points, strain);
    Lanes thickness = 0., contraction = 0., plastic = 0.;
    for (int k = 0; k < n_points; ++k)
      {
        const std::size_t     s     = n_points * b + k;
        SectionStress<Lanes> &state = sections[s];
        if (!points[s].empty() || !law.update_elastic(section_of_point[k], initial_yield, state))
          {
            const auto &e    = section_of_point[k].membrane;
            const Lanes area = plane.point[k].area * (1. - 0.5 * (e[0] + e[1])) * law.contraction(state);
            plastic += area * update_section(s, section_of_point[k], dt);
          }
        thickness            = max(thickness, state.thickness);
        const Lanes of_point = law.contraction(state);
        contraction          = max(contraction, of_point);
        section_of_point[k]  = compute_resultants(state, of_point);
      }
    if (erosion && has_new_failed[b] != 0)
      {
        Lanes area[n_points];
        for (int k = 0; k < n_points; ++k)
          area[k] = plane.point[k].area * law.contraction(sections[n_points * b + k]);
        release_sections(b, strain, area);
        for (int k = 0; k < n_points; ++k)
          section_of_point[k] =
            compute_resultants(sections[n_points * b + k], law.contraction(sections[n_points * b + k]));
      }
    chunk.plastic += batch.owned * plastic;

    const auto end = ShellGeometry<Lanes>::of_modes(x, nodes.normal);
    plane          = PlaneGeometry<Lanes>(end, poisson);
    batch.bound = compute_eigenvalue_bound<true>(end, thickness, batch.inverse_mass, batch.radius2, law, contraction);
    chunk.bound = max(chunk.bound, Lanes(batch.owned * batch.bound));
    Corners force[2];
    full_integration::compute_corner_forces(plane, end, section_of_point, force);
    store_corner_forces(force, batch.corner, place.corner_force);
    if (!full_integration::is_sound(plane, end, nodes.normal, force, batch.bound))
      report_failure(b);
  }
} // namespace birdstrike
