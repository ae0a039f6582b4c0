#include <birdstrike/bird/bird.h>

#include <numeric>

#include <algorithm>

/// What the bird says about itself: views, votes, balances, fields.
namespace birdstrike
{
  double Bird::sum(const std::function<double(std::size_t)> &term) const
  {
    return pool.ordered_sum(particles.size(), [&](const std::size_t begin, const std::size_t end) {
      double total = 0.;
      for (std::size_t p = begin; p < end; ++p)
        total += term(p);
      return total;
    });
  }

  PointsView Bird::points()
  {
    PointsView view;
    view.n = particles.size();
    for (int d = 0; d < 3; ++d)
      {
        view.position[d] = particles.x[d].data();
        view.velocity[d] = particles.v[d].data();
        view.force[d]    = particles.contact_force[d].data();
      }
    view.mass           = particle_masses.data();
    view.volume         = particles.volume.data();
    view.density        = particles.density.data();
    view.sound_speed    = particles.sound_speed.data();
    view.id             = particles.id.data();
    view.n_ids          = particles.n_ids;
    view.spacing        = packed.spacing;
    view.hugoniot_slope = hugoniot_slope;
    view.revision       = revision;
    has_contact_force   = true; // whoever holds the view may write
    return view;
  }

  StepLimit Bird::step_limit() const
  {
    const auto &speed = particles.signal_speed;
    StepLimit   limit;
    const auto  fastest = std::max_element(speed.begin(), speed.end());
    if (fastest == speed.end() || *fastest == 0.)
      return limit;
    const std::size_t p = fastest - speed.begin();
    limit.value         = parameters.courant_number * parameters.smoothing_ratio * packed.spacing / *fastest;
    limit.reason        = "bird particle, sound and approach speed";
    limit.where         = {"particle", particles.id[p], {{particles.x[0][p], particles.x[1][p], particles.x[2][p]}}};
    return limit;
  }

  EnergyReport Bird::energies() const
  {
    const auto  &v = particles.v, &f = particles.force, &g = particles.contact_force;
    const double m = particles.mass, lag = half_step / m;
    EnergyReport report;
    // m v^{n-1/2}.v^{n+1/2}/2 = m/2 (|v|^2 - |f dt/2m|^2)
    report.kinetic      = 0.5 * m * sum([&](const std::size_t p) {
                       double product = 0.;
                       for (int d = 0; d < 3; ++d)
                         {
                           const double change = lag * (f[d][p] + g[d][p]);
                           product += v[d][p] * v[d][p] - change * change;
                         }
                       return product;
                     });
    report.elastic      = sum([&](const std::size_t p) { return particles.internal_energy[p]; });
    report.retired      = retired_share.energy;
    report.contact_work = contact_work;
    return report;
  }

  MomentumReport Bird::momenta() const
  {
    const auto    &x = particles.x, &v = particles.v;
    MomentumReport report;
    for (int d = 0; d < 3; ++d)
      {
        const int a = (d + 1) % 3, b = (d + 2) % 3;
        report.momentum[d] = particles.mass * sum([&](const std::size_t p) { return v[d][p]; });
        report.angular_momentum[d] =
          particles.mass * sum([&](const std::size_t p) { return x[a][p] * v[b][p] - x[b][p] * v[a][p]; });
        report.retired[d]         = retired_share.momentum[d];
        report.contact_impulse[d] = contact_impulse[d];
      }
    return report;
  }

  FieldSnapshot Bird::snapshot() const
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
      }
    snapshot.fields = {std::move(velocity), std::move(pressure), std::move(density), std::move(energy)};
    return snapshot;
  }

  std::string Bird::summary() const
  {
    return packed.summary(shape);
  }
} // namespace birdstrike
