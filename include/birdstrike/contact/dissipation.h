#pragma once

#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/touch_record.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// `power` of a force on the relative velocity of a point and its closest point, and that of the spin which its
  /// couple gives the nodes of a facet, and of the turn of that at an edge (touch_record.h), W. Most touches have no
  /// couple.
  double add_spin_power(double power, const FacetsView &facets, const std::array<std::uint32_t, 4> &nodes,
                        const Point3 &turn, const Point3 &tilt, const std::array<double, 4> &turn_weights);

  /// The energy that damper and friction take: their own forces on the relative velocity at each touch, in the two half
  /// kicks in which these forces act, each with the velocity of the adjoining drift. Independent of the works that the
  /// parts book for the whole contact force, and of the spring. Where
  /// springs turn the relative motion within a step, its second half gives a part of the first back: of the present
  /// step only the first half is known, and what it has added too much stands until the sum of finished steps has
  /// reached it. That sum itself must not fall (law.h: dampers take); fall() tells by how much it ever did.
  ///
  /// What springs held is lost where a depth falls by more than its point's way: with the facet of an element that has
  /// failed, below a new edge, or where a point comes out behind a blade thinner than itself and to another facet.
  ///
  /// Where one part takes several steps within one of the other, velocities are those at the ends of contact's steps.
  class Dissipation
  {
  public:
    /// The second half of what the last forces took: half of the present step, at the velocities of its drift.
    void book_past(const PointsView &points, const FacetsView &facets, const PointMemory &memory, double step);

    /// Takes up present forces and the first half of what they take, in half of the step (s) that has ended with them.
    void add(const PointsView &points, const FacetsView &facets, const std::vector<TouchRecord> &touches, double step);

    /// Takes up energy (J, >= 0) that springs have lost otherwise than by the way of their points.
    void add_released(double energy);

    void archive(Archive &archive);

    double energy() const ///< J, since the start
    {
      return reported;
    }
    double released() const ///< J, of that, what add_released() has taken up
    {
      return lost;
    }
    /// J, at most 0: what of energy() the second half of the present and the next forces will have given back.
    double to_be_given_back() const
    {
      return booked + under_way - reported;
    }
    double fall() const ///< J, largest
    {
      return largest_fall;
    }

  private:
    /// Of a touch, the forces of its damper and friction: kept small, for there is one of each touch.
    struct Past
    {
      std::uint32_t                id; // of the point
      std::array<std::uint32_t, 4> nodes;
      std::uint32_t                index = 0; // of the point then: where it most likely still is
      std::array<double, 4>        weights;
      Point3                       force;      // N
      double                       taken;      // J, first half
      bool                         has_couple; // the next of `past_couples`
    };
    struct PastCouple
    {
      Point3                turn; // N/m
      Point3                tilt; // N
      std::array<double, 4> turn_weights;
    };
    std::vector<Past>       past;
    std::vector<PastCouple> past_couples;
    double                  booked = 0., under_way = 0.;  // J, of finished steps, and of the present one
    double                  most = 0., largest_fall = 0.; // J, of `booked`
    double                  reported = 0., lost = 0.;     // J
  };
} // namespace birdstrike
