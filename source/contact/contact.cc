#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/law.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  Contact::Contact(const ContactParameters &parameters) : parameters(parameters), patches(parameters.pressure_patches())
  {
    last.patch_pressures.assign(patches.size(), 0.);
  }

  void Contact::set_clock(const double time)
  {
    clock    = time;
    is_first = true;
  }

  void Contact::add_forces(const PointsView &points, const FacetsView &facets, const double step, ThreadPool &pool)
  {
    if (!parameters.is_enabled)
      return;
    clock += is_first ? 0. : step;
    is_first = false;
    ++last.calls;

    update_touches(points, facets, step, pool);
    compute_forces(points, facets, step, pool);
    scatter(points, facets);
    update_peaks(points.spacing);
  }

  void Contact::update_touches(const PointsView &points, const FacetsView &facets, const double step, ThreadPool &pool)
  {
    if (topology.update(facets) && last.calls > 1)
      {
        memory.forget_sides();
        search.forget();
      }
    memory.update(points);
    search.update(points, facets, topology.max_half_thickness() + 0.5 * memory.max_size(),
                  parameters.search_margin * points.spacing, pool);
    if (search.counts().searches > last.searches)
      topology.update_thickness(facets); // it changes slowly
    last.skipped  = search.counts().apart;
    last.searches = search.counts().searches;
    last.reused   = search.counts().reused;
    narrow_phase.update({points, facets, search, topology, step, last.calls == 1}, memory, pool);
  }

  void Contact::compute_forces(const PointsView &points, const FacetsView &facets, const double step, ThreadPool &pool)
  {
    const std::size_t n = (narrow_phase.touches().size() + n_lanes - 1) / n_lanes * n_lanes;
    for (auto &component : forces)
      component.resize(n);
    stored.resize(n);
    dissipated.resize(n);
    pool.parallel_for(n, 16 * n_lanes, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t b = begin; b < end; b += n_lanes)
        compute_batch(points, facets, step, b);
    });
  }

  void Contact::compute_batch(const PointsView &points, const FacetsView &facets, const double step,
                              const std::size_t begin)
  {
    // a list of gathers and one call of the law: longer than a function should be, but of one thought
    // the last batch is filled up with copies of the last touch, whose results are never read
    const auto &touches = narrow_phase.touches();
    const auto  pick    = [&](const auto &value) {
      return Lanes([&](const auto j) { return value(touches[std::min(begin + j, touches.size() - 1)]); });
    };
    const auto point = [&](const TouchingPair &t) { return search.pair_point()[t.pair]; };
    const auto node  = [&](const TouchingPair &t, const unsigned int k) {
      return facets.nodes[search.pair_facet()[t.pair]][k];
    };
    const auto record = [&](const TouchingPair &t) -> const PointRecord & {
      return memory.data()[points.id[point(t)]];
    };

    std::array<Lanes, 4> weights, inverse_masses;
    for (unsigned int k = 0; k < 4; ++k)
      {
        weights[k]        = pick([&](const TouchingPair &t) { return narrow_phase.weight(t.pair, k); });
        inverse_masses[k] = pick([&](const TouchingPair &t) { return facets.inverse_mass[node(t, k)]; });
      }
    Touch<Lanes> touch;
    touch.penetration = pick([&](const TouchingPair &t) { return t.penetration; });
    touch.size        = pick([&](const TouchingPair &t) { return record(t).size; });
    touch.density = pick([&](const TouchingPair &t) { return std::max(points.density[point(t)], record(t).density); });
    touch.sound_speed =
      pick([&](const TouchingPair &t) { return std::max(points.sound_speed[point(t)], record(t).sound_speed); });
    touch.reduced_mass =
      compute_reduced_mass(pick([&](const TouchingPair &t) { return points.mass[point(t)]; }), weights, inverse_masses);
    for (unsigned int d = 0; d < 3; ++d)
      {
        touch.normal[d]   = pick([&](const TouchingPair &t) { return t.normal[d]; });
        touch.velocity[d] = pick([&](const TouchingPair &t) { return points.velocity[d][point(t)]; });
        for (unsigned int k = 0; k < 4; ++k)
          touch.velocity[d] -= weights[k] * pick([&](const TouchingPair &t) {
                                 return facets.velocity[node(t, k) * facets.velocity_stride + d];
                               });
      }

    const ContactLaw law{parameters.stiffness_scale, parameters.damping_scale, parameters.stability_share,
                         parameters.friction,        points.hugoniot_slope,    step};
    const auto       force = compute_contact_force(law, touch);
    const Lanes      share = pick([&](const TouchingPair &t) { return t.share; });
    store(share * force.stored_energy, &stored[begin]);
    store(share * force.dissipation_power, &dissipated[begin]);
    for (unsigned int d = 0; d < 3; ++d)
      store(share * force.force[d], &forces[d][begin]);
  }

  void Contact::scatter(const PointsView &points, const FacetsView &facets)
  {
    last.force         = {};
    last.stored_energy = last.dissipation_power = last.penetration = 0.;
    last.n_touching                                                = narrow_phase.touches().size();
    std::fill(last.patch_pressures.begin(), last.patch_pressures.end(), 0.);
    for (std::size_t t = 0; t < last.n_touching; ++t)
      {
        const TouchingPair &touch = narrow_phase.touches()[t];
        const std::uint32_t i     = search.pair_point()[touch.pair];
        const auto         &nodes = facets.nodes[search.pair_facet()[touch.pair]];
        for (unsigned int d = 0; d < 3; ++d)
          {
            points.force[d][i] += forces[d][t];
            last.force[d] -= forces[d][t];
            for (unsigned int k = 0; k < 4; ++k)
              facets.force[nodes[k] * facets.velocity_stride + d] -= narrow_phase.weight(touch.pair, k) * forces[d][t];
          }
        if (parameters.friction > 0.)
          add_couple(facets, t, Point3(forces[0][t], forces[1][t], forces[2][t]));
        add_to_patches(points, t);
        last.stored_energy += stored[t];
        last.dissipation_power += dissipated[t];
        last.penetration = std::max(last.penetration, touch.penetration);
      }
  }

  void Contact::add_couple(const FacetsView &facets, const std::size_t touch, const Point3 &force)
  {
    // (p - q) x F is left over; forces f_k = w x y_k about the nodes' mean have no sum, and the moment (sum |y|^2 1 - y
    // y^T) w
    const std::uint32_t   pair   = narrow_phase.touches()[touch].pair;
    const Point3          couple = narrow_phase.offset(pair).cross(force);
    const auto           &nodes  = facets.nodes[search.pair_facet()[pair]];
    std::array<Point3, 4> arms   = facet_nodes(facets, search.pair_facet()[pair]);
    const Point3          mean   = 0.25 * (arms[0] + arms[1] + arms[2] + arms[3]);
    Matrix3<double>       moment = Matrix3<double>::Zero();
    for (Point3 &arm : arms)
      {
        arm -= mean;
        moment += arm.squaredNorm() * Matrix3<double>::Identity() - arm * arm.transpose();
      }
    const Point3 turn = moment.inverse() * couple;
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        facets.force[nodes[k] * facets.velocity_stride + d] -= turn.cross(arms[k])[d];
  }

  void Contact::add_to_patches(const PointsView &points, const std::size_t touch)
  {
    const TouchingPair &pair = narrow_phase.touches()[touch];
    const std::uint32_t i    = search.pair_point()[pair.pair];
    for (std::size_t k = 0; k < patches.size(); ++k)
      {
        const Point3 closest =
          Point3(points.position[0][i], points.position[1][i], points.position[2][i]) - narrow_phase.offset(pair.pair);
        if ((closest - patches[k].centre).norm() <= patches[k].radius)
          last.patch_pressures[k] += Point3(forces[0][touch], forces[1][touch], forces[2][touch]).dot(pair.normal) /
                                     (std::numbers::pi * patches[k].radius * patches[k].radius);
      }
  }

  void Contact::update_peaks(const double spacing)
  {
    const double norm = Point3(last.force[0], last.force[1], last.force[2]).norm();
    if (norm > last.peak_force)
      {
        last.peak_force      = norm;
        last.peak_force_time = clock;
      }
    last.max_penetration              = std::max(last.max_penetration, last.penetration);
    last.max_penetration_over_spacing = spacing > 0. ? last.max_penetration / spacing : 0.;
  }
} // namespace birdstrike
