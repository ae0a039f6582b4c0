#include "bird/standard_rates.h"
#include "bird/kernel.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    double sum(const Lanes &a)
    {
      return stdx::reduce(a);
    }

    /// x_i - x_j to the nearest image.
    template <bool is_periodic>
    Vector3<Lanes> separation(const Record<double, 8> &own, const std::array<Lanes, 8> &others, const Period &period)
    {
      Vector3<Lanes> x;
      for (int d = 0; d < 3; ++d)
        {
          x[d] = own.value[d] - others[d];
          if constexpr (is_periodic)
            if (period[d] > 0.)
              x[d] -= period[d] * stdx::nearbyint(x[d] * (1. / period[d]));
        }
      return x;
    }

    /// spacing^3 sum W over an infinite lattice, by which density sums are divided.
    template <class Kernel>
    double compute_lattice_sum(const Kernel &kernel, const double spacing, const bool is_fcc)
    {
      const double a        = is_fcc ? std::cbrt(4.) * spacing : spacing;
      const int    reach    = static_cast<int>(2. / (kernel.inverse_h * a)) + 2;
      const double at[4][3] = {{0., 0., 0.}, {.5, .5, 0.}, {.5, 0., .5}, {0., .5, .5}};
      double       total    = 0.;
      for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
          for (int i = -reach; i <= reach; ++i)
            for (int b = 0; b < (is_fcc ? 4 : 1); ++b)
              total += kernel.value(a * std::hypot(i + at[b][0], j + at[b][1], k + at[b][2]));
      return total * spacing * spacing * spacing;
    }
  } // namespace

  StandardRates::StandardRates(const BirdParameters &parameters, const EquationOfState &eos, const double spacing)
    : eos(eos)
    , spacing(spacing)
    , h(parameters.smoothing_ratio * spacing)
    , alpha(parameters.alpha)
    , beta(parameters.beta)
    , has_cutoff(parameters.tension_cutoff)
    , has_summation(parameters.density_by == DensityBy::summation)
    , is_spline(parameters.kernel != SmoothingKernel::wendland)
    , is_fcc(parameters.packing == BirdLattice::fcc)
  {
  }

  template <class Number>
  void StandardRates::update_records(Particles &particles, const Number &m, const std::size_t p)
  {
    const Number p0 = eos.pressure(m), c = max(sqrt(eos.sound_speed_squared(m, p0)), Number(slowest_sound));
    const Number rho      = eos.reference_density() * (1. + m);
    const Number pressure = has_cutoff ? max(p0, Number(0.)) : p0;
    // A cavity belongs to nobody: what contact meets is liquid at its reference density.
    const Number solid = max(rho, Number(eos.reference_density()));
    store(solid, &particles.density[p]);
    store(particles.mass / solid, &particles.volume[p]);
    store(c, &particles.sound_speed[p]);
    for (std::size_t k = 0; k < lanes_of<Number>; ++k)
      {
        motion[p + k].value[6] = lane(rho, k);
        motion[p + k].value[7] = lane(pressure, k) / (lane(rho, k) * lane(rho, k));
        sound[p + k].value[0]  = lane(c, k);
      }
  }

  template <class Kernel, bool is_periodic>
  void StandardRates::sum_densities(Particles &particles, const NeighborList &list, const std::size_t begin,
                                    const std::size_t end) const
  {
    const Kernel kernel(h);
    const double scale = spacing * spacing * spacing / compute_lattice_sum(kernel, spacing, is_fcc);
    for (std::size_t i = begin; i < end; ++i)
      {
        const std::uint32_t *const neighbors = list.neighbors(i);
        Lanes                      total     = 0.;
        for (std::size_t k = 0; k < list.padded_count(i); k += n_lanes)
          {
            const auto x = separation<is_periodic>(motion[i], load_records(motion, neighbors + k), list.period());
            const auto W = kernel.value(sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
            // the padding dummy may have a near image in a periodic cell
            const Lanes is_real([&](const auto l) { return neighbors[k + l] < particles.size() ? 1. : 0.; });
            total += is_real * W;
          }
        particles.mu[i] = scale * (sum(total) + kernel.value(0.)) - 1.;
      }
  }

  template <class Kernel, bool is_periodic>
  void StandardRates::sum_pairs(Particles &particles, const NeighborList &list, const std::size_t begin,
                                const std::size_t end) const
  {
    const Kernel kernel(h);
    const Lanes  zero = 0.;
    const double mass = particles.mass, h2 = h * h;
    for (std::size_t i = begin; i < end; ++i)
      {
        const auto                &a         = motion[i].value;
        const double               c         = sound[i].value[0];
        const std::uint32_t *const neighbors = list.neighbors(i);
        Vector3<Lanes>             force(zero, zero, zero);
        Lanes                      compression = 0., work = 0., heat = 0., approach = 0., densest = 0.;
        bool                       is_isolated = true;
        for (std::size_t k = 0; k < list.padded_count(i); k += n_lanes)
          {
            const auto           A = load_records(motion, neighbors + k), S = load_records(sound, neighbors + k);
            const Vector3<Lanes> x  = separation<is_periodic>(motion[i], A, list.period());
            const Lanes          r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], r = sqrt(r2);
            // a dummy has no density and therefore no weight
            const auto  meets = r < 2. * h && A[6] > zero;
            const Lanes w     = select(meets, kernel.slope(r), zero);
            const Lanes vx    = (a[3] - A[3]) * x[0] + (a[4] - A[4]) * x[1] + (a[5] - A[5]) * x[2];
            const Lanes phi   = min(h * vx / (r2 + 0.01 * h2), zero);
            const Lanes Pi    = 2. * phi * (beta * phi - (0.5 * alpha) * (c + S[0])) / (a[6] + A[6]);
            const Lanes T     = w * (a[7] + A[7] + Pi);
            for (int d = 0; d < 3; ++d)
              force[d] += T * x[d];
            work += T * vx;
            heat += w * Pi * vx;
            compression -= w * vx;
            approach = max(approach, select(meets, -vx / (r + 1e-60), zero));
            densest  = max(densest, select(meets, A[6], zero));
            is_isolated &= !any(meets);
          }
        particles.power[i]       = -0.5 * mass * mass * sum(work);
        particles.dissipation[i] = -0.5 * mass * mass * sum(heat);
        for (int d = 0; d < 3; ++d)
          {
            particles.force[d][i] = mass * mass * sum(force[d]);
            particles.power[i] += particles.force[d][i] * a[3 + d];
          }
        particles.compression_rate[i] = has_summation ? 0. : mass * sum(compression) / a[6];
        particles.signal_speed[i]     = is_isolated ? 0. : c + 1.2 * stdx::hmax(approach);
        particles.prediction_error[i] = compute_prediction_error(particles, i, prediction_time,
                                                                 has_cutoff && a[6] < eos.reference_density() ? 0. : c);
        particles.largest_mu[i] =
          std::max(a[6], static_cast<double>(stdx::hmax(densest))) / eos.reference_density() - 1.;
      }
  }

  void StandardRates::update(Particles &particles, const double dt, const NeighborList &list, ThreadPool &pool)
  {
    const std::size_t n = particles.size();
    prediction_time     = dt;
    motion.resize(n + 1);
    sound.resize(n + 1);
    motion[n].value   = {1e10, 1e10, 1e10, 0., 0., 0., 0., 0.};
    const auto &t     = list.period();
    const bool  wraps = t[0] > 0. || t[1] > 0. || t[2] > 0.;
    using Sum         = void (StandardRates::*)(Particles &, const NeighborList &, std::size_t, std::size_t) const;
    const Sum densities[2][2] = {
      {&StandardRates::sum_densities<WendlandC2, false>, &StandardRates::sum_densities<WendlandC2, true>},
      {&StandardRates::sum_densities<CubicSpline, false>, &StandardRates::sum_densities<CubicSpline, true>}};
    const Sum pairs[2][2] = {
      {&StandardRates::sum_pairs<WendlandC2, false>, &StandardRates::sum_pairs<WendlandC2, true>},
      {&StandardRates::sum_pairs<CubicSpline, false>, &StandardRates::sum_pairs<CubicSpline, true>}};

    pool.parallel_for(n, 64, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
        {
          const Prediction<double> prediction(particles, p, dt);
          for (int d = 0; d < 3; ++d)
            {
              motion[p].value[d]     = particles.x[d][p];
              motion[p].value[3 + d] = prediction.velocity[d];
            }
        }
    });
    if (has_summation)
      pool.parallel_for_balanced(n, 8, list.cost_prefix(), [&](const std::size_t begin, const std::size_t end) {
        (this->*densities[is_spline][wraps])(particles, list, begin, end);
      });
    pool.parallel_for(n, 64, [&](const std::size_t begin, const std::size_t end) {
      sweep(begin, end, [&]<class Number>(const Number &, const std::size_t p) {
        Prediction<Number> prediction(particles, p, dt);
        if (has_summation)
          prediction.mu = load<Number>(&particles.mu[p]);
        if (!is_sound(particles, prediction, p))
          report_failed_particle(particles, dt, p, p + lanes_of<Number>);
        update_records(particles, prediction.mu, p);
      });
    });
    pool.parallel_for_balanced(n, 8, list.cost_prefix(), [&](const std::size_t begin, const std::size_t end) {
      (this->*pairs[is_spline][wraps])(particles, list, begin, end);
    });
  }
} // namespace birdstrike
