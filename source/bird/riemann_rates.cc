#include "bird/riemann_rates.h"
#include "bird/kernel.h"

#include <algorithm>
#include <cmath>

/// The state of a particle as its neighbours see it.
namespace birdstrike
{
  namespace
  {
    constexpr std::size_t chunk_size = 512;

    /// t^3 r <= 27/256 with t = 1 - r/(2h), r in 2h.
    constexpr double largest_slope_moment = 27. / 256.;

    template <class N>
    N largest_row_sum(const std::array<N, 6> &b)
    {
      return max(abs(b[0]) + abs(b[3]) + abs(b[4]),
                 max(abs(b[3]) + abs(b[1]) + abs(b[5]), abs(b[4]) + abs(b[5]) + abs(b[2])));
    }

    double largest(const Lanes &a)
    {
      return stdx::hmax(a);
    }
  } // namespace

  template <class T>
  RiemannRates<T>::RiemannRates(const BirdParameters &parameters, const EquationOfState &eos, const double spacing)
    : eos(eos)
    , h(parameters.smoothing_ratio * spacing)
    , has_cutoff(parameters.tension_cutoff)
    , has_correction(parameters.gradient_correction)
    , has_reconstruction(parameters.reconstruction == Reconstruction::linear)
    , has_strength(parameters.has_strength())
    , strength(parameters)
    , stiffening(strength.stiffening(eos.reference_density()))
    , renewal_interval(parameters.correction_interval)
  {
    scale.length = 2. * h;
    scale.volume = std::sqrt(scale.length * WendlandC2(h).slope_norm);
  }

  template <class T>
  template <class N>
  void RiemannRates<T>::update_records(Particles &particles, const Prediction<N> &prediction, const std::size_t p,
                                       Bounds<N> &bound)
  {
    const N m  = prediction.mu;
    const N p0 = eos.pressure(m), c = max(sqrt(eos.sound_speed_squared(m, p0)), N(slowest_sound));
    const N rho      = eos.reference_density() * (1. + m);
    const N pressure = has_cutoff ? max(p0, N(0.)) : p0;
    // A cavity belongs to nobody: what contact meets is liquid at its reference density.
    const N solid = max(rho, N(eos.reference_density()));
    store(solid, &particles.density[p]);
    store(particles.mass / solid, &particles.volume[p]);
    store(c, &particles.sound_speed[p]);

    const N          Z = rho * c;
    std::array<N, 6> b;
    for (int t = 0; t < 6; ++t)
      b[t] = pressure * (has_correction ? load<N>(&particles.correction[t][p]) : N(t < 3 ? 1. : 0.));
    std::array<N, 16> a;
    for (int d = 0; d < 3; ++d)
      {
        a[d]             = (load<N>(&particles.x[d][p]) - scale.origin[d]) * (1. / scale.length);
        a[4 + d]         = prediction.velocity[d] - scale.velocity[d];
        a[8 + d]         = b[d];
        a[12 + d]        = b[3 + d];
        bound.slowest[d] = min(bound.slowest[d], a[4 + d]);
        bound.fastest[d] = max(bound.fastest[d], a[4 + d]);
      }
    a[3]  = (scale.volume * particles.mass) / rho;
    a[7]  = pressure;
    a[11] = 0.5 * Z;
    a[15] = (1.5 * eos.reference_density()) / Z;
    store_records(a, pairs, p);
    bound.pressure  = max(bound.pressure, largest_row_sum(b));
    bound.impedance = max(bound.impedance, Z);
    bound.volume    = max(bound.volume, a[3]);
    if (has_strength)
      update_stress(particles, p, m, bound);
    else if (has_reconstruction)
      {
        std::array<N, 16> g{};
        for (int t = 0; t < 6; ++t)
          g[t] = load<N>(&particles.velocity_gradient[t][p]) * scale.length;
        store_records(g, gradient, p);
      }
  }

  template <class T>
  template <class N>
  void RiemannRates<T>::update_stress(const Particles &particles, const std::size_t p, const N &mu, Bounds<N> &bound)
  {
    std::array<N, 16> record{};
    if (has_reconstruction)
      for (int t = 0; t < 6; ++t)
        record[t] = load<N>(&particles.velocity_gradient[t][p]) * scale.length;
    std::array<N, 6> S = advance(strength, particles, particles.predicting_velocity_gradient, particles.predicting_spin,
                                 p, mu, prediction_time)
                           .stress;
    std::array<N, 6> B;
    for (int t = 0; t < 6; ++t)
      {
        S[t] *= 1. + mu;
        store(S[t], &stress[t][p]);
        B[t] = load<N>(&particles.shear_correction[t][p]);
      }
    constexpr int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    for (int a = 0; a < 3; ++a)
      {
        N row = 0.;
        for (int b = 0; b < 3; ++b)
          {
            N &entry = record[stress_place + 3 * a + b];
            entry = S[place[a][0]] * B[place[0][b]] + S[place[a][1]] * B[place[1][b]] + S[place[a][2]] * B[place[2][b]];
            row += abs(entry);
          }
        bound.stress = max(bound.stress, row);
      }
    store_records(record, gradient, p);
  }

