#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace birdstrike
{
  /// Natural modes of small vibrations about a static equilibrium, ascending by frequency; before them the unstable
  /// ones, the fastest first.
  ///
  /// (K - (2 pi f)^2 M) phi = 0 with the lumped masses of the explicit loop and the tangent of the equilibrium: stress
  /// stiffening, softening by spin and stiffness of following loads are in it. Coriolis' forces are not (they couple
  /// modes in pairs and change the lowest frequencies of a blade by a share of about (w/2 pi f)^2 of that coupling).
  struct VibrationModes
  {
    struct Mode
    {
      double                frequency = 0.;   ///< Hz; 0 of an unstable one
      std::vector<double>   shape;            ///< [n_nodes][3], displacements, the largest of length 1
      std::array<double, 3> effective_mass{}; ///< shares of the blade's mass that move along x, y, z
      double growth_rate = 0.; ///< 1/s; above 0: the equilibrium is unstable, and the mode grows as exp(growth_rate t)

      bool is_unstable() const
      {
        return growth_rate > 0.;
      }
    };
    std::vector<Mode> modes;
    std::size_t       n_unknowns = 0;
    double            asymmetry = 0.; ///< |K - K^T| over |K| (Frobenius): of the tangent, whose symmetric part is taken
  };

  /// Modal assurance criterion |a.b|^2 / (a.a b.b) of shapes on the same nodes (Allemang & Brown 1982).
  double modal_assurance(const std::vector<double> &a, const std::vector<double> &b);
} // namespace birdstrike
