#pragma once

#include "structure/nodes/column_mass.h"
#include <birdstrike/core/aligned_vector.h>

namespace birdstrike
{
  /// What the nodes of a solid have besides when their mass is scaled selectively (ColumnMass): effective forces, with
  /// which every kick goes through the inverse masses of the nodes as without scaling, and the part that the couplings
  /// add to energies and momenta. Arrays [n_nodes][3], node-major.
  class ScaledNodes
  {
  public:
    ScaledNodes(ColumnMass mass, std::size_t n_entries)
      : mass(std::move(mass)), effective(n_entries, 0.), effective_contact(n_entries, 0.)
    {
    }

    void update_forces(const double *force, const double *external)
    {
      mass.compute_effective_forces(force, external, effective.data());
    }
    const double *forces() const ///< N; with the external ones added they kick
    {
      return effective.data();
    }

    void          clear_contact();                       ///< others are about to come
    void          update_contact(const double *contact); ///< unless nothing has changed
    const double *contact() const
    {
      return effective_contact.data();
    }

    /// A half kick of duration (s) by effective and external forces with damping by `decay`; velocities after it.
    struct Kick
    {
      const double *velocity, *external, *inverse_mass;
      double        duration, decay;
    };
    double                dissipated(const Kick &kick, bool is_first) const;        ///< J, by damping
    std::array<double, 2> kinetic(const Kick &kick, double contact_duration) const; ///< J, as NodalMechanics::kinetic
    std::array<double, 3> angular_momentum(const double *position, const double *velocity) const
    {
      return mass.angular_momentum(position, velocity);
    }

    std::size_t bytes() const
    {
      return mass.bytes() + 2 * sizeof(double) * effective.size();
    }

  private:
    ColumnMass            mass;
    AlignedVector<double> effective, effective_contact;
    bool                  is_contact_known = true;
  };
} // namespace birdstrike
