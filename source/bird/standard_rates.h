#pragma once

#include <birdstrike/bird/rates.h>
#include <birdstrike/core/simd/records.h>

namespace birdstrike
{
  /// The seed's SPH (Monaghan 1992), with x = x_i - x_j, w = -W'/r (grad_i W = -w x):
  ///   density   rho_i = k sum_j m W_ij (own term included; k makes an infinite lattice exact),
  ///             or    d rho_i/dt = -m sum_j w v_ij.x
  ///   force_i   =  m^2 sum_j (p_i/rho_i^2 + p_j/rho_j^2 + Pi_ij) w x
  ///   energy_i  = -m^2/2 sum_j (p_i/rho_i^2 + p_j/rho_j^2 + Pi_ij) w v_ij.x
  ///   Pi_ij     = (-alpha c phi + beta phi^2)/rho, phi = h v_ij.x/(r^2 + 0.01 h^2) where v_ij.x < 0, else Pi = 0,
  /// c and rho being means of the pair. Central forces: angular momentum to round-off. No correction at free surfaces.
  class StandardRates : public Rates
  {
  public:
    StandardRates(const BirdParameters &parameters, const EquationOfState &eos, double spacing);

    void update(Particles &particles, double dt, const NeighborList &list, ThreadPool &pool) override;

  private:
    template <class Number>
    void update_records(Particles &particles, const Number &mu, std::size_t p);

    template <class Kernel, bool is_periodic>
    void sum_densities(Particles &particles, const NeighborList &list, std::size_t begin, std::size_t end) const;

    template <class Kernel, bool is_periodic>
    void sum_pairs(Particles &particles, const NeighborList &list, std::size_t begin, std::size_t end) const;

    EquationOfState    eos;
    double             spacing, h, alpha, beta;
    bool               has_cutoff, has_summation, is_spline, is_fcc;
    double             prediction_time = 0.; ///< s
    Records<double, 8> motion;               ///< x, v, rho, p/rho^2
    Records<double, 8> sound;                ///< c
  };
} // namespace birdstrike
