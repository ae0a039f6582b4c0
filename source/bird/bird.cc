#include "bird/strength.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/bird/mirror_images.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Particles per thread range: whole registers and whole cache lines of every column.
    constexpr std::size_t grain = 64;

    double speed_of(const BirdParameters &parameters)
    {
      return std::hypot(parameters.velocity[0], parameters.velocity[1], parameters.velocity[2]);
    }

    /// Around the blade, m.
    double retirement_margin(const BirdParameters &parameters, const Shape &shape)
    {
      constexpr double in_diameters = 1.25;
      return parameters.retirement_margin.empty() ? in_diameters * shape.whole_diameter()
                                                  : parameters.retirement_margin.front();
    }
  } // namespace

  Bird::Bird(const BirdParameters &parameters, const EosParameters &eos_parameters, ThreadPool &pool)
    : parameters((parameters.check(), parameters))
    , eos((eos_parameters.check(), eos_parameters), parameters.density)
    , pool(pool)
    , shape(parameters)
    , packed(compute_packing(parameters, shape))
    , list(2. * parameters.smoothing_ratio * packed.spacing,
           2. * parameters.smoothing_ratio * packed.spacing * parameters.skin, packed.period,
           parameters.is_riemann() && parameters.pair_precision == PairPrecision::as_float ? FloatLanes::size()
                                                                                           : n_lanes)
    , rates(make_rates(parameters, eos, packed.spacing))
  {
    set_closing_speed(speed_of(parameters));
    if (parameters.is_halved)
      list.mirror();
    place();
  }

  void Bird::place()
  {
    const std::size_t n             = packed.points.size();
    particles                       = Particles();
    particles.mass                  = packed.particle_mass;
    particles.n_ids                 = n;
    particles.has_strength          = parameters.has_strength();
    particles.has_velocity_gradient = particles.has_strength || parameters.reconstruction == Reconstruction::linear;
    particles.resize(n);
    particle_masses.assign(n, particles.mass);
    for (std::size_t p = 0; p < n; ++p)
      {
        particles.id[p] = p;
        for (int d = 0; d < 3; ++d)
          {
            particles.x[d][p]          = packed.points[p][d];
            particles.v[d][p]          = parameters.velocity[d];
            particles.correction[d][p] = 1.f;
            if (particles.has_strength)
              particles.shear_correction[d][p] = 1.f;
          }
      }
    half_step = staggered_half = staggered_contact = staggering = 0.;
    retired_share                                               = {};
    contact_work                                                = 0.;
    contact_impulse.setZero();
    has_contact_force = false;
    list.update(particles, pool);
    ++revision;
    rates->renew_correction();
    compute_rates();
    rates->renew_correction();
    compute_rates(); // the correction matrices are those of the evaluation before
  }

  void Bird::advance_in_flight(const double t, const Point3 &frame)
  {
    for (int d = 0; d < 3; ++d)
      for (double &x : particles.x[d])
        x += t * (parameters.velocity[d] - frame[d]);
  }

  void Bird::set_closing_speed(const double speed)
  {
    hugoniot_slope = eos.hugoniot_slope(speed);
    struck_sound   = eos.struck_sound_speed(speed);
    shock_pressure = speed / struck_sound;
    shock_pressure *= 1. + hugoniot_slope * shock_pressure;
    step_of_strike = shocked_step(speed);
    is_soft        = struck_sound > eos.reference_sound_speed();
    rates->set_slowest_sound(is_soft ? struck_sound : 0.);
    closing_energy = 0.5 * packed.particle_mass * packed.points.size() * speed * speed;
  }

  double Bird::shocked_step(const double speed) const
  {
    const HugoniotState shocked = eos.hugoniot(speed);
    const double        c       = std::sqrt(eos.sound_speed_squared(shocked.density_ratio - 1., shocked.pressure) +
                                            Strength(parameters).stiffening(eos.reference_density()));
    return parameters.courant_number * parameters.smoothing_ratio * packed.spacing / (c + 1.2 * speed);
  }

  void Bird::set_state(const std::function<void(Point3 &, Point3 &, double &)> &state)
  {
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        Point3 x(particles.x[0][p], particles.x[1][p], particles.x[2][p]);
        Point3 v(particles.v[0][p], particles.v[1][p], particles.v[2][p]);
        state(x, v, particles.mu[p]);
        for (int d = 0; d < 3; ++d)
          {
            particles.x[d][p] = x[d];
            particles.v[d][p] = v[d];
          }
      }
    half_step = staggered_half = staggered_contact = 0.;
    list.update(particles, pool);
    ++revision;
    rates->renew_correction();
    compute_rates();
    rates->renew_correction();
    compute_rates(); // with the new correction matrices
  }

  PointForces Bird::clear_contact_forces()
  {
    for (auto &force : particles.contact_force)
      std::fill(force.begin(), force.end(), 0.);
    has_contact_force = true; // whoever holds them may write
    auto &force       = particles.contact_force;
    return {{force[0].data(), force[1].data(), force[2].data()}};
  }

  void Bird::drift(const double dt)
  {
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        for (int d = 0; d < 3; ++d)
          {
            store(load<Number>(&particles.x[d][p]) + dt * load<Number>(&particles.v[d][p]), &particles.x[d][p]);
          }
      });
    });
    if (packed.plane.exists())
      take_image_of_those_beyond(particles);
  }

  void Bird::update_neighbor_list()
  {
    if (!list.is_outdated(particles, pool))
      return;
    list.update(particles, pool);
    ++revision;
  }

  void Bird::kick(const double dt, const HalfKick half, const double contact_dt)
  {
    const bool is_first = half == HalfKick::first;
    if (is_first)
      {
        follow_step(dt, contact_dt);
        half_step = dt;
        // Those that stay feel the present pair forces for this last half kick; so do those that have left.
        retired_share.kick(dt);
      }
    else
      book_contact(contact_dt);
    particles.contact_share = dt > 0. ? contact_dt / dt : 1.;
    const double scale = dt / particles.mass, share = particles.contact_share;
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        Number power = load<Number>(&particles.power[p]);
        for (int d = 0; d < 3; ++d)
          {
            const Number f = load<Number>(&particles.force[d][p]), before = load<Number>(&particles.v[d][p]);
            const Number after = before + scale * (f + share * load<Number>(&particles.contact_force[d][p]));
            store(after, &particles.v[d][p]);
            power -= f * (is_first ? after : before);
          }
        store(load<Number>(&particles.internal_energy[p]) + dt * power, &particles.internal_energy[p]);
        store(load<Number>(&particles.dissipated[p]) + dt * load<Number>(&particles.dissipation[p]),
              &particles.dissipated[p]);
        const Number mu = load<Number>(&particles.mu[p]), rate = load<Number>(&particles.compression_rate[p]);
        store(expand_at_most(compress(mu, rate, dt)), &particles.mu[p]);
      });
    });
    if (particles.has_strength)
      kick_stress(dt);
    if (is_first)
      book_contact(contact_dt);
  }

  void Bird::kick_contact(const double dt, const HalfKick half)
  {
    if (half == HalfKick::second)
      book_contact(dt);
    const double scale = dt / particles.mass;
    pool.parallel_for(particles.size(), grain, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        for (int d = 0; d < 3; ++d)
          store(load<Number>(&particles.v[d][p]) + scale * load<Number>(&particles.contact_force[d][p]),
                &particles.v[d][p]);
      });
    });
    if (half == HalfKick::first)
      book_contact(dt);
  }

  void Bird::book_contact(const double dt)
  {
    if (!has_contact_force)
      return;
    const auto &f = particles.contact_force, &v = particles.v;
    const auto  sums = pool.ordered_sums<4>(particles.size(), [&](const std::size_t begin, const std::size_t end) {
      std::array<Lanes, 4>  whole{};
      std::array<double, 4> rest{};
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        for (int d = 0; d < 3; ++d)
          {
            const Number g = load<Number>(&f[d][p]), power = g * load<Number>(&v[d][p]);
            if constexpr (std::is_same_v<Number, Lanes>)
              {
                whole[d] += g;
                whole[3] += power;
              }
            else
              {
                rest[d] += g;
                rest[3] += power;
              }
          }
      });
      for (int k = 0; k < 4; ++k)
        rest[k] += stdx::reduce(whole[k]);
      return rest;
    });
    for (int d = 0; d < 3; ++d)
      contact_impulse[d] += dt * sums[d];
    contact_work += dt * sums[3];
  }

  std::size_t Bird::retire(const Box &blade_box)
  {
    if (!parameters.retire)
      return 0;
    const RetiredShare share = retire_particles(
      particles, blade_box.widened(retirement_margin(parameters, shape)),
      [this](const std::size_t p) { return stored_energy(particles.mu[p]) + shear_energy(p); },
      parameters.tension_cutoff);
    if (share.particles == 0)
      return 0;
    retired_share.add(share);
    if (particles.size() > 0)
      list.update(particles, pool);
    ++revision;
    return packed.plane.whole(share.particles);
  }
} // namespace birdstrike
