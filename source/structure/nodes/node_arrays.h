#pragma once

#include <cstddef>

namespace birdstrike
{
  /// Raw nodal arrays of a deformable blade, node-major, for initial states and checks. A node has `n_unknowns`: three
  /// displacements, and in a shell three summed rotation increments. Velocities may be set between steps; positions,
  /// displacements and forces by what finds a state to start from (implicit/equilibrium.h).
  struct NodeArrays
  {
    std::size_t   n;
    unsigned int  n_unknowns;   ///< 6 (shell) or 3 (solid)
    const double *reference;    ///< [n][3], m
    double       *position;     ///< [n][3], m
    double       *displacement; ///< [n][n_unknowns], m and rad
    double       *velocity;     ///< [n][n_unknowns], m/s and rad/s
    double       *force;        ///< [n][n_unknowns], of elements, N and N m
    const double *mass;         ///< [n][n_unknowns], kg and kg m^2, of held unknowns too
    const double *inverse_mass; ///< [n][n_unknowns], 0 where held
  };
} // namespace birdstrike
