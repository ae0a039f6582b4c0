#include "structure/elements/shell/one_point_loop.h"

#include "structure/elements/shell/full_integration_loop.h"
#include "structure/elements/shell/laminate/bound.h"
#include <birdstrike/core/simd/flatten.h>

// The loops over batches of laminated shells: as those of metals (loops.cc, full_integration.cc), with the section's
// law in the laminate's own axes.
namespace birdstrike
{
  using full_integration::PlaneGeometry;
  constexpr int n_points = full_integration::n_points;

  namespace
  {
    /// Work (J/m^2) of one step on the stabilisation, whose moduli are `carries` of those at rest, after `before` of
    /// them.
    [[gnu::always_inline]] inline Lanes update_stabilisation(const LaminateElement<Lanes> &of, const Lanes &before,
                                                             const Lanes &carries, const ShellVector<Lanes> &e,
                                                             ShellStress<Lanes> &s)
    {
      const Lanes half_t = 0.5 * s.thickness, ratio = carries / max(before, Lanes(1e-30));
      Lanes       in_plane = 0., bent = 0.; // sums of (old + new stress) * strain
      const auto  update = [&](Lanes &sum, Lanes &stress, const Lanes &strain, const Lanes &increment) {
        const Lanes old = stress;
        stress          = ratio * old + carries * increment;
        sum += (old + stress) * strain;
      };
      for (int c = 0; c < 2; ++c)
        {
          const Lanes membrane = e.linear_membrane[c], bending = half_t * e.linear_curvature[c];
          update(in_plane, s.linear_membrane[c], e.linear_membrane[c],
                 Lanes(of.membrane[c] * membrane + of.coupling[c] * bending));
          update(bent, s.linear_curvature[c], e.linear_curvature[c],
                 Lanes(3. * (of.coupling[c] * membrane + of.bending[c] * bending)));
          update(in_plane, s.linear_shear[c], e.linear_shear[c], Lanes(of.shear[c] * e.linear_shear[c]));
        }
      return (1. / 6.) * s.thickness * (in_plane + (1. / 6.) * s.thickness * bent);
    }

    /// Volume at rest that an area at the middle of a step stands for.
    [[gnu::always_inline]] inline Lanes volume_of(const Lanes &area, const SectionVector<Lanes> &e,
                                                  const LaminateState<Lanes> &before, const Lanes &thickness)
    {
      return area * laminate_contraction(before) * (1. - 0.5 * (e.membrane[0] + e.membrane[1])) * thickness;
    }
  } // namespace

  template <bool physical>
  BIRDSTRIKE_FLATTEN void ShellGroup::update_laminate(const std::size_t b, const double dt, ElementChunk &chunk)
  {
    Batch                  &batch    = batches[b];
    ShellStress<Lanes>     &section_ = stress[b];
    LaminateState<Lanes>   &state    = laminate->states[b];
    LaminateElement<Lanes> &element  = laminate->elements[b];
    const BatchNodes        nodes(place.records->position, batch.record);

    const auto x        = ShellModes<Lanes>::of_corners(nodes.position);
    const auto u        = ShellModes<Lanes>::of_corners(nodes.increment);
    const auto midpoint = compute_midpoint(x, u, nodes.midpoint_normal);
    const auto strain =
      compute_strain_increments<physical>(midpoint, section_.thickness, section.hourglass_coefficient, u, nodes);
    const Lanes volume = volume_of(midpoint.area, strain, state, section_.thickness), before = laminate->carries[b];
    const auto  old = state;
    LaminateAxes<Lanes>(midpoint, element).add(strain, 0.5 * section_.thickness, state.strain);
    if (erosion)
      update_failing_plies(b, &old, &volume, dt);
    else
      update_laminate_stress(*laminate->law, state);
    const Lanes hourglass = update_stabilisation(element, before, laminate->carries[b], strain, section_);

    const auto                end = ShellGeometry<Lanes>::of_modes(x, nodes.normal);
    const LaminateAxes<Lanes> axes(end, element);
    const Lanes               contraction = laminate_contraction(state);
    axes.set(state, section_);
    batch.bound = compute_laminate_bound<false>(end, section_.thickness, batch.inverse_mass, batch.radius2,
                                                *laminate->law, element, axes, contraction);
    chunk.bound = max(chunk.bound, Lanes(batch.owned * batch.bound));
    Corners force[2];
    compute_corner_forces<physical>(end, section_, contraction, section.hourglass_coefficient, nodes.normal, force);
    store_corner_forces(force, batch.corner, place.corner_force);
    chunk.hourglass += batch.owned * (volume / section_.thickness) * hourglass;

    if (!all(is_finite(force, batch.bound) && (end.area > Lanes(0.)) && looks_along(nodes.normal, end.e3)))
      report_failure(b);
  }

