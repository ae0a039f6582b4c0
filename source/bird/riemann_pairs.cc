#include <birdstrike/bird/correction.h>
#include <birdstrike/bird/riemann_rates.h>
#include <birdstrike/bird/symmetric_tensor.h>

#include <cmath>

/// The sums over pairs of the Riemann-based formulation.
namespace birdstrike
{
  namespace
  {
    /// Share of the acoustic solver's velocity (p_i - p_j)/(Z_i + Z_j) that enters the divergence. Measured on plane
    /// shocks of 177 m/s at Courant number 0.5: with 1 the predictor is unstable and the shock slow; with 0.5 plateaus
    /// are within 0.8 % and overshoots 0-5 %; with 0.2, 5-20 %; with 0, 40-70 % and chequered pressure.
    constexpr double pressure_share = 0.5;
    /// Added to r^2, in 4h^2: keeps 1/r finite for a particle that meets its own image or another in one place.
    constexpr double smallest_distance2 = 1e-20;

    /// The jump v.x less the harmonic mean of both sides' slopes (van Leer 1974) where all agree in sign, else the
    /// jump; never beyond zero.
    template <class Number>
    [[gnu::always_inline]] inline Number remove_slopes(const Number &jump, const Number &a, const Number &b)
    {
      const Number zero(0), product = a * b;
      const auto   agree = product > zero;
      const Number mean  = select(agree, (product + product) / select(agree, a + b, Number(1)), zero);
      return select(mean * jump > zero, select(stdx::abs(mean) < stdx::abs(jump), jump - mean, zero), jump);
    }

    /// a + b for tensors stored as in a record: the pair's p_i B_i + p_j B_j, and q on the diagonal, times wx.
    template <class T, class Number>
    [[gnu::always_inline]] inline Vector3<Number> multiply_stress(const std::array<T, 16>      &a,
                                                                  const std::array<Number, 16> &A, const Number &q,
                                                                  const Vector3<Number> &wx)
    {
      const Number xx = a[8] + A[8] + q, yy = a[9] + A[9] + q, zz = a[10] + A[10] + q;
      const Number xy = a[12] + A[12], xz = a[13] + A[13], yz = a[14] + A[14];
      return {xx * wx[0] + xy * wx[1] + xz * wx[2], xy * wx[0] + yy * wx[1] + yz * wx[2],
              xz * wx[0] + yz * wx[1] + zz * wx[2]};
    }
  } // namespace

  // The pair loop: one register of neighbours at a time, every sum of the formulation in one sweep. Longer than other
  // functions because its intermediate values live in registers and are used by several sums. Each pair force is the
  // same, with opposite sign, to the last bit when its partner computes it: every operation is symmetric.
  template <class T>
  template <bool is_periodic, bool is_corrected, bool is_linear, bool is_renewing>
  void RiemannRates<T>::sum_pairs(Particles &particles, const NeighborList &list, const std::size_t begin,
                                  const std::size_t end) const
  {
    const Number     zero(0), one(1);
    const T          unit = static_cast<T>(1. / scale.force); // a power of two: exact
    std::array<T, 3> period;
    for (int d = 0; d < 3; ++d)
      period[d] = static_cast<T>(list.period()[d] / scale.length);
    for (std::size_t i = begin; i < end; ++i)
      {
        const auto                &a = pairs[i].value;
        const T                    V = a[3] * unit;
        ForceSum<T>                force;
        PairSums<Number>           sums;
        Number                     approach = zero, smallest = a[3];
        const std::uint32_t *const neighbors = list.neighbors(i);
        for (std::size_t k = 0; k < list.padded_count(i); k += Number::size())
          {
            const auto            A = load_records(pairs, neighbors + k);
            Vector3<Number>       x(a[0] - A[0], a[1] - A[1], a[2] - A[2]);
            const Vector3<Number> v(a[4] - A[4], a[5] - A[5], a[6] - A[6]);
            if constexpr (is_periodic)
              for (int d = 0; d < 3; ++d)
                if (period[d] > 0)
                  x[d] -= period[d] * stdx::nearbyint(x[d] * (1 / period[d]));
            const Number r2        = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + T(smallest_distance2);
            const Number inverse_r = inverse_sqrt<T>(r2), r = r2 * inverse_r, t = max(one - r, zero);
            const Number w          = V * A[3] * t * t * t;
            const Number vx         = v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
            Number       separation = vx; // r times the separation speed at the midpoint
            if constexpr (is_linear)
              separation =
                remove_slopes(vx, stretch(load_records(gradient, neighbors + k), x), stretch(gradient[i].value, x));
            const Number u = max(-separation * inverse_r, zero), Y = a[15] + A[15];
            const Number q = (a[11] + A[11]) * u * min(Y * u, one);

            const Vector3<Number> wx(w * x[0], w * x[1], w * x[2]);
            if constexpr (is_corrected)
              {
                force.add(multiply_stress(a, A, q, wx));
                sums.add_gradient(wx, v);
              }
            else
              {
                const Number s = a[7] + A[7] + q;
                force.add({s * wx[0], s * wx[1], s * wx[2]});
                sums.mean[0] += w * vx;
              }
            if constexpr (is_renewing)
              {
                sums.add_moments(wx, x);
                smallest = min(smallest, select(t > zero, A[3], smallest));
              }
            sums.mean[sums.flux] += w * r * ((a[7] - A[7]) * Y);
            sums.mean[sums.heat] += w * q * vx;
            sums.mean[sums.weight] += w;
            approach = max(approach, select(t > zero, is_linear ? max(-vx * inverse_r, zero) : u, zero));
          }
        const auto f = force.value();
        for (int d = 0; d < 3; ++d)
          particles.force[d][i] = scale.force * f[d];
        store_sums<is_corrected, is_linear, is_renewing>(particles, sums, i);
        const bool is_isolated    = particles.signal_speed[i] == 0.;
        particles.signal_speed[i] = is_isolated ? 0. : particles.sound_speed[i] + 1.2 * stdx::hmax(approach);
        if constexpr (is_renewing)
          particles.largest_mu[i] =
            particles.mass * scale.volume / (stdx::hmin(smallest) * eos.reference_density()) - 1.;
      }
  }

