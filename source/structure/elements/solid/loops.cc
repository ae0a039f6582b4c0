#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/group.h"
#include "structure/elements/solid/step_bound.h"
#include <birdstrike/core/simd/flatten.h>

#include <type_traits>

namespace birdstrike
{
  namespace
  {
    using Corners = Vector3<Lanes>[8];

    [[gnu::always_inline]] inline void load_nodes(const double *records, const std::uint32_t (&begin)[8][n_lanes],
                                                  Corners &position, Corners &increment)
    {
#pragma GCC unroll 8
      for (int i = 0; i < 8; ++i)
        {
          const auto a = load_rows(records, begin[i]);
          position[i] << a[0], a[1], a[2];
          increment[i] << a[3], a[4], a[5];
        }
    }

    template <class Force>
    [[gnu::always_inline]] inline void store_corner_forces(const Corners &f, const std::uint32_t (&corner)[8][n_lanes],
                                                           Force         *rows)
    {
      const Lanes zero = 0.;
#pragma GCC unroll 4
      for (int i = 0; i < 8; i += 2)
        {
          store_half_rows({f[i][0], f[i][1], f[i][2], zero, f[i + 1][0], f[i + 1][1], f[i + 1][2], zero}, corner[i],
                          corner[i + 1], rows);
        }
    }

    [[gnu::always_inline]] inline void add_pressure(const Lanes &pressure, Lanes (&stress)[6])
    {
      for (int c = 0; c < 3; ++c)
        stress[c] -= pressure;
    }
  } // namespace

  [[gnu::always_inline]] inline void SolidGroup::update_viscosity(const SolidGeometry<Lanes> &midpoint,
                                                                  const Matrix3<Lanes> &gradient, const double dt,
                                                                  Step &step)
  {
    step.midpoint_volume = midpoint.volume();
    step.dilatation      = gradient(0, 0) + gradient(1, 1) + gradient(2, 2);
    step.pressure =
      law.compute_viscous_pressure(Lanes(step.dilatation * (1. / dt)), midpoint.compute_height(), step.drag);
  }

  /// Of a solid-shell; `end` is the geometry of the end of the step.
  [[gnu::always_inline]] inline Lanes SolidGroup::update_section(const std::size_t b, const Matrix3<Lanes> &gradient,
                                                                 const Stabilisation &strain, const double dt,
                                                                 const SolidModes<Lanes> &end)
  {
    using namespace solid_shell;
    SolidPoint<Lanes> &mean = points[b];
    Stabilisation     &s    = stabilisation[b];
    mean.rotate_and_strain(law.elasticity, gradient);
    add_stress(law.elasticity, strain, s);
    const Lanes     bound = Squares<Lanes>(s).compute_bound(von_mises_squared(mean.stress));
    const LanesMask can_yield =
      bound > mean.yield * mean.yield || mean.plastic_strain > Lanes(0.); // by its points from then on
    if (!any(can_yield))
      return Lanes(0.);
    const Lanes                         trial = compute_varying_work(s, strain);
    const solid_shell::LayerWork<Lanes> work  = update_layers(b, dt, can_yield, end);
    // less what flow took of the energy of the trial, and of the work on it
    return work.plastic + (0.5 * (compute_varying_work(s, strain) - trial) - work.varying);
  }

  // One body each, although long: all of it works on the same registers. Without `flatten` GCC leaves the vector
  // operations of Eigen as calls with their operands in memory.
  template <bool has_layers, bool can_fail>
  BIRDSTRIKE_FLATTEN void SolidGroup::update_one_point(const std::size_t b, const double dt, ElementChunk &chunk)
  {
    using namespace one_point_solid;
    Corners corner[2];
    load_nodes(place.records->position, batches[b].record, corner[0], corner[1]);
    if constexpr (can_fail)
      begin_failing(b, corner);
    const SolidModes<Lanes>    x(corner[0]), u(corner[1]), middle = compute_midpoint_modes(x, u);
    const SolidGeometry<Lanes> midpoint(middle);
    const Matrix3<Lanes>       gradient = midpoint.compute_mean_gradient(u);
    const Axes<Lanes>          axes(middle);
    const auto                 strain = compute_strains(middle, axes, gradient, u);

    Step step;
    update_viscosity(midpoint, gradient, dt, step);
    Lanes plastic_strain; // before the step
    if constexpr (can_fail)
      plastic_strain = points[b].plastic_strain;
    if constexpr (has_layers)
      step.plastic = update_section(b, gradient, strain, dt, x);
    else
      step.plastic = law.update_one_point(gradient, strain, dt, points[b], stabilisation[b]);
    if constexpr (can_fail)
      add_damage(b, plastic_strain, dt);
    step.stiff_det = batches[b].rest_det;
    step.plastic *= (1. / 64.) * step.stiff_det;

    const SolidGeometry<Lanes> end(x);
    const Lanes                inverse_ratio = step.stiff_det * end.inverse_det;
    Lanes                      stress[6]; // Cauchy's
    for (int c = 0; c < 6; ++c)
      stress[c] = inverse_ratio * points[b].stress[c];
    add_pressure(step.pressure, stress);
    SolidModes<Lanes> force = compute_mode_forces(end, step.stiff_det, stress, stabilisation[b]);
    hold_shape(b, end, u, step, dt, force);
    if constexpr (can_fail)
      release(b, end, u, force, step);
    finish(b, end, force, step, chunk);
  }

