#pragma once

#include "bird/riemann_sums.h"
#include "bird/strength.h"
#include <birdstrike/bird/rates.h>
#include <birdstrike/core/simd/records.h>

namespace birdstrike
{
  /// Riemann-based SPH in one fused pass (Vila 1999; limited acoustic solver after Zhang, Hu & Adams 2017).
  ///
  /// With x = x_i - x_j, w = -W'/r >= 0 (grad_i W = -w x), V = m/rho, B = correction matrix, u = approach speed,
  /// Z = rho c, Y = 1/Z and q = (Z_i + Z_j)/2 u min(3 u rho0 (Y_i + Y_j)/2, 1) for u > 0, else 0:
  ///   force_i   =  V_i sum_j V_j w (p_i B_i + p_j B_j + q) x
  ///   div_i     =  sum_j V_j w [ (v_i - v_j).B_i x + r (p_i - p_j)(Y_i + Y_j)/4 ],   compression_rate = -div
  ///   energy_i  = -V_i sum_j V_j w (v_i - v_j).(p_i B_i + q/2) x
  ///   heat_i    = -V_i sum_j V_j w (v_i - v_j).x q/2 + V_i p_i sum_j V_j w r (p_i - p_j)(Y_i + Y_j)/4 (`dissipation`)
  /// Force and divergence are adjoint, so the reversible part exchanges kinetic and internal energy exactly, and the
  /// rest heats: q, and what the flux in the divergence takes of the energy that density stores (summed over a pair
  /// V_i V_j w r (p_i - p_j)^2 (Y_i + Y_j)/4, never negative). B = (sum_j V_j w x x^T)^-1 makes the divergence of a
  /// linear velocity exact up to a free surface (Bonet & Lok 1999); it is blended to the identity where that sum is
  /// near singular (corners of spray). It is taken from an earlier evaluation, renewed every few passes: geometry
  /// changes by a percent of h a step. Half of the solver's velocity due to the pressure jump enters the divergence
  /// (see pressure_share for why not all). The dissipative terms stay uncorrected and central: they keep angular
  /// momentum.
  ///
  /// With strength, S_i the deviatoric stress, B_i that of compute_shear_correction and
  /// L_i = sum_j V_j w (v_i - v_j) (B_i x)^T the velocity gradient,
  ///   force_i -= V_i sum_j V_j w (S_i B_i + S_j B_j) x,   energy_i += V_i S_i : L_i
  /// adjoint as the pressure's; torques cancel as far as B makes L exact. Signals run with sqrt(c^2 + 4 G/(3 rho)),
  /// impedances stay the bulk's: beyond yield, which is far below a shock's pressure, waves have its speed.
  ///
  /// (Y_i + Y_j)/4 stands for 1/(Z_i + Z_j) without a division; where Z differs it is (Z_i + Z_j)^2/(4 Z_i Z_j) times
  /// as much, five to twelve where one particle's pores are closed and its neighbours' are open. Its pressure would
  /// leave by the flux in less than a step, and what the next one foretells is a particle without pressure, which is
  /// compressed on (measured: 21 % of all energy, at one particle). So the flux of soft birds
  /// (Rates::set_slowest_sound) is at most three times the acoustic solver's: shocks in a tenth of pores stay as they
  /// are, with once it they ring by 53 instead of 38 %.
  ///
  /// With reconstruction, u is the jump at the midpoint after removing the harmonic mean (van Leer 1974) of both
  /// particles' velocity gradients.
  ///
  /// T is the number type of a pair; state, rates and all that is added up over time are double. In float a pair sees
  /// positions and velocities relative to one particle, and forces cancel exactly all the same (ForceSum).
  template <class T>
  class RiemannRates : public Rates
  {
  public:
    RiemannRates(const BirdParameters &parameters, const EquationOfState &eos, double spacing);

    void update(Particles &particles, double dt, const NeighborList &list, ThreadPool &pool) override;

    void renew_correction() override
    {
      passes_to_renewal = 0;
    }

    void archive(Archive &archive) override
    {
      archive("passes to renewal", passes_to_renewal);
    }

  private:
    using Number = LanesOf<T>;

    /// Records hold lengths in 2h (the kernel's support is 1) and velocities, both relative to one particle, and
    /// volumes such that a product of two is V_i V_j 2h times the norm of the kernel's slope.
    struct Scale
    {
      Point3 origin{0., 0., 0.}, velocity{0., 0., 0.}; ///< m, m/s
      double length, volume;                           ///< m, 2h; root of N/Pa/m^6
      double force = 1.;                               ///< N, unit of pair forces; a power of two
    };

    /// Where the record of gradients has S B, xx xy xz yx ...
    static constexpr int stress_place = 6;

    /// Largest values that bound the pair forces.
    template <class N>
    struct Bounds
    {
      N                pressure = 0., stress = 0., impedance = 0., volume = 0.; ///< Pa, Pa, kg/(m^2 s), record units
      std::array<N, 3> slowest{}, fastest{};                                    ///< m/s, relative
    };

    template <class N>
    void update_stress(const Particles &particles, std::size_t p, const N &mu, Bounds<N> &bounds);
    template <class N>
    void update_records(Particles &particles, const Prediction<N> &prediction, std::size_t p, Bounds<N> &bounds);
    Bounds<double> update_chunk(Particles &particles, std::size_t begin, std::size_t end);
    void           update_force_unit(std::size_t longest_list);
    void           update_images(const MirrorImages &images, ThreadPool &pool);

    using Sum = void (RiemannRates::*)(Particles &, const NeighborList &, std::size_t, std::size_t) const;
    template <bool is_soft, bool wraps>
    Sum  choose_sum() const;
    void sum_range(Particles &particles, const NeighborList &list, std::size_t begin, std::size_t end) const;
    template <class Variant>
    void sum_pairs(Particles &particles, const NeighborList &list, std::size_t begin, std::size_t end) const;
    template <class Variant>
    void sum_neighbors(const NeighborList &list, std::size_t i, SumBlock &block) const;
    template <class Variant, class N>
    void store_rates(Particles &particles, const SumBlock &block, std::size_t i) const;

    EquationOfState             eos;
    double                      h;
    bool                        has_cutoff, has_correction, has_reconstruction, has_strength;
    Strength                    strength;
    double                      stiffening; ///< m^2/s^2, of shear
    unsigned int                renewal_interval, passes_to_renewal = 0;
    bool                        is_renewing = true;
    Scale                       scale;
    double                      prediction_time = 0.; ///< s
    std::vector<Bounds<double>> bounds;               ///< by chunk of particles
    Records<T, 16>              pairs;                ///< x V, v p, p B: xx yy zz, Z/2, p B: xy xz yz, 3 rho0/(2 Z)
    Records<T, 16>
      gradient; ///< symmetric velocity gradient (xx yy zz xy xz yz) with reconstruction; S B by rows with strength
    std::array<Particles::Column, 6> stress; ///< Pa, S as neighbours see it, with strength only
  };
} // namespace birdstrike
