#pragma once

#include <birdstrike/core/named_choices.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  enum class BirdShape
  {
    cylinder,
    hemispherical_cylinder,
    ellipsoid,
    sphere,
    slab ///< a box, for verification
  };
  enum class BirdLattice
  {
    cubic,
    fcc
  };
  enum class ParticleFormulation
  {
    riemann, ///< riemann_rates.h
    standard ///< standard_rates.h
  };
  enum class SmoothingKernel
  {
    automatic, ///< wendland with riemann, cubic spline with standard
    wendland,
    cubic_spline
  };
  enum class DensityBy
  {
    continuity,
    summation
  };
  enum class Reconstruction
  {
    none,
    linear
  };
  enum class PairPrecision
  {
    as_double,
    as_float
  };

  // How they are spelt in the parameter file.
  const NamedChoices<BirdShape>           &bird_shapes();
  const NamedChoices<BirdLattice>         &bird_lattices();
  const NamedChoices<ParticleFormulation> &particle_formulations();

  /// The blade's surface where the bird aims, as the blade lies at the start.
  struct AimedSurface
  {
    std::array<double, 3> normal{}; ///< unit, of the undeformed mid-surface
    std::array<double, 3> chord{};  ///< unit, of the section there, from the leading to the trailing edge
    double                span_share = 0., chord_share = 0.;
    double                distance = 0.; ///< m, of the aim point from the mid-surface
  };

  /// User entries of section "Bird", or "Bird 2" and so on; every default lives here and nowhere else.
  struct BirdParameters
  {
    std::string           section            = "Bird"; ///< of the file, in which these entries stand
    bool                  enabled            = true;
    double                mass               = 0.1005; ///< kg; of a slab it follows from the lengths
    double                density            = 950.;   ///< kg/m^3
    double                length_to_diameter = 2.;
    BirdShape             shape              = BirdShape::cylinder;
    std::array<double, 3> slab_lengths{{0., 0., 0.}};         ///< m
    std::array<bool, 3>   is_periodic{{false, false, false}}; ///< along x, y, z
    BirdLattice           packing = BirdLattice::cubic;
    double                spacing = 0.002;              ///< m, cube root of a particle's volume
    std::array<double, 3> velocity{{0., 0., 177.4}};    ///< m/s
    double                yaw   = 0.;                   ///< degrees
    double                pitch = 0.;                   ///< degrees
    double                roll  = 0.;                   ///< degrees; of a round bird this turns the lattice alone
    std::array<double, 2> lattice_shift{{0., 0.}};      ///< across its axis, in cells of the lattice
    std::array<double, 3> aim_point{{0.21784, 0., 0.}}; ///< m; 70 % of a 311.2 mm span
    std::vector<double>   slice_normal;                 ///< three numbers, fixed axes; empty: the bird's axis
    std::vector<double>   slice_between;            ///< two numbers, m along it from the centre; empty: the whole bird
    unsigned int          slice_blades        = 0;  ///< of the row that cuts the bird; 0: none
    double                chordwise_offset    = 0.; ///< m
    double                stand_off           = 0.; ///< m; 0 is automatic
    double                arrival             = 0.; ///< s, of the first touch
    ParticleFormulation   formulation         = ParticleFormulation::riemann;
    SmoothingKernel       kernel              = SmoothingKernel::automatic;
    double                smoothing_ratio     = 1.3;
    double                alpha               = 1.;
    double                beta                = 2.;
    DensityBy             density_by          = DensityBy::continuity;
    bool                  gradient_correction = true;
    Reconstruction        reconstruction      = Reconstruction::none;
    // frontal strike, 2 ms: float against double pairs 0.01 % of tip and peak force, same energy and momentum error
    PairPrecision pair_precision      = PairPrecision::as_float;
    unsigned int  correction_interval = 4;    ///< passes; 4 against 1: 0.07 % of the tip, 0.4 % of the peak force
    bool          tension_cutoff      = true; ///< false in tests alone: else particles clump
    double        shear_modulus       = 0.;   ///< Pa
    double        yield_stress        = 0.;   ///< Pa; 0: a liquid
    double        courant_number = 0.35; // 0.45 lets the first layer on a wall ring at 10 m/s (rms 70 %); 0.35: 1 %
    double        skin           = 0.1;  ///< of the kernel's support
    bool          retire         = true;

    std::vector<double> retirement_margin; ///< m; empty: 1.25 diameters of the bird

    // What may be given instead of velocity and aim point, which the case then makes of them; empty: not given.
    std::vector<double> speed;    ///< m/s
    std::vector<double> position; ///< three numbers, m, of the centre at time 0: in place of aim point and arrival
    std::vector<double> angle_to_surface;                      ///< degrees
    std::vector<double> flight_direction;                      ///< three numbers
    std::vector<double> aim_span_fraction, aim_chord_fraction; ///< shares

    /// Set by the case where there is such a surface and it is asked for; without it the chord is y.
    std::optional<AimedSurface> aimed_surface;
    /// Set by the case that aims by shares of span and chord: the place of the undeformed surface (m) that the bird
    /// aims at, or the edge beside which it aims; the aim goes with it where spin and steady loads move it.
    std::optional<std::array<double, 3>> aimed_place;

    bool is_aim_given = false; ///< set by the case, beside `position`

    /// Unit, from the root of the blade to its tip, about which the bird yaws; the scene knows it.
    std::array<double, 3> span{{1., 0., 0.}};

    /// Where the centre would fly through, had nothing moved `aimed_place`: the aim point shifted along the chord, m.
    std::array<double, 3> target() const;

    /// Only the half y > 0 is computed, mirrored at y = 0; set by the case, not by an entry of this section.
    bool is_halved = false;

    void declare(dealii::ParameterHandler &prm);

    /// Rules between entries; throws InputError.
    void check() const;

    void check_strength() const;
    void check_slice() const;
    void check_position() const;

    /// What a bird needs to be halved by the plane y = 0; throws InputError.
    void check_halves() const;

    bool is_slice() const
    {
      return !slice_between.empty();
    }
    bool is_lattice_shifted() const
    {
      return lattice_shift != std::array<double, 2>{{0., 0.}};
    }
    bool is_riemann() const;
    bool has_strength() const
    {
      return yield_stress > 0.;
    }

    /// Of Courant number times step scale, up to which a longer step is worth it. Measured, a bird of 6 mm particles on
    /// a rigid wall at 177 m/s: largest error of all energy, and share of the steps whose rates are evaluated twice
    /// (Bird), without which the riemann formulation makes 0.7, 2.9, 10 and 22 %:
    ///   Courant number  0.35         0.5          0.6          0.7
    ///   riemann         0.3 %, 1/27  0.5 %, 1/4   1.1 %, 1/2   1.3 %, 2/3
    ///   standard        0.2 %, 1/38  0.6 %, 1/17  0.8 %, 1/13  1.1 %, 1/10
    ///   peak force      1            1.11         1.20         1.31, of the first touch
    double largest_courant_number() const;

  private:
    [[noreturn]] void refuse(const std::string &entry, const std::string &found, const std::string &action) const;
  };
} // namespace birdstrike
