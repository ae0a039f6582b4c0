#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/material/ply.h>
#include <birdstrike/structure/laminate_parameters.h>

#include <vector>

namespace birdstrike
{
  /// Strains of a laminated section in the laminate's axes, or the stresses that work on them: three of the membrane
  /// (11, 22, 2 12), three of bending at the face z = t/2, two of transverse shear; as means over the thickness, so
  /// that the power per volume is their product. N = t s[0..2], M = t^2/2 s[3..5], Q = t s[6..7].
  inline constexpr int n_laminate_strains = 8;

  /// Stiffness of a stack of plies: classical lamination theory with first-order transverse shear.
  ///
  /// With z = t h/2, -1 <= h <= 1, strain e + h b and the plies' reduced stiffness Q turned into the laminate's axes
  ///   A = 1/2 int Q dh,  B = 1/2 int Q h dh,  D = 1/2 int Q h^2 dh
  /// (t A, t^2/2 B and t^3/4 D of the books), exact over every ply.
  ///
  /// Transverse shear by equilibrium (Whitney 1973; for unsymmetric stacks Rohwer 1988): the plane stresses that grow
  /// along 1 with M_11 alone, and along 2 with M_22 alone, no membrane force, leave shear stresses f(h) Q; their
  /// complementary energy is that of the mean stiffness H,  H^-1 = 1/2 int f^T G^-1 f dh. One ply: 5/6 G.
  struct Laminate
  {
    struct Layer
    {
      double      bottom, top; ///< h
      double      cos, sin;    ///< of the fibres' angle
      std::size_t material = 0;
      std::size_t ply      = 0; ///< from the bottom

      double middle() const
      {
        return 0.5 * (bottom + top);
      }
      double share() const ///< of the thickness
      {
        return 0.5 * (top - bottom);
      }
    };

    /// What layers are of.
    struct Material
    {
      Ply                  ply;
      PlyStiffness<double> intact;
      PlyCriteria          criteria;

      explicit Material(const Ply &ply) : ply(ply), intact(ply, 1., 1.), criteria(ply.strength)
      {
      }
    };

    /// `plies` from the bottom, of these materials; `n_per_ply` layers, each with one point, for each of them.
    Laminate(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies, const Point3 &reference,
             unsigned int n_per_ply = 1);
    Laminate(const Ply &ply, const std::vector<PlyLayer> &plies, const Point3 &reference, unsigned int n_per_ply = 1)
      : Laminate(std::vector<Ply>{ply}, plies, reference, n_per_ply)
    {
    }

    std::vector<Material> materials;
    std::vector<Layer>    layers;
    std::size_t           n_plies;
    Point3                reference;    ///< global, that angles are counted from, projected on the elements
    double                density = 0.; ///< kg/m^3, mean over the thickness

    double degradation_time = 0.;                 ///< s; 0: at once
    double failed_share = 1., smallest_step = 0.; ///< as of Failure

    double stiffness[6][6];      ///< Pa, (A B; B D)
    double shear[3];             ///< Pa, H_11, H_22, H_12
    double largest_shear;        ///< Pa, largest eigenvalue of H
    double coupling;             ///< largest eigenvalue of D^-1 B A^-1 B, 0 to 1: none of a symmetric stack
    double compliance[6][6];     ///< 1/Pa
    double membrane_alone[3][3]; ///< A^-1, 1/Pa

    double matrix_failure_strain = 0.; ///< at which plies without a matrix break (is_gap in failure.h); 0: none

    /// Of a uniaxial membrane stress along a direction, without any bending: stress over strain along it, and the
    /// lateral strain and the shear strain across it by that along it.
    struct Uniaxial
    {
      double modulus, lateral, shear;
    };
    Uniaxial uniaxial(double cos, double sin) const;
    /// Stiffness of e and b along a direction, of stresses s and m along it alone: Pian & Sumihara's assumed stress.
    struct Beam
    {
      double membrane, coupling, bending; ///< Pa
    };
    Beam   beam(double cos, double sin) const;
    double shear_along(double cos, double sin) const; ///< Pa

    bool can_fail() const
    {
      for (const Material &each : materials)
        if (each.ply.strength.can_fail())
          return true;
      return false;
    }
    const Material &of(const Layer &layer) const
    {
      return materials[layer.material];
    }
    const Layer &at(double height) const; ///< the layer at h

  private:
    void set_shear();
  };
} // namespace birdstrike
