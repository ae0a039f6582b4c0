#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/group.h"
#include "structure/elements/solid/step_bound.h"
#include <birdstrike/core/simd/flatten.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// s de/2, half the work per volume of a stress on the strain of a displacement gradient.
    Lanes half_work(const Lanes (&s)[6], const Matrix3<Lanes> &g)
    {
      return 0.5 * (s[0] * g(0, 0) + s[1] * g(1, 1) + s[2] * g(2, 2) + s[3] * (g(0, 1) + g(1, 0)) +
                    s[4] * (g(1, 2) + g(2, 1)) + s[5] * (g(2, 0) + g(0, 2)));
    }

    /// Power of forces on velocities, or work on displacements, by their modes.
    Lanes dot(const SolidModes<Lanes> &f, const SolidModes<Lanes> &u)
    {
      Lanes sum = f.last.dot(u.last);
      for (int k = 0; k < 3; ++k)
        sum += f.linear[k].dot(u.linear[k]) + f.twist[k].dot(u.twist[k]);
      return sum;
    }

    void clear(const LanesMask &where, Lanes &value)
    {
      value = select(where, Lanes(0.), value);
    }

    void clear(const LanesMask &where, SolidModes<Lanes> &modes)
    {
      for (Vector3<Lanes> *mode : {&modes.linear[0], &modes.linear[1], &modes.linear[2], &modes.twist[0],
                                   &modes.twist[1], &modes.twist[2], &modes.last})
        for (int r = 0; r < 3; ++r)
          clear(where, (*mode)[r]);
    }
  } // namespace

  void SolidGroup::build_erosion()
  {
    erosion           = std::make_unique<SolidErosion>();
    erosion->n_needed = n_points_to_fail(section.material.failure.failed_share, n_points());
    erosion->batches.resize(batches.size());
    erosion->damage.assign(batches.size(), AlignedVector<Lanes>(n_points(), Lanes(0.)));
    SolidErosion::OfElements at_rest{};
    clear(LanesMask(true), at_rest.force);
    erosion->elements.assign(batches.size(), at_rest);
    for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
      {
        const SolidModes<double> x = modes(element_of(slot));
        erosion->set_size(slot, section.material.failure.size_factors, std::cbrt(SolidGeometry<double>(x).volume()));
      }
  }

  // What is turned inside out goes on as a cube at rest, so that nothing in this step is NaN, to fail at its end.
  [[gnu::noinline]] void SolidGroup::begin_failing(const std::size_t b, Corners (&corner)[2])
  {
    SolidErosion::OfElements &own = erosion->elements[b];
    const SolidModes<Lanes>   x(corner[0]), u(corner[1]);
    own.held += 0.5 * dot(own.force, u);
    own.inverted = Lanes(0.);
    if (section.material.failure.smallest_step == 0.)
      return;
    const SolidGeometry<Lanes> geometry(x);
    Lanes                      smallest = geometry.det;
    if (section.formulation == SolidFormulation::b_bar)
      for (int p = 0; p < b_bar_solid::n_points; ++p)
        smallest = min(smallest, b_bar_solid::Jacobian<Lanes>(b_bar_solid::Derivatives<Lanes>(x, p)).det);
    const corner_volume::Shares<Lanes> shares(geometry);
    for (int i = 0; i < 8; ++i)
      smallest = select(corner_shares[b].of[i] > Lanes(0.), min(smallest, shares.of[i]), smallest);
    const LanesMask inverted = smallest <= Lanes(0.);
    if (!any(inverted))
      return;
    own.inverted = select(inverted, Lanes(1.), Lanes(0.));
    for (int i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d)
        {
          corner[0][i][d] = select(inverted, Lanes((i >> d & 1) != 0 ? 1. : 0.), corner[0][i][d]);
          clear(inverted, corner[1][i][d]);
        }
  }

  Lanes SolidGroup::compute_damage(const SolidPoint<Lanes> &point, const Lanes &strain, const Lanes &von_mises,
                                   const double dt) const
  {
    const Hardening &h = section.material.hardening;
    return compute_damage_increment(section.material.failure, h,
                                    PlasticStep<Lanes>{strain, compute_mean_stress(point.stress), von_mises,
                                                       adiabatic_temperature(h, point.plastic_work), dt});
  }

  [[gnu::noinline]] void SolidGroup::add_damage(const std::size_t b, const Lanes &plastic_strain, const double dt)
  {
    const SolidPoint<Lanes> &point  = points[b];
    const Lanes              strain = point.plastic_strain - plastic_strain;
    if (!any(strain > Lanes(0.)))
      return;
    const one_point_solid::FlowSquares<Lanes> rest(stabilisation[b]);
    const Lanes q2 = von_mises_squared(point.stress) + rest.trace + rest.shear + rest.last;
    erosion->damage[b][0] += compute_damage(point, strain, Lanes(sqrt(q2)), dt) / erosion->batches[b].ductility;
  }

  // A step of a point unless it has failed; of one that fails the energy is taken. Returns the plastic work per volume.
  BIRDSTRIKE_FLATTEN [[gnu::noinline]] Lanes SolidGroup::update_failing_point(const std::size_t b, const int p,
                                                                              const Matrix3<Lanes> &gradient,
                                                                              const Lanes &volume, const double dt)
  {
    SolidPoint<Lanes> &point          = points[b * b_bar_solid::n_points + std::size_t(p)];
    Lanes             &damage         = erosion->damage[b][std::size_t(p)];
    const LanesMask    failed         = damage >= Lanes(1.);
    const Lanes        plastic_strain = point.plastic_strain;
    Lanes              work           = law.update_point(gradient, dt, point);
    point.plastic_strain              = select(failed, plastic_strain, point.plastic_strain);
    clear(failed, work);
    for (Lanes &s : point.stress)
      clear(failed, s);
    const Lanes strain = point.plastic_strain - plastic_strain;
    if (!any(strain > Lanes(0.)))
      return work;
    damage += compute_damage(point, strain, von_mises(point.stress), dt) / erosion->batches[b].ductility;
    const LanesMask fails = !failed && damage >= Lanes(1.);
    if (!any(fails))
      return work;
    Lanes energy = volume * (compute_elastic_energy(law.elasticity, point.stress) - half_work(point.stress, gradient));
    clear(!fails, energy);
    erosion->elements[b].held -= energy;
    erosion->book(b, n_elements_of(b), LanesMask(false), energy);
    for (Lanes &s : point.stress)
      clear(fails, s);
    return work;
  }

  [[gnu::noinline]] void SolidGroup::release(const std::size_t b, const SolidGeometry<Lanes> &end,
                                             const SolidModes<Lanes> &u, SolidModes<Lanes> &force, Step &step)
  {
    Erosion::OfBatch         &of_batch = erosion->batches[b];
    SolidErosion::OfElements &own      = erosion->elements[b];
    Batch                    &batch    = batches[b];
    AlignedVector<Lanes>     &damage   = erosion->damage[b];
    const LanesMask           alive    = of_batch.alive > Lanes(0.);
    LanesMask                 collapses(false);
    if (section.material.failure.smallest_step > 0.)
      collapses = own.inverted > Lanes(0.) ||
                  (alive && max(batch.bound, compute_frequency_bound(end, step.stiff_det, batch.inverse_mass, step.drag,
                                                                     law, section.formulation)) > of_batch.allowed);
    const LanesMask fails =
      alive && (collapses || count_failed(damage.data(), damage.size()) >= Lanes(double(erosion->n_needed)));
    if (any(fails))
      {
        for (std::size_t p = 0; p < n_points(); ++p)
          for (Lanes &s : points[b * n_points() + p].stress)
            clear(fails, s);
        for (int k = 0; k < 3 && !stabilisation.empty(); ++k)
          {
            clear(fails, stabilisation[b].last[k]);
            for (Lanes &s : stabilisation[b].linear[k])
              clear(fails, s);
          }
        for (Lanes &d : damage) // points that were left do nothing more
          d = select(fails, max(d, Lanes(1.)), d);
        clear(fails, force);
        clear(fails, step.pressure);
        clear(fails, batch.inverse_mass); // no vote
        clear(fails, batch.bound);
      }
    // with what `finish` books as viscous
    own.held += 0.5 * dot(force, u) - step.plastic +
                0.5 * (batch.viscous_pressure + step.pressure) * step.dilatation * step.midpoint_volume;
    own.force = force;
    if (!any(fails))
      return;
    erosion->book(b, n_elements_of(b), fails, select(fails, own.held, Lanes(0.)));
    clear(fails, own.held);
    for (std::size_t k = 0; k < n_lanes; ++k)
      of_batch.collapsed |= std::uint32_t(fails[k] && collapses[k]) << k;
  }
} // namespace birdstrike
