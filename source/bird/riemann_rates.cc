#include <birdstrike/bird/correction.h>
#include <birdstrike/bird/kernel.h>
#include <birdstrike/bird/riemann_rates.h>

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
    /// Row of a symmetric tensor times a vector.
    template <class Tensor, class Number>
    Vector3<Number> multiply(const Tensor &t, const Vector3<Number> &x)
    {
      return {t[0] * x[0] + t[3] * x[1] + t[4] * x[2], t[3] * x[0] + t[1] * x[1] + t[5] * x[2],
              t[4] * x[0] + t[5] * x[1] + t[2] * x[2]};
    }

    double sum(const Lanes &a)
    {
      return stdx::reduce(a);
    }
  } // namespace

  RiemannRates::RiemannRates(const BirdParameters &parameters, const EquationOfState &eos, const double spacing)
    : eos(eos)
    , h(parameters.smoothing_ratio * spacing)
    , support(2. * h)
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
        b[7] = lane(rho, k);
      }
  }

  // The pair loop: one register of neighbours at a time, every sum of the formulation in one sweep. Longer than other
  // functions because its intermediate values live in registers and are used by several sums.
  template <bool is_periodic, bool is_corrected, bool is_linear>
  void RiemannRates::sum_pairs(Particles &particles, const NeighborList &list, const std::size_t begin,
                               const std::size_t end) const
  {
    const WendlandC2 kernel(h);
    const Period     period = list.period();
    const Lanes      zero   = 0.;
    for (std::size_t i = begin; i < end; ++i)
      {
        const auto          &a = motion[i].value, &b = stress[i].value;
        SymmetricTensor      B{1., 1., 1., 0., 0., 0.}, moments{};
        std::array<Lanes, 6> M{}, L{};
        Vector3<Lanes>       force(zero, zero, zero), own(zero, zero, zero); // sums of V w (p_j B_j + q) x and V w x
        Lanes                div = 0., flux = 0., heat = 0., approach = 0., closest = 0., densest = 0.;
        if constexpr (is_corrected)
          for (int t = 0; t < 6; ++t)
            B[t] = particles.correction[t][i];
        const std::uint32_t *const neighbors = list.neighbors(i);
        for (std::size_t k = 0; k < list.padded_count(i); k += n_lanes)
          {
            const auto     A = load_records(motion, neighbors + k), S = load_records(stress, neighbors + k);
            Vector3<Lanes> x, v;
            for (int d = 0; d < 3; ++d)
              {
                x[d] = a[d] - A[d];
                v[d] = a[3 + d] - A[3 + d];
                if constexpr (is_periodic)
                  if (period[d] > 0.)
                    x[d] -= period[d] * stdx::nearbyint(x[d] * (1. / period[d]));
              }
            const Lanes r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + 1e-60, inverse_r = 1. / sqrt(r2);
            const Lanes r = r2 * inverse_r, w = kernel.slope(r), Vw = A[6] * w;
            const Lanes vx        = v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
            const Lanes inverse_Z = 1. / (b[6] + S[6]);
            Lanes       jump      = vx; // r times the separation speed at the midpoint
            if constexpr (is_linear)
              {
                const auto           G  = load_records(gradient, neighbors + k);
                const Vector3<Lanes> gx = multiply(G, x), ix = multiply(gradient[i].value, x);
                const Lanes          sj      = gx[0] * x[0] + gx[1] * x[1] + gx[2] * x[2];
                const Lanes          si      = ix[0] * x[0] + ix[1] * x[1] + ix[2] * x[2];
                const Lanes          product = si * sj, slopes = si + sj;
                // harmonic mean of the slopes, where both and the jump agree in sign; never beyond the jump itself
                const Lanes mean =
                  select(product > zero, 2. * product / select(product > zero, slopes, Lanes(1.)), zero);
                jump = select(mean * vx > zero, select(stdx::abs(mean) < stdx::abs(vx), vx - mean, zero), vx);
              }
            const Lanes u = max(-jump * inverse_r, zero);
            const Lanes q = 2. * b[6] * S[6] * inverse_Z * u * min(3. * u * (b[7] + S[7]) * inverse_Z, Lanes(1.));
            if constexpr (is_corrected)
              {
                const Vector3<Lanes> Bx = multiply(B, x);
                div += Vw * (v[0] * Bx[0] + v[1] * Bx[1] + v[2] * Bx[2]);
                const Vector3<Lanes> Sx = multiply(S, x);
                for (int d = 0; d < 3; ++d)
                  force[d] += Vw * (Sx[d] + q * x[d]);
                for (int t = 0; t < 6; ++t)
                  {
                    constexpr int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
                    M[t] += Vw * x[row[t]] * x[column[t]];
                    if constexpr (is_linear)
                      L[t] += (0.5 * Vw) * (v[row[t]] * Bx[column[t]] + v[column[t]] * Bx[row[t]]);
                  }
              }
            else
              {
                div += Vw * vx;
                for (int d = 0; d < 3; ++d)
                  force[d] += Vw * (A[7] + q) * x[d];
              }
            for (int d = 0; d < 3; ++d)
              own[d] += Vw * x[d];
            flux += Vw * r * (a[7] - A[7]) * inverse_Z;
            heat += Vw * q * vx;
            const auto meets = Vw > zero;
            approach         = max(approach, select(meets, -vx * inverse_r, zero));
            densest          = max(densest, select(meets, S[7], zero));
            closest          = max(closest, Vw);
          }
        const double    V = a[6], p = a[7];
        Vector3<double> pressed(p * sum(own[0]), p * sum(own[1]), p * sum(own[2]));
        if constexpr (is_corrected)
          pressed = multiply(B, pressed);
        for (int d = 0; d < 3; ++d)
          particles.force[d][i] = V * (sum(force[d]) + pressed[d]);
        const double divergence = sum(div);
        particles.mu_rate[i]    = -(divergence + 2. * pressure_share * sum(flux)) * b[7] / eos.reference_density();
        particles.internal_energy_rate[i] = -V * (p * divergence + 0.5 * sum(heat));
        const bool is_isolated            = stdx::hmax(closest) <= 0.;
        particles.signal_speed[i]         = is_isolated ? 0. : particles.sound_speed[i] + 1.2 * stdx::hmax(approach);
        particles.largest_mu[i]           = std::max(b[7], stdx::hmax(densest)) / eos.reference_density() - 1.;
        if constexpr (is_corrected)
          {
            for (int t = 0; t < 6; ++t)
              moments[t] = sum(M[t]);
            const SymmetricTensor next = compute_correction(moments);
            for (int t = 0; t < 6; ++t)
              {
                particles.correction[t][i]        = next[t];
                particles.velocity_gradient[t][i] = is_linear ? sum(L[t]) : 0.;
              }
          }
      }
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
