#pragma once

#include <birdstrike/bird/bird.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace birdstrike::benchmarks
{
  /// The bird of prm/frontal.prm (cylinder, L/D = 2, 2.5 mm) with as much mass as n particles weigh.
  /// `formulation`: riemann | uncorrected | linear | strong | standard.
  inline BirdParameters make_bird_parameters(const std::size_t n, const std::string &formulation)
  {
    BirdParameters parameters;
    parameters.spacing             = 2.5e-3;
    parameters.mass                = static_cast<double>(n) * parameters.density * std::pow(parameters.spacing, 3);
    parameters.gradient_correction = formulation != "uncorrected";
    parameters.reconstruction      = formulation == "linear" ? Reconstruction::linear : Reconstruction::none;
    parameters.shear_modulus       = formulation == "strong" ? 100e6 : 0.;
    parameters.yield_stress        = 0.01 * parameters.shear_modulus;
    parameters.formulation = formulation == "standard" ? ParticleFormulation::standard : ParticleFormulation::riemann;
    return parameters;
  }

  /// A bird in the flow of an impact: flattened at 2000/s (177 m/s over 89 mm) at constant volume, compressed by about
  /// a thousandth (more would burst it within the hundred steps of a benchmark), so that every branch of the equations
  /// is taken and the list wears out as it does in a strike.
  struct BirdWorkload
  {
    BirdWorkload(const std::size_t n, const std::size_t n_threads, const std::string &formulation = "riemann")
      : pool(n_threads), parameters(make_bird_parameters(n, formulation)), bird(parameters, EosParameters(), pool)
    {
      reset();
    }

    void reset()
    {
      bird.place();
      const Point3 centre = bird.packing().centre;
      const double length = bird.packing().length;
      bird.set_state([&](Point3 &x, Point3 &v, double &mu) {
        const Point3 r = x - centre;
        v += flattening_rate * Point3(0.5 * r[0], 0.5 * r[1], -r[2]);
        mu = 0.001 * (1. + 0.3 * std::sin(20. * r[2] / length));
      });
      step_size = bird.step_limit().value;
    }

    void step()
    {
      bird.kick(0.5 * step_size, HalfKick::first);
      bird.drift(step_size);
      bird.update_neighbor_list();
      bird.compute_rates();
      bird.kick(0.5 * step_size, HalfKick::second);
    }

    std::size_t n() const
    {
      return bird.state().size();
    }

    double support() const
    {
      return 2. * parameters.smoothing_ratio * bird.packing().spacing;
    }

    /// Mean number of other particles within the support, over about 300 particles spread over the bird: by distance,
    /// so that it does not depend on how a list is kept.
    double count_true_neighbors() const
    {
      const Particles  &p      = bird.state();
      const std::size_t stride = n() / 300 + 1;
      std::size_t       found = 0, sampled = 0;
      for (std::size_t i = 0; i < n(); i += stride, ++sampled)
        for (std::size_t j = 0; j < n(); ++j)
          {
            double r2 = 0.;
            for (int d = 0; d < 3; ++d)
              r2 += (p.x[d][i] - p.x[d][j]) * (p.x[d][i] - p.x[d][j]);
            found += j != i && r2 < support() * support();
          }
      return static_cast<double>(found) / static_cast<double>(sampled);
    }

    static constexpr double flattening_rate = 2000.; ///< 1/s

    ThreadPool     pool;
    BirdParameters parameters;
    Bird           bird;
    double         step_size = 0.; ///< s
  };

  /// Neighbour lists alone, on particles that the list may sort.
  struct ListWorkload
  {
    ListWorkload(const std::size_t n, const std::size_t n_threads)
      : source(n, n_threads)
      , particles(source.bird.state())
      , list(source.support(), source.parameters.skin * source.support(), source.bird.packing().period)
    {
      particles.resize(particles.size()); // a copy has lost the slack behind the columns
      list.update(particles, source.pool);
    }

    BirdWorkload source;
    Particles    particles;
    NeighborList list;
  };
} // namespace birdstrike::benchmarks
