#include <birdstrike/bird/bird.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

/// What the bird says about itself: views, votes, balances, fields.
namespace birdstrike
{
  namespace
  {
    /// Sums of a chunk: whole registers and, at its end, single particles.
    template <std::size_t n>
    struct RegisterSums
    {
      std::array<Lanes, n>  whole{};
      std::array<double, n> rest{};

      void add(const std::size_t k, const Lanes &term)
      {
        whole[k] += term;
      }
      void add(const std::size_t k, const double term)
      {
        rest[k] += term;
      }
    };

    /// Sums over particles in one pass: term(Number(), p, sums) adds those of particles p, p + 1, ... of a register.
    template <std::size_t n, class Term>
    std::array<double, n> sum_particles(ThreadPool &pool, const std::size_t n_particles, const Term &term)
    {
      return pool.ordered_sums<n>(n_particles, [&](const std::size_t begin, const std::size_t end) {
        RegisterSums<n> sums;
        sweep(begin, end, [&](const auto &number, const std::size_t p) { term(number, p, sums); });
        for (std::size_t k = 0; k < n; ++k)
          sums.rest[k] += stdx::reduce(sums.whole[k]);
        return sums.rest;
      });
    }

    double find_largest(const double *values, const std::size_t begin, const std::size_t end)
    {
      constexpr std::size_t       n_chains = 4; // comparisons in flight, latency 4 cycles
      std::array<Lanes, n_chains> largest;
      largest.fill(Lanes(-std::numeric_limits<double>::infinity()));
      std::size_t p = begin;
      for (; p + n_chains * n_lanes <= end; p += n_chains * n_lanes)
        for (std::size_t k = 0; k < n_chains; ++k)
          largest[k] = larger(largest[k], load<Lanes>(values + p + k * n_lanes));
      double result = largest_lane(larger(larger(largest[0], largest[1]), larger(largest[2], largest[3])));
      for (; p < end; ++p)
        result = larger(result, values[p]);
      return result;
    }

    /// The first of values that is `value`, which is among them; of no number (NaN) the first that is none.
    std::size_t find_first(const double *values, const std::size_t n, const double value)
    {
      std::size_t p = 0;
      if (value != value)
        return std::find_if(values, values + n, [](const double each) { return each != each; }) - values;
      while (p + n_lanes <= n && !any(load<Lanes>(values + p) == Lanes(value)))
        p += n_lanes;
      while (values[p] != value)
        ++p;
      return p;
    }
  } // namespace

  PointsView Bird::points() const
  {
    PointsView view;
    view.n = particles.size();
    for (int d = 0; d < 3; ++d)
      {
        view.position[d] = particles.x[d].data();
        view.velocity[d] = particles.v[d].data();
      }
    view.mass                   = particle_masses.data();
    view.density                = particles.density.data();
    view.sound_speed            = particles.sound_speed.data();
    view.id                     = particles.id.data();
    view.n_ids                  = particles.n_ids;
    view.spacing                = packed.spacing;
    view.undeformed_density     = parameters.density;
    view.undeformed_sound_speed = struck_sound;
    view.hugoniot_slope         = hugoniot_slope;
    view.shock_pressure         = shock_pressure;
    view.strike_step            = strike_step();
    view.revision               = revision;
    view.plane                  = packed.plane;
    return view;
  }

  StepLimit Bird::step_limit() const
  {
    constexpr std::size_t chunk   = 8192; // 1 us, less than waking a thread
    const double *const   speed   = particles.signal_speed.data();
    const double          fastest = pool.ordered_max(
               particles.size(), [&](const std::size_t begin, const std::size_t end) { return find_largest(speed, begin, end); },
               chunk);
    StepLimit limit;
    if (fastest <= 0.)
      return limit;
    const std::size_t p = find_first(speed, particles.size(), fastest);
    limit.value         = parameters.courant_number * parameters.smoothing_ratio * packed.spacing / fastest;
    limit.reason        = "bird particle, sound and approach speed";
    limit.where         = {"particle", particles.id[p], {{particles.x[0][p], particles.x[1][p], particles.x[2][p]}}};
    if (is_soft && step_of_strike < limit.value) // of no number: the particle that has it
      limit = {step_of_strike, "bird, sound speed of its pores closed", {}};
    return limit;
  }

  double Bird::step_price() const
  {
    const double of_one = !parameters.is_riemann()          ? prices::standard_particle
                          : particles.has_velocity_gradient ? prices::linear_particle
                                                            : prices::riemann_particle;
    return of_one * static_cast<double>(particles.size());
  }

  double Bird::stored_energy(const double mu) const
  {
    return parameters.tension_cutoff && mu <= 0. ? 0. : eos.energy(mu);
  }

  /// The reference of the staggering follows the step, see core/energy_report.h.
  void Bird::follow_step(const double new_half_step, const double new_contact_half)
  {
    const auto is_near = [](const double now, const double before) { return std::abs(now - before) <= 1e-3 * before; };
    if (is_near(new_half_step, staggered_half) && is_near(new_contact_half, staggered_contact))
      return;
    const auto &f = particles.force, &g = particles.contact_force;
    const auto  sums = sum_particles<2>(
      pool, particles.size(), [&]<class Number>(const Number &, const std::size_t p, RegisterSums<2> &total) {
        for (int d = 0; d < 3; ++d)
          {
            const Number own = load<Number>(&f[d][p]), of_contact = load<Number>(&g[d][p]);
            const Number now    = new_half_step * own + new_contact_half * of_contact;
            const Number before = staggered_half * own + staggered_contact * of_contact;
            total.add(0, now * now);
            total.add(1, before * before);
          }
      });
    staggering += 0.5 / particles.mass * (sums[0] - sums[1]);
    staggered_half    = new_half_step;
    staggered_contact = new_contact_half;
  }

