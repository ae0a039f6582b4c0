#include "bird/correction.h"
#include "bird/riemann_rates.h"
#include "bird/symmetric_tensor.h"
#include <birdstrike/core/simd/inverse_root.h>

#include <algorithm>

/// The sums over pairs of the Riemann-based formulation.
namespace birdstrike
{
  namespace
  {
    /// Share of the acoustic solver's velocity (p_i - p_j)/(Z_i + Z_j) that enters the divergence. Measured on plane
    /// shocks of 177 m/s at Courant number 0.5: with 1 the predictor is unstable and the shock slow; with 0.5 plateaus
    /// are within 0.8 % and overshoots 0-5 %; with 0.2, 5-20 %; with 0, 40-70 % and chequered pressure.
    constexpr double pressure_share = 0.5;
    /// Largest flux of a soft bird over the acoustic solver's: see RiemannRates.
    constexpr double largest_flux = 3.;
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

    /// What a pass computes: one kernel each.
    template <bool soft, bool periodic, bool corrected, bool linear = false, bool renewing = true, bool strong = false>
    struct Variant
    {
      static constexpr bool is_soft = soft, is_periodic = periodic, is_corrected = corrected, is_linear = linear,
                            is_renewing = renewing, is_strong = strong;
    };

    /// Symmetric part of the velocity gradient g B, g: xx yy zz, xy xz yz, yx zx zy, and its spin with strength.
    template <bool is_strong, class N>
    std::array<N, 6> store_velocity_gradient(Particles &particles, const std::array<N, 9> &g, const std::array<N, 6> &B,
                                             const std::size_t i)
    {
      const N gradient[3][3]   = {{g[0], g[3], g[4]}, {g[6], g[1], g[5]}, {g[7], g[8], g[2]}};
      const N correction[3][3] = {{B[0], B[3], B[4]}, {B[3], B[1], B[5]}, {B[4], B[5], B[2]}};
      N       L[3][3];
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          L[r][c] =
            gradient[r][0] * correction[0][c] + gradient[r][1] * correction[1][c] + gradient[r][2] * correction[2][c];
      const std::array<N, 6> symmetric{
        L[0][0], L[1][1], L[2][2], 0.5 * (L[0][1] + L[1][0]), 0.5 * (L[0][2] + L[2][0]), 0.5 * (L[1][2] + L[2][1])};
      for (int t = 0; t < 6; ++t)
        store(symmetric[t], &particles.velocity_gradient[t][i]);
      if constexpr (is_strong)
        for (int d = 0; d < 3; ++d)
          store(0.5 * (L[(d + 2) % 3][(d + 1) % 3] - L[(d + 1) % 3][(d + 2) % 3]), &particles.spin[d][i]);
      return symmetric;
    }

    /// Strain rates and spin as stresses are strained, and S : D, W/m^3.
    template <class N>
    N store_strain_rates(Particles &particles, const std::array<N, 9> &g,
                         const std::array<Particles::Column, 6> &stress, const std::size_t i)
    {
      std::array<N, 6> B, S;
      for (int t = 0; t < 6; ++t)
        {
          B[t] = load<N>(&particles.shear_correction[t][i]);
          S[t] = load<N>(&stress[t][i]);
        }
      return contract(S, store_velocity_gradient<true>(particles, g, B, i));
    }

