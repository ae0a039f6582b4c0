#include <birdstrike/bird/correction.h>
#include <birdstrike/bird/kernel.h>
#include <birdstrike/bird/riemann_rates.h>
#include <birdstrike/bird/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Share of the acoustic solver's velocity (p_i - p_j)/(Z_i + Z_j) that enters the divergence. Measured on plane
    /// shocks of 177 m/s at Courant number 0.5: with 1 the predictor is unstable and the shock slow; with 0.5 plateaus
    /// are within 0.8 % and overshoots 0-5 %; with 0.2, 5-20 %; with 0, 40-70 % and chequered pressure.
    constexpr double pressure_share = 0.5;
    /// m^2, added to r^2: keeps 1/r finite for a particle that meets its own image or another in one place.
    constexpr double smallest_distance2 = 1e-60;

    /// The jump v.x less the harmonic mean of both sides' slopes (van Leer 1974) where all agree in sign, else the
    /// jump; never beyond zero.
    [[gnu::always_inline]] inline Lanes remove_slopes(const Lanes &jump, const Lanes &a, const Lanes &b)
    {
      const Lanes zero = 0., product = a * b;
      const auto  agree = product > zero;
      const Lanes mean  = select(agree, 2. * product / select(agree, a + b, Lanes(1.)), zero);
      return select(mean * jump > zero, select(stdx::abs(mean) < stdx::abs(jump), jump - mean, zero), jump);
    }

    double sum(const Lanes &a)
    {
      return stdx::reduce(a);
    }
  } // namespace

  RiemannRates::RiemannRates(const BirdParameters &parameters, const EquationOfState &eos, const double spacing)
    : eos(eos)
    , h(parameters.smoothing_ratio * spacing)
    , has_cutoff(parameters.tension_cutoff)
    , has_correction(parameters.gradient_correction)
    , has_reconstruction(parameters.reconstruction == "linear")
  {
  }

  template <class Number>
  void RiemannRates::update_records(Particles &particles, const Particles::Column &mu, const std::size_t p)
  {
    const Number m  = load<Number>(&mu[p]);
    const Number p0 = eos.pressure(m), c = sqrt(eos.sound_speed_squared(m, p0));
    const Number rho = eos.reference_density() * (1. + m), volume = particles.mass / rho;
    const Number pressure = has_cutoff ? max(p0, Number(0.)) : p0;
    // A cavity belongs to nobody: what contact meets is liquid at its reference density.
    const Number solid = max(rho, Number(eos.reference_density()));
    store(solid, &particles.density[p]);
    store(particles.mass / solid, &particles.volume[p]);
    store(c, &particles.sound_speed[p]);
    for (std::size_t k = 0; k < lanes_of<Number>; ++k)
      {
        auto &a = motion[p + k].value, &b = stress[p + k].value, &g = gradient[p + k].value;
        for (int d = 0; d < 3; ++d)
          {
            a[d]     = particles.x[d][p + k];
            a[3 + d] = particles.predicted_velocity[d][p + k];
          }
        a[6] = lane(volume, k);
        a[7] = lane(pressure, k);
        for (int t = 0; t < 6; ++t)
          {
            b[t] = a[7] * (has_correction ? particles.correction[t][p + k] : (t < 3 ? 1. : 0.));
            g[t] = particles.velocity_gradient[t][p + k];
          }
        b[6] = lane(rho, k) * lane(c, k);
        b[7] = 1. / b[6];
      }
  }

  // The pair loop: one register of neighbours at a time, every sum of the formulation in one sweep. Longer than other
  // functions because its intermediate values live in registers and are used by several sums.
  template <bool is_periodic, bool is_corrected, bool is_linear>
  void RiemannRates::sum_pairs(Particles &particles, const NeighborList &list, const std::size_t begin,
                               const std::size_t end) const
  {
    const WendlandC2 kernel(h);
    const Period     period  = list.period();
    const Lanes      zero    = 0.;
    const double     limiter = 1.5 * eos.reference_density(); // 3/c, with 1/c = rho0/Z
    for (std::size_t i = begin; i < end; ++i)
      {
        const auto                &a = motion[i].value, &b = stress[i].value;
        RiemannSums<Lanes>         sums;
        Lanes                      approach = 0., closest = 0., smallest = a[6];
        const std::uint32_t *const neighbors = list.neighbors(i);
        for (std::size_t k = 0; k < list.padded_count(i); k += n_lanes)
          {
            const auto           A = load_records(motion, neighbors + k), S = load_records(stress, neighbors + k);
            Vector3<Lanes>       x(a[0] - A[0], a[1] - A[1], a[2] - A[2]);
            const Vector3<Lanes> v(a[3] - A[3], a[4] - A[4], a[5] - A[5]);
            if constexpr (is_periodic)
              for (int d = 0; d < 3; ++d)
                if (period[d] > 0.)
                  x[d] -= period[d] * stdx::nearbyint(x[d] * (1. / period[d]));
            const Lanes r2        = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + smallest_distance2;
            const Lanes inverse_r = inverse_sqrt(r2), r = r2 * inverse_r, Vw = A[6] * kernel.slope(r);
            const Lanes vx         = v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
            Lanes       separation = vx; // r times the separation speed at the midpoint
            if constexpr (is_linear)
              separation =
                remove_slopes(vx, stretch(load_records(gradient, neighbors + k), x), stretch(gradient[i].value, x));
            const Lanes u = max(-separation * inverse_r, zero);
            const Lanes q = 0.5 * (b[6] + S[6]) * u * min(limiter * (b[7] + S[7]) * u, Lanes(1.));

            const Vector3<Lanes> wx(Vw * x[0], Vw * x[1], Vw * x[2]);
            if constexpr (is_corrected)
              {
                sums.add_force(S, q, wx);
                sums.add_moments(wx, x);
                sums.add_gradient(wx, v);
              }
            else
              {
                for (int d = 0; d < 3; ++d)
                  sums.force[d] += (A[7] + q) * wx[d];
                sums.divergence += Vw * vx;
              }
            sums.own[0] += wx[0];
            sums.own[1] += wx[1];
            sums.own[2] += wx[2];
            sums.flux += Vw * r * (a[7] - A[7]) * (b[7] + S[7]);
            sums.heat += Vw * q * vx;
            const auto meets = Vw > zero;
            approach         = max(approach, select(meets, -vx * inverse_r, zero));
            smallest         = min(smallest, select(meets, A[6], smallest));
            closest          = max(closest, Vw);
          }
        store_sums<is_corrected, is_linear>(particles, sums, i);
        const bool is_isolated    = stdx::hmax(closest) <= 0.;
        particles.signal_speed[i] = is_isolated ? 0. : particles.sound_speed[i] + 1.2 * stdx::hmax(approach);
        particles.largest_mu[i]   = particles.mass / (stdx::hmin(smallest) * eos.reference_density()) - 1.;
      }
  }

  template <bool is_corrected, bool is_linear>
  void RiemannRates::store_sums(Particles &particles, const RiemannSums<Lanes> &sums, const std::size_t i) const
  {
    const auto     &b = stress[i].value;
    const double    V = motion[i].value[6], p = motion[i].value[7];
    Vector3<double> own(sum(sums.own[0]), sum(sums.own[1]), sum(sums.own[2]));
    double          divergence, power; // V w v.Bx and p times it
    if constexpr (is_corrected)
      {
        SymmetricTensor B, L, M;
        for (int t = 0; t < 6; ++t)
          {
            B[t] = particles.correction[t][i];
            M[t] = sum(sums.moments[t]);
          }
        Matrix3<double> gradient;
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c)
            gradient(r, c) = sum(sums.gradient[3 * r + c]);
        L          = symmetric_part(gradient);
        own        = multiply(b, own);
        divergence = contract(B, L);
        power      = contract(b, L);
        if constexpr (is_linear)
          L = symmetric_part(gradient * full(B));
        const SymmetricTensor next = compute_correction(M);
        for (int t = 0; t < 6; ++t)
          {
            particles.correction[t][i]        = next[t];
            particles.velocity_gradient[t][i] = is_linear ? L[t] : 0.;
          }
      }
    else
      {
        own *= p;
        divergence = sum(sums.divergence);
        power      = p * divergence;
      }
    for (int d = 0; d < 3; ++d)
      particles.force[d][i] = V * (sum(sums.force[d]) + own[d]);
    // (p_i - p_j)/(Z_i + Z_j) with the mean of 1/Z
    particles.compression_rate[i]     = -(divergence + 0.5 * pressure_share * sum(sums.flux));
    particles.internal_energy_rate[i] = -V * (power + 0.5 * sum(sums.heat));
  }

  void RiemannRates::update(Particles &particles, const Particles::Column &predicted_mu, const NeighborList &list,
                            ThreadPool &pool)
  {
    const std::size_t n = particles.size();
    for (Records *records : {&motion, &stress, &gradient})
      records->resize(n + 1);
    // the dummy that pads the lists: no volume, no pressure, far away
    motion[n].value = {1e10, 1e10, 1e10, 0., 0., 0., 0., 0.};
    stress[n].value = {0., 0., 0., 0., 0., 0., 1., 1.};
    gradient[n].value.fill(0.);
    pool.parallel_for(n, 64, [&](const std::size_t begin, const std::size_t end) {
      std::size_t p = begin;
      for (; p + n_lanes <= end; p += n_lanes)
        if (is_sound(particles, load<Lanes>(&predicted_mu[p]), p))
          update_records<Lanes>(particles, predicted_mu, p);
        else
          report_failed_particle(particles, predicted_mu, p, p + n_lanes);
      for (; p < end; ++p)
        if (is_sound(particles, predicted_mu[p], p))
          update_records<double>(particles, predicted_mu, p);
        else
          report_failed_particle(particles, predicted_mu, p, p + 1);
    });
    const auto &t     = list.period();
    const bool  wraps = t[0] > 0. || t[1] > 0. || t[2] > 0.;
    using Sum         = void (RiemannRates::*)(Particles &, const NeighborList &, std::size_t, std::size_t) const;
    // without correction there are no gradients to reconstruct from
    const Sum sums[2][3] = {{&RiemannRates::sum_pairs<false, false, false>,
                             &RiemannRates::sum_pairs<false, true, false>, &RiemannRates::sum_pairs<false, true, true>},
                            {&RiemannRates::sum_pairs<true, false, false>, &RiemannRates::sum_pairs<true, true, false>,
                             &RiemannRates::sum_pairs<true, true, true>}};
    const Sum sum_all    = sums[wraps][has_correction ? (has_reconstruction ? 2 : 1) : 0];
    pool.parallel_for_balanced(n, 8, list.cost_prefix(), [&](const std::size_t begin, const std::size_t end) {
      (this->*sum_all)(particles, list, begin, end);
    });
  }
} // namespace birdstrike
