#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/touch_record.h>

#include <array>

namespace birdstrike
{
  /// The couple (p - q) x F of a force F on a point at p whose counterpart acts at q on a facet: what a touch across
  /// half a shell's thickness or at an edge leaves over. Forces f_k = -turn x y_k on the nodes, y_k from their mean,
  /// have no sum and the moment (sum |y|^2 1 - y y^T) turn. On facets much smaller than the offset they would be many
  /// times F, and unstable: there they stay as large as F, and a part of the couple is lost.
  ///
  /// The point then moves relative to the nodes, along F, as along the power of all these forces: at v_p - v_q - spin x
  /// (p - q), with the facet's spin. A damper on less than that would push a facet that turns (0.1 % of all energy
  /// within ten steps, at edges).
  ///
  /// At an edge (TouchRecord::is_edge) the depth itself says what the nodes get of a force along the normal, and only
  /// what that leaves of the moment is a couple: all of friction's, and of the normal's where its turns are bounded or
  /// the thickness slopes. A facet's spin is that of its plane only while the facet is not distorted, and forces of the
  /// one for turns of the other made 1.5 % of all energy on a crumpled foil.
  class Couple
  {
  public:
    Couple(const FacetsView &facets, bool has_friction, const TouchRecord &touch);

    /// Of the nodes, for a force F (N) on the point: N/m.
    Point3 turn(const Point3 &force) const
    {
      return share * (inverse * (touch.offset.cross(of_couple(force)) + force.dot(touch.normal) * touch.left_over));
    }
    /// What forces at an edge have to do with the facet's turn: -turn_weights[k] tilt on node k, N.
    Point3 tilt(const Point3 &force) const
    {
      return touch.is_edge ? Point3(force.dot(touch.normal) / squared_normal() * touch.turn_normal)
                           : Point3(0., 0., 0.);
    }
    /// The force on node k of the facet is -turn x this, m.
    const Point3 &arm(const unsigned int k) const
    {
      return arms[k];
    }
    /// What the spin of the nodes adds to the velocity of the facet's closest point, m/s.
    Point3 velocity(const FacetsView &facets) const;
    /// Sizes of the forces on the nodes for a unit force on the point.
    std::array<double, 4> loads(const Point3 &direction) const;
    /// The largest of all directions across `normal`: that of a slip may be round-off.
    std::array<double, 4> largest_loads_across(const Point3 &normal) const;

  private:
    Point3 force_on(unsigned int k, const Point3 &force, const Point3 &turned) const;

    double norm_of(const Point3 &arm) const; ///< of the map from F to turn x arm
    double squared_normal() const
    {
      return touch.normal.squaredNorm();
    }
    /// Of a vector, what is across the normal of an edge.
    Point3 of_couple(const Point3 &vector) const
    {
      return touch.is_edge ? Point3(vector - vector.dot(touch.normal) / squared_normal() * touch.normal) : vector;
    }

    const TouchRecord    &touch;
    std::array<Point3, 4> arms;
    Matrix3<double>       inverse;
    double                share = 1.;
  };
} // namespace birdstrike