  EnergyReport Bird::energies() const
  {
    const auto  &v = particles.v, &f = particles.force, &g = particles.contact_force;
    const double m = particles.mass, lag = staggered_half / m, lag_of_contact = staggered_contact / m;
    const auto   sums = sum_particles<5>(
      pool, particles.size(), [&]<class Number>(const Number &, const std::size_t p, RegisterSums<5> &total) {
        for (int d = 0; d < 3; ++d)
          {
            const Number change = lag * load<Number>(&f[d][p]) + lag_of_contact * load<Number>(&g[d][p]);
            const Number now    = load<Number>(&v[d][p]);
            total.add(0, now * now);
            total.add(1, change * change);
          }
        total.add(2, load<Number>(&particles.internal_energy[p]));
        total.add(3, load<Number>(&particles.dissipated[p]));
        Number stored = 0.;
        if constexpr (std::is_same_v<Number, double>)
          stored = stored_energy(particles.mu[p]) + shear_energy(p);
        else
          for (std::size_t k = 0; k < n_lanes; ++k)
            stored[k] = stored_energy(particles.mu[p + k]) + shear_energy(p + k);
        total.add(4, stored);
      });
    EnergyReport report;
    report.kinetic      = 0.5 * m * sums[0];
    report.staggering   = staggering - 0.5 * m * sums[1];
    report.elastic      = m * sums[4];
    report.dissipated   = sums[3];
    report.internal     = sums[2];
    report.retired      = retired_share.energy;
    report.retired_made = retired_share.made;
    report.contact_work = contact_work;
    return packed.plane.whole(report);
  }

  MomentumReport Bird::momenta() const
  {
    const auto     sums = sum_particles<8>(pool, particles.size(),
                                       [&]<class Number>(const Number &, const std::size_t p, RegisterSums<8> &total) {
                                         std::array<Number, 3> x, v;
                                         for (int d = 0; d < 3; ++d)
                                           {
                                             x[d] = load<Number>(&particles.x[d][p]);
                                             v[d] = load<Number>(&particles.v[d][p]);
                                             total.add(d, v[d]);
                                           }
                                         for (int d = 0; d < 3; ++d)
                                           {
                                             const int a = (d + 1) % 3, b = (d + 2) % 3;
                                             total.add(3 + d, x[a] * v[b] - x[b] * v[a]);
                                           }
                                         const Number v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
                                         total.add(6, sqrt((x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) * v2));
                                         total.add(7, sqrt(v2));
                                       });
    MomentumReport report;
    for (int d = 0; d < 3; ++d)
      {
        report.momentum[d]         = particles.mass * sums[d];
        report.angular_momentum[d] = particles.mass * sums[3 + d];
        report.retired[d]          = retired_share.momentum[d];
        report.retired_moment[d]   = retired_share.moment[d];
        report.contact_impulse[d]  = contact_impulse[d];
      }
    report.moment_scale  = particles.mass * sums[6];
    report.impulse_scale = particles.mass * sums[7];
    report               = packed.plane.whole(report);
    const auto norm      = [](const MomentumReport::Vector &a) { return std::hypot(a[0], a[1], a[2]); };

    report.largest_momentum         = norm(report.momentum);
    report.largest_angular_momentum = norm(report.angular_momentum);
    return report;
  }

  std::size_t Bird::n_particles() const
  {
    return packed.plane.whole(particles.size());
  }

  FieldSnapshot Bird::snapshot(const std::size_t first_id) const
  {
    const std::size_t n = particles.size();
    FieldSnapshot     snapshot;
    snapshot.points.resize(3 * n);
    snapshot.cells.resize(particles.size());
    std::iota(snapshot.cells.begin(), snapshot.cells.end(), 0u);
    Field velocity{"velocity", "m/s", false, 3, std::vector<double>(3 * n)};
    Field pressure{"pressure", "Pa", false, 1, std::vector<double>(n)};
    Field density{"density", "kg/m^3", false, 1, std::vector<double>(n)};
    Field energy{"specific_internal_energy", "J/kg", false, 1, std::vector<double>(n)};
    // kept for life: output follows memory, which sorting changes
    Field id{"id", "", false, 1, std::vector<double>(n), true};
    for (std::size_t p = 0; p < n; ++p)
      {
        for (int d = 0; d < 3; ++d)
          {
            snapshot.points[3 * p + d] = particles.x[d][p];
            velocity.values[3 * p + d] = particles.v[d][p];
          }
        const double p0    = eos.pressure(particles.mu[p]);
        pressure.values[p] = parameters.tension_cutoff ? std::max(p0, 0.) : p0;
        density.values[p]  = eos.reference_density() * (1. + particles.mu[p]);
        energy.values[p]   = particles.internal_energy[p] / particles.mass;
        id.values[p]       = static_cast<double>(first_id + particles.id[p]);
      }
    snapshot.fields = {std::move(velocity), std::move(pressure), std::move(density), std::move(energy), std::move(id)};
    return snapshot;
  }

  std::string Bird::summary() const
  {
    return packed.summary(shape);
  }
} // namespace birdstrike