    /// The pair's S_i B_i + S_j B_j times wx, of records that have them from `first` on by rows.
    template <class T, class Number>
    [[gnu::always_inline]] inline Vector3<Number> multiply_rows(const std::array<T, 16>      &a,
                                                                const std::array<Number, 16> &A, const int first,
                                                                const Vector3<Number> &wx)
    {
      Vector3<Number> product;
      for (int d = 0; d < 3; ++d)
        {
          const int r = first + 3 * d;
          product[d]  = (a[r] + A[r]) * wx[0] + (a[r + 1] + A[r + 1]) * wx[1] + (a[r + 2] + A[r + 2]) * wx[2];
        }
      return product;
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
  template <class Variant>
  void RiemannRates<T>::sum_neighbors(const NeighborList &list, const std::size_t i, SumBlock &block) const
  {
    const Number               zero(0), one(1);
    const auto                &a    = pairs[i].value;
    const T                    unit = static_cast<T>(1. / scale.force), V = a[3] * unit; // a power of two: exact
    const T                    flux_unit = static_cast<T>(largest_flux * 3. * eos.reference_density());
    ForceSum<T>                force;
    PairSums<Number>           sums;
    Number                     approach = zero, smallest = a[3];
    const std::uint32_t *const neighbors = list.neighbors(i);
    std::array<T, 3>           period{};
    if constexpr (Variant::is_periodic)
      for (int d = 0; d < 3; ++d)
        period[d] = static_cast<T>(list.period()[d] / scale.length);
    for (std::size_t k = 0; k < list.padded_count(i); k += Number::size())
      {
        const auto            A = load_records(pairs, neighbors + k);
        Vector3<Number>       x(a[0] - A[0], a[1] - A[1], a[2] - A[2]);
        const Vector3<Number> v(a[4] - A[4], a[5] - A[5], a[6] - A[6]);
        if constexpr (Variant::is_periodic)
          for (int d = 0; d < 3; ++d)
            if (period[d] > 0)
              x[d] -= period[d] * stdx::nearbyint(x[d] * (1 / period[d]));
        const Number r2        = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + T(smallest_distance2);
        const Number inverse_r = inverse_root(r2), r = r2 * inverse_r, t = max(one - r, zero);
        const Number w          = V * A[3] * t * t * t;
        const Number vx         = v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
        Number       separation = vx; // r times the separation speed at the midpoint
        if constexpr (Variant::is_linear)
          separation =
            remove_slopes(vx, stretch(load_records(gradient, neighbors + k), x), stretch(gradient[i].value, x));
        const Number u = max(-separation * inverse_r, zero), Y = a[15] + A[15];
        const Number q = (a[11] + A[11]) * u * min(Y * u, one);

        const Vector3<Number> wx(w * x[0], w * x[1], w * x[2]);
        if constexpr (Variant::is_corrected)
          {
            Vector3<Number> f = multiply_stress(a, A, q, wx);
            if constexpr (Variant::is_strong)
              f -= multiply_rows(gradient[i].value, load_records(gradient, neighbors + k), stress_place, wx);
            force.add(f);
            sums.add_gradient(wx, v);
          }
        else
          {
            const Number s = a[7] + A[7] + q;
            force.add({s * wx[0], s * wx[1], s * wx[2]});
            sums.mean[0] += w * vx;
          }
        if constexpr (Variant::is_renewing)
          {
            sums.add_moments(wx, x);
            smallest = min(smallest, select(t > zero, A[3], smallest));
          }
        Number by = Y;
        if constexpr (Variant::is_soft)
          by = min(by, flux_unit / (a[11] + A[11]));
        sums.flux() += w * r * ((a[7] - A[7]) * by);
        sums.heat() += w * q * vx;
        sums.weight() += w;
        approach = max(approach, select(t > zero, Variant::is_linear ? max(-vx * inverse_r, zero) : u, zero));
      }
    block.store(SumBlock::force, i % n_lanes, force.value());
    block.store(SumBlock::gradient, i % n_lanes, sum_lanes<T>(sums.mean));
    if constexpr (Variant::is_renewing)
      block.store(SumBlock::moments, i % n_lanes, sum_lanes<T>(sums.moments));
    const std::size_t lane                = i % n_lanes;
    block.value[SumBlock::approach][lane] = static_cast<double>(stdx::hmax(approach));
    if constexpr (Variant::is_renewing)
      block.value[SumBlock::smallest][lane] = static_cast<double>(stdx::hmin(smallest));
    block.value[SumBlock::pressure][lane] = static_cast<double>(a[7]);
    block.value[SumBlock::volume][lane]   = static_cast<double>(a[3]);
  }

  // Sums come in units of the force unit with the particle's own volume in them.
  template <class T>
  template <class Variant, class N>
  void RiemannRates<T>::store_rates(Particles &particles, const SumBlock &block, const std::size_t i) const
  {
    const auto          sum    = [&](const int component) { return block.get<N>(component, i % n_lanes); };
    const N             volume = sum(SumBlock::volume) * (1. / scale.volume), pressure = sum(SumBlock::pressure);
    const N             by_volume = scale.force / volume;
    const Prediction<N> prediction(particles, i, prediction_time); // as its neighbours see it
    N                   work = 0.;
    for (int d = 0; d < 3; ++d)
      {
        const N force = scale.force * sum(SumBlock::force + d);
        work += force * prediction.velocity[d];
        store(force, &particles.force[d][i]);
      }

    std::array<N, 9> g;
    for (int k = 0; k < 9; ++k)
      g[k] = by_volume * sum(SumBlock::gradient + k);
    N divergence = g[0]; // V w v.Bx
    if constexpr (Variant::is_corrected)
      {
        std::array<N, 6> B;
        for (int t = 0; t < 6; ++t)
          B[t] = load<N>(&particles.correction[t][i]);
        divergence =
          B[0] * g[0] + B[1] * g[1] + B[2] * g[2] + B[3] * (g[3] + g[6]) + B[4] * (g[4] + g[7]) + B[5] * (g[5] + g[8]);
        if constexpr (Variant::is_strong)
          work += volume * store_strain_rates(particles, g, stress, i);
        else if constexpr (Variant::is_linear)
          store_velocity_gradient<false>(particles, g, B, i);
        if constexpr (Variant::is_renewing)
          {
            std::array<N, 6> M;
            for (int t = 0; t < 6; ++t)
              M[t] = (by_volume * scale.length) * sum(SumBlock::moments + t);
            const auto next = compute_correction(M);
            for (int t = 0; t < 6; ++t)
              store(next[t], &particles.correction[t][i]);
            if constexpr (Variant::is_strong)
              {
                const auto of_shear = compute_shear_correction(M);
                for (int t = 0; t < 6; ++t)
                  store(of_shear[t], &particles.shear_correction[t][i]);
              }
          }
      }
    // (p_i - p_j)/(Z_i + Z_j), times 6 rho0; of a bird that is not soft with the mean of 1/Z
    const N flux       = by_volume * (1. / (1.5 * eos.reference_density())) * sum(SumBlock::flux);
    const N flux_share = (0.5 * pressure_share) * flux, heat = (-0.5 * scale.force) * sum(SumBlock::heat);
    store(-(divergence + flux_share), &particles.compression_rate[i]);
    store(work - volume * pressure * divergence + heat, &particles.power[i]);
    store(heat + volume * pressure * flux_share, &particles.dissipation[i]);
    const N c       = load<N>(&particles.sound_speed[i]);
    const N fastest = (Variant::is_strong ? N(sqrt(c * c + stiffening)) : c) + 1.2 * sum(SumBlock::approach);
    store(select(sum(SumBlock::weight) > N(0.), fastest, N(0.)), &particles.signal_speed[i]);
    store(compute_prediction_error<N>(particles, i, prediction_time,
                                      has_cutoff ? select(prediction.mu < N(0.), N(0.), c) : c),
          &particles.prediction_error[i]);
    if constexpr (Variant::is_renewing)
      store(particles.mass * scale.volume / (eos.reference_density() * sum(SumBlock::smallest)) - 1.,
            &particles.largest_mu[i]);
  }

  template <class T>
  template <class Variant>
  void RiemannRates<T>::sum_pairs(Particles &particles, const NeighborList &list, const std::size_t begin,
                                  const std::size_t end) const
  {
    SumBlock block;
    for (std::size_t first = begin; first < end; first += n_lanes)
      {
        const std::size_t last = std::min(end, first + n_lanes);
        for (std::size_t i = first; i < last; ++i)
          sum_neighbors<Variant>(list, i, block);
        if (last - first == n_lanes)
          store_rates<Variant, Lanes>(particles, block, first);
        else
          for (std::size_t i = first; i < last; ++i)
            store_rates<Variant, double>(particles, block, i);
      }
  }

  // Without correction there are no gradients to reconstruct from; periodic cells are for verification.
  template <class T>
  template <bool soft, bool wraps>
  auto RiemannRates<T>::choose_sum() const -> Sum
  {
    if (has_strength)
      return has_reconstruction ? &RiemannRates::sum_pairs<Variant<soft, wraps, true, true, true, true>>
                                : &RiemannRates::sum_pairs<Variant<soft, wraps, true, false, true, true>>;
    if (!has_correction)
      return &RiemannRates::sum_pairs<Variant<soft, wraps, false>>;
    if (has_reconstruction)
      return &RiemannRates::sum_pairs<Variant<soft, wraps, true, true>>;
    return is_renewing ? &RiemannRates::sum_pairs<Variant<soft, wraps, true>>
                       : &RiemannRates::sum_pairs<Variant<soft, wraps, true, false, wraps>>;
  }

  template <class T>
  void RiemannRates<T>::sum_range(Particles &particles, const NeighborList &list, const std::size_t begin,
                                  const std::size_t end) const
  {
    const auto &t     = list.period();
    const bool  wraps = t[0] > 0. || t[1] > 0. || t[2] > 0.;
    const Sum   soft  = wraps ? choose_sum<true, true>() : choose_sum<true, false>();
    const Sum   other = wraps ? choose_sum<false, true>() : choose_sum<false, false>();
    (this->*(slowest_sound > 0. ? soft : other))(particles, list, begin, end);
  }

  template void RiemannRates<float>::sum_range(Particles &, const NeighborList &, std::size_t, std::size_t) const;
  template void RiemannRates<double>::sum_range(Particles &, const NeighborList &, std::size_t, std::size_t) const;
} // namespace birdstrike