  template <bool can_fail>
  BIRDSTRIKE_FLATTEN void SolidGroup::update_b_bar(const std::size_t b, const double dt, ElementChunk &chunk)
  {
    using namespace b_bar_solid;
    Corners corner[2];
    load_nodes(place.records->position, batches[b].record, corner[0], corner[1]);
    if constexpr (can_fail)
      begin_failing(b, corner);
    const SolidModes<Lanes>    x(corner[0]), u(corner[1]), middle = compute_midpoint_modes(x, u);
    const SolidGeometry<Lanes> midpoint(middle), end(x);

    Step step;
    update_viscosity(midpoint, midpoint.compute_mean_gradient(u), dt, step);
    step.plastic           = 0.;
    const auto        zero = Vector3<Lanes>::Constant(Lanes(0.));
    SolidModes<Lanes> force;
    for (int k = 0; k < 3; ++k)
      force.linear[k] = force.twist[k] = zero;
    force.last     = zero;
    Lanes pressure = 0., smallest = end.det, stiffest = 0.;
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      {
        const std::size_t     k      = b * b_bar_solid::n_points + std::size_t(p);
        SolidPoint<Lanes>    &point  = points[k];
        const Lanes           volume = (1. / 512.) * rest_det[k];
        const Jacobian<Lanes> at_midpoint(Derivatives<Lanes>(middle, p)), at_end(Derivatives<Lanes>(x, p));
        const Matrix3<Lanes>  gradient = at_midpoint.compute_gradient(Derivatives<Lanes>(u, p), step.dilatation);
        Lanes                 work;
        if constexpr (can_fail)
          work = update_failing_point(b, p, gradient, volume, dt);
        else
          work = law.update_point(gradient, dt, point);
        step.plastic += volume * work;
        const Lanes stretch = rest_det[k] / at_end.det;
        add_point_forces(at_end, rest_det[k], stretch, point.stress, p, force, pressure);
        stiffest = max(stiffest, stretch);
        smallest = min(smallest, at_end.det);
      }
    step.stiff_det = stiffest * end.det;
    // the determinants add up to 8 D
    const Lanes          mean = pressure * end.inverse_det * 0.125 - step.pressure, scaled = (1. / 64.) * mean;
    const Lanes          none = select(smallest > Lanes(0.), Lanes(0.), Lanes(std::nan(""))); // reported in `finish`
    const Matrix3<Lanes> volumetric = Vector3<Lanes>::Constant(Lanes(scaled + none)).asDiagonal();
    end.add_mean_forces(volumetric, force);
    hold_shape(b, end, u, step, dt, force);
    if constexpr (can_fail)
      release(b, end, u, force, step);
    finish(b, end, force, step, chunk);
  }

  /// The bound on the step, and what keeps corners from turning inside out.
  [[gnu::always_inline]] inline void SolidGroup::hold_shape(const std::size_t b, const SolidGeometry<Lanes> &end,
                                                            const SolidModes<Lanes> &u, const Step &step,
                                                            const double dt, SolidModes<Lanes> &force)
  {
    Batch &batch = batches[b];
    Lanes  distortion;
    if (mass_factors.empty())
      batch.bound = compute_frequency_bound(end, step.stiff_det, batch.inverse_mass, step.drag, law,
                                            section.formulation, {}, &distortion);
    else
      {
        const SolidModes<Lanes> copy = end.x; // only this goes to memory
        batch.bound =
          compute_scaled_frequency(copy, step.stiff_det, batch.inverse_mass, step.drag, mass_factors[b], &distortion);
      }
    batch.corner_energy = 0.;
    if (any(distortion > batch.undistorted)) [[unlikely]]
      {
        const SolidModes<Lanes> copy = end.x, way = u, more = hold_corners(b, copy, way, dt);
        for (int k = 0; k < 3; ++k)
          {
            force.linear[k] += more.linear[k];
            force.twist[k] += more.twist[k];
          }
        force.last += more.last;
      }
  }

  [[gnu::always_inline]] inline void SolidGroup::finish(const std::size_t b, const SolidGeometry<Lanes> &end,
                                                        const SolidModes<Lanes> &force, const Step &step,
                                                        ElementChunk &chunk)
  {
    Batch &batch = batches[b];
    chunk.bound  = max(chunk.bound, Lanes(batch.owned * batch.bound));
    Corners corner;
    force.sum_at_corners(corner);
    store_corner_forces(corner, batch.corner, place.corner_force);

    chunk.plastic += batch.owned * step.plastic;
    chunk.viscous -=
      batch.owned * (0.5 * (batch.viscous_pressure + step.pressure) * step.dilatation * step.midpoint_volume);
    batch.viscous_pressure = step.pressure;

    const Lanes total =
      force.linear[0].sum() + force.linear[1].sum() + force.linear[2].sum() + force.last.sum() + batch.bound;
    if (!all((total - total == Lanes(0.)) && (end.det > Lanes(0.))))
      report_failure(b);
  }

  void SolidGroup::update_chunk(const std::size_t c, const double dt)
  {
    const std::size_t last  = std::min(batches.size(), (c + 1) * ElementBlocks::batches_per_chunk);
    ElementChunk     &chunk = chunks[c];
    chunk.bound             = Lanes(0.);
    const auto update       = [&]<bool can_fail>(std::bool_constant<can_fail>) {
      for (std::size_t b = c * ElementBlocks::batches_per_chunk; b < last; ++b)
        switch (section.formulation)
          {
          case SolidFormulation::one_point:
            update_one_point<false, can_fail>(b, dt, chunk);
            break;
          case SolidFormulation::solid_shell:
            update_one_point<true, false>(b, dt, chunk);
            break;
          case SolidFormulation::b_bar:
            update_b_bar<can_fail>(b, dt, chunk);
          }
    };
    erosion ? update(std::true_type()) : update(std::false_type());
  }
} // namespace birdstrike
