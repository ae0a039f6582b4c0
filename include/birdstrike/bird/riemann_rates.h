#pragma once

#include <birdstrike/bird/rates.h>
#include <birdstrike/bird/records.h>
#include <birdstrike/bird/riemann_sums.h>

namespace birdstrike
{
  /// Riemann-based SPH in one fused pass (Vila 1999; limited acoustic solver after Zhang, Hu & Adams 2017).
  ///
  /// With x = x_i - x_j, w = -W'/r >= 0 (grad_i W = -w x), V = m/rho, B = correction matrix, u = approach speed,
  /// Z = rho c, Y = 1/Z and q = (Z_i + Z_j)/2 u min(3 u rho0 (Y_i + Y_j)/2, 1) for u > 0, else 0:
  ///   force_i   =  V_i sum_j V_j w (p_i B_i + p_j B_j + q) x
  ///   div_i     =  sum_j V_j w [ (v_i - v_j).B_i x + r (p_i - p_j)(Y_i + Y_j)/4 ],   compression_rate = -div
  ///   energy_i  = -V_i sum_j V_j w (v_i - v_j).(p_i B_i + q/2) x
  /// Force and divergence are adjoint, so the reversible part exchanges kinetic and internal energy exactly, and the
  /// rest, q, heats. B = (sum_j V_j w x x^T)^-1 makes the divergence of a linear velocity exact up to a free surface
  /// (Bonet & Lok 1999); it is blended to the identity where that sum is near singular (corners of spray), and is
  /// taken from the previous evaluation: geometry changes by a few percent of h a step, and one pass suffices.
  /// Half of the solver's velocity due to the pressure jump enters the divergence (see pressure_share for why not all).
  /// The dissipative terms stay uncorrected and central: they keep angular momentum.
  ///
  /// With reconstruction, u is the jump at the midpoint after removing the harmonic mean (van Leer 1974) of both
  /// particles' velocity gradients.
  class RiemannRates : public Rates
  {
  public:
    RiemannRates(const BirdParameters &parameters, const EquationOfState &eos, double spacing);

    void update(Particles &particles, const Particles::Column &predicted_mu, const NeighborList &list,
                ThreadPool &pool) override;

  private:
    template <class Number>
    void update_records(Particles &particles, const Particles::Column &mu, std::size_t p);

    template <bool is_periodic, bool is_corrected, bool is_linear>
    void sum_pairs(Particles &particles, const NeighborList &list, std::size_t begin, std::size_t end) const;

    template <bool is_corrected, bool is_linear>
    void store_sums(Particles &particles, const RiemannSums<Lanes> &sums, std::size_t i) const;

    EquationOfState eos;
    double          h;
    bool            has_cutoff, has_correction, has_reconstruction;
    Records         motion;   ///< x, v, V, p
    Records         stress;   ///< p B (xx yy zz xy xz yz), Z, 1/Z
    Records         gradient; ///< symmetric velocity gradient (xx yy zz xy xz yz)
  };
} // namespace birdstrike