  // Sums come in units of the force unit with the particle's own volume in them.
  template <class T>
  template <bool is_corrected, bool is_linear, bool is_renewing>
  void RiemannRates<T>::store_sums(Particles &particles, const PairSums<Number> &sums, const std::size_t i) const
  {
    const auto   s        = sum_lanes<T>(sums.mean);
    const double pressure = static_cast<double>(pairs[i].value[7]);
    const double volume = static_cast<double>(pairs[i].value[3]) / scale.volume, by_volume = scale.force / volume;
    double       divergence = by_volume * s[0], power = pressure * divergence; // V w v.Bx and p times it
    if constexpr (is_corrected)
      {
        SymmetricTensor B;
        for (int t = 0; t < 6; ++t)
          B[t] = particles.correction[t][i];
        Matrix3<double> gradient;
        gradient << s[0], s[3], s[4], s[6], s[1], s[5], s[7], s[8], s[2];
        gradient *= by_volume;
        divergence = contract(B, symmetric_part(gradient));
        power      = pressure * divergence;
        if constexpr (is_linear)
          {
            const SymmetricTensor L = symmetric_part(gradient * full(B));
            for (int t = 0; t < 6; ++t)
              particles.velocity_gradient[t][i] = L[t];
          }
        if constexpr (is_renewing)
          {
            SymmetricTensor M = sum_lanes<T>(sums.moments);
            for (double &m : M)
              m *= by_volume * scale.length;
            const SymmetricTensor next = compute_correction(M);
            for (int t = 0; t < 6; ++t)
              particles.correction[t][i] = next[t];
          }
      }
    // (p_i - p_j)/(Z_i + Z_j) with the mean of 1/Z, which records hold times 3/2 rho0
    const double flux                 = by_volume / (1.5 * eos.reference_density()) * s[sums.flux];
    particles.compression_rate[i]     = -(divergence + 0.5 * pressure_share * flux);
    particles.internal_energy_rate[i] = -(volume * power + 0.5 * scale.force * s[sums.heat]);
    particles.signal_speed[i]         = s[sums.weight]; // 0 if isolated
  }

  template <class T>
  void RiemannRates<T>::sum_range(Particles &particles, const NeighborList &list, const std::size_t begin,
                                  const std::size_t end) const
  {
    const auto &period = list.period();
    const bool  wraps  = period[0] > 0. || period[1] > 0. || period[2] > 0.;
    using Sum          = void (RiemannRates::*)(Particles &, const NeighborList &, std::size_t, std::size_t) const;
    // without correction there are no gradients to reconstruct from; periodic cells are for verification
    const Sum every_pass[2][3] = {
      {&RiemannRates::sum_pairs<false, false, false, true>, &RiemannRates::sum_pairs<false, true, false, true>,
       &RiemannRates::sum_pairs<false, true, true, true>},
      {&RiemannRates::sum_pairs<true, false, false, true>, &RiemannRates::sum_pairs<true, true, false, true>,
       &RiemannRates::sum_pairs<true, true, true, true>}};
    const bool is_keeping = !wraps && has_correction && !has_reconstruction && !is_renewing;
    const Sum  sum        = is_keeping ? &RiemannRates::sum_pairs<false, true, false, false>
                                       : every_pass[wraps][has_correction ? (has_reconstruction ? 2 : 1) : 0];
    (this->*sum)(particles, list, begin, end);
  }

  template void RiemannRates<float>::sum_range(Particles &, const NeighborList &, std::size_t, std::size_t) const;
  template void RiemannRates<double>::sum_range(Particles &, const NeighborList &, std::size_t, std::size_t) const;
} // namespace birdstrike