  template <class T>
  typename RiemannRates<T>::template Bounds<double>
  RiemannRates<T>::update_chunk(Particles &particles, const std::size_t begin, const std::size_t end)
  {
    Bounds<Lanes>  whole;
    Bounds<double> rest;
    sweep(begin, end, [&]<class N>(const N &, const std::size_t p) {
      const Prediction<N> prediction(particles, p, prediction_time);
      if (!is_sound(particles, prediction, p))
        report_failed_particle(particles, prediction_time, p, p + lanes_of<N>);
      if constexpr (std::is_same_v<N, Lanes>)
        update_records(particles, prediction, p, whole);
      else
        update_records(particles, prediction, p, rest);
    });
    rest.pressure  = max(rest.pressure, largest(whole.pressure));
    rest.stress    = max(rest.stress, largest(whole.stress));
    rest.impedance = max(rest.impedance, largest(whole.impedance));
    rest.volume    = max(rest.volume, largest(whole.volume));
    for (int d = 0; d < 3; ++d)
      {
        rest.slowest[d] = min(rest.slowest[d], -largest(-whole.slowest[d]));
        rest.fastest[d] = max(rest.fastest[d], largest(whole.fastest[d]));
      }
    return rest;
  }

  template <class T>
  void RiemannRates<T>::update_images(const MirrorImages &images, ThreadPool &pool)
  {
    const std::size_t first = pairs.size() - images.size();
    pool.parallel_for(images.size(), chunk_size, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
        {
          auto &image = pairs[first + g].value;
          image       = pairs[images.source(g)].value;
          for (const int odd : {1, 5, 12, 14}) // y, v_y, xy, yz
            image[odd] = -image[odd];
          if (has_reconstruction || has_strength)
            {
              auto &L = gradient[first + g].value;
              L       = gradient[images.source(g)].value;
              for (const int odd : {3, 5, stress_place + 1, stress_place + 3, stress_place + 5, stress_place + 7})
                L[odd] = -L[odd];
            }
        }
    });
    for (Bounds<double> &b : bounds) // images move the other way
      if (images.size() > 0)
        {
          b.fastest[1] = std::max(b.fastest[1], -b.slowest[1]);
          b.slowest[1] = -b.fastest[1];
        }
  }

  // |f| <= V_i V_j w r (|p_i B_i| + |p_j B_j| + q) with q <= Z u; as many of these as there are neighbours fit an
  // integer.
  template <class T>
  void RiemannRates<T>::update_force_unit(const std::size_t longest_list)
  {
    Bounds<double> all;
    for (const Bounds<double> &b : bounds)
      {
        all.pressure  = std::max(all.pressure, b.pressure);
        all.stress    = std::max(all.stress, b.stress);
        all.impedance = std::max(all.impedance, b.impedance);
        all.volume    = std::max(all.volume, b.volume);
        for (int d = 0; d < 3; ++d)
          {
            all.slowest[d] = std::min(all.slowest[d], b.slowest[d]);
            all.fastest[d] = std::max(all.fastest[d], b.fastest[d]);
          }
      }
    // at rest and at zero pressure: a billionth of the bulk modulus
    const double c0              = std::max(eos.reference_sound_speed(), slowest_sound),
                 smallest_stress = 1e-9 * eos.reference_density() * c0 * c0;
    const double speed =
      std::hypot(all.fastest[0] - all.slowest[0], all.fastest[1] - all.slowest[1], all.fastest[2] - all.slowest[2]);
    const double stress  = std::max(2. * (all.pressure + all.stress) + all.impedance * speed, smallest_stress);
    const double largest = largest_slope_moment * all.volume * all.volume * stress;
    const double n_terms = static_cast<double>(longest_list) / Number::size() + 1.;
    scale.force          = std::exp2(std::ceil(std::log2(largest * n_terms)) - 30.);
  }

  template <class T>
  void RiemannRates<T>::update(Particles &particles, const double dt, const NeighborList &list, ThreadPool &pool)
  {
    const std::size_t n = particles.size();
    if (n == 0)
      return;
    const MirrorImages &images = list.images();
    prediction_time            = dt;
    pairs.resize(n + 1 + images.size());
    // the dummy that pads the lists: no volume, no pressure, far away
    pairs[n].value = {T(1e9), T(1e9), T(1e9), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    if (has_reconstruction || has_strength)
      {
        gradient.resize(n + 1 + images.size());
        gradient[n].value = {};
      }
    for (auto &column : stress)
      column.resize(has_strength ? n : 0);
    for (int d = 0; d < 3; ++d)
      {
        const bool is_mirrored = images.size() > 0 && d == 1; // an image's record then differs in signs alone
        scale.origin[d]        = is_mirrored ? 0. : particles.x[d][0];
        scale.velocity[d]      = is_mirrored ? 0. : particles.v[d][0];
      }
    bounds.resize((n + chunk_size - 1) / chunk_size);
    pool.parallel_for(bounds.size(), 1, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        bounds[c] = update_chunk(particles, c * chunk_size, std::min(n, (c + 1) * chunk_size));
    });
    update_images(images, pool);
    update_force_unit(list.longest());
    is_renewing       = passes_to_renewal == 0;
    passes_to_renewal = is_renewing ? renewal_interval - 1 : passes_to_renewal - 1;
    pool.parallel_for_balanced(n, 8, list.cost_prefix(), [&](const std::size_t begin, const std::size_t end) {
      sum_range(particles, list, begin, end);
    });
  }

  template class RiemannRates<float>;
  template class RiemannRates<double>;
} // namespace birdstrike