  template void ShellGroup::update_laminate<true>(std::size_t, double, ElementChunk &);
  template void ShellGroup::update_laminate<false>(std::size_t, double, ElementChunk &);

  BIRDSTRIKE_FLATTEN void ShellGroup::update_fully_integrated_laminate(const std::size_t b, const double dt,
                                                                       ElementChunk &chunk)
  {
    Batch                        &batch   = batches[b];
    const LaminateElement<Lanes> &element = laminate->elements[b];
    const BatchNodes              nodes(place.records->position, batch.record);

    const auto           x        = ShellModes<Lanes>::of_corners(nodes.position);
    const auto           u        = ShellModes<Lanes>::of_corners(nodes.increment);
    const auto           midpoint = compute_midpoint(x, u, nodes.midpoint_normal);
    PlaneGeometry<Lanes> plane(midpoint, element.lateral, element.skew);
    SectionVector<Lanes> section_of_point[n_points];
    full_integration::compute_strain_increments(plane, midpoint, u, nodes, section_of_point);

    const LaminateAxes<Lanes> middle(midpoint, element);
    LaminateState<Lanes>      old[n_points];
    Lanes                     volume[n_points], thickness = 0., contraction = 0.;
    for (int k = 0; k < n_points; ++k)
      {
        const std::size_t     s     = n_points * b + k;
        LaminateState<Lanes> &state = laminate->states[s];
        volume[k]                   = volume_of(plane.point[k].area, section_of_point[k], state, sections[s].thickness);
        old[k]                      = state;
        middle.add(section_of_point[k], 0.5 * sections[s].thickness, state.strain);
        if (!erosion)
          update_laminate_stress(*laminate->law, state);
      }
    if (erosion)
      update_failing_plies(b, old, volume, dt);

    const auto                end = ShellGeometry<Lanes>::of_modes(x, nodes.normal);
    const LaminateAxes<Lanes> axes(end, element);
    plane = PlaneGeometry<Lanes>(end, element.lateral, element.skew);
    for (int k = 0; k < n_points; ++k)
      {
        SectionStress<Lanes>       &of_point = sections[n_points * b + k];
        const LaminateState<Lanes> &state    = laminate->states[n_points * b + k];
        axes.set(state, of_point);
        const Lanes at_point = laminate_contraction(state);
        thickness            = max(thickness, of_point.thickness);
        contraction          = max(contraction, at_point);
        section_of_point[k]  = compute_resultants(of_point, at_point);
      }
    batch.bound = compute_laminate_bound<true>(end, thickness, batch.inverse_mass, batch.radius2, *laminate->law,
                                               element, axes, contraction);
    chunk.bound = max(chunk.bound, Lanes(batch.owned * batch.bound));
    Corners force[2];
    full_integration::compute_corner_forces(plane, end, section_of_point, force);
    store_corner_forces(force, batch.corner, place.corner_force);
    if (!full_integration::is_sound(plane, end, nodes.normal, force, batch.bound))
      report_failure(b);
  }
} // namespace birdstrike
