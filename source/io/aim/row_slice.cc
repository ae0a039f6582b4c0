#include "io/aim/row_slice.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/rotor.h>

#include <Eigen/Geometry>

#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr double least_share = 1e-3; ///< of a pitch, that lies between the planes

    [[noreturn]] void refuse(const BirdParameters &bird, const std::string &found, const std::string &action)
    {
      throw InputError(bird.section + "/Slice/Number of blades: " + found + "\n" + action);
    }
  } // namespace

  void require_turning_row(const BirdParameters &bird, const BladeParameters &blade)
  {
    if (blade.kind == BladeKind::none || !Rotor(blade.spin).turns())
      refuse(bird, "the blade does not turn, so that no blade before it cuts the bird.",
             "Give Blade/Spin/Speed, or the planes by Slice/Between and Normal.");
    if (blade.mesh.row.n_blades > 1)
      refuse(bird, "the blades of Blade/Mesh/Row cut the bird themselves.",
             "Let the whole bird fly, or compute one blade.");
  }

  RowSlice::RowSlice(const BirdParameters &bird, const BladeParameters &blade, const Point3 &edge, const Point3 &along,
                     const Point3 &chord, const Point3 &velocity)
    : edge(edge)
  {
    const Rotor     rotor(blade.spin);
    const Turn      turn  = rotor.turn(bird.arrival);
    const HubMotion hub   = rotor.motion(bird.arrival);
    const Point3    place = turn.carried(edge), from_hub = place - hub.centre;
    const Point3    radius   = from_hub - hub.axis.dot(from_hub) * hub.axis;
    const Point3    rotation = hub.velocity(place), flow = velocity - rotation;
    const Point3    across = (along.norm() > 0. ? turn(along) : radius).cross(flow);
    if (!(rotation.norm() > 0.) || !(across.norm() > 0.))
      refuse(bird, "the blade's edge is at rest at the arrival time, or the bird flies along it.",
             "Give the planes by Slice/Between and Normal.");
    normal             = across.normalized();
    const double share = normal.dot(rotation.normalized());
    if (share < 0.)
      normal *= -1.;
    if (!(std::abs(share) > least_share))
      refuse(bird, "the bird does not come through the row: nothing of it lies between the paths of two blades.",
             "Give it a velocity along the axis of the hub (Blade/Spin/Axis).");
    half     = std::numbers::pi * radius.norm() / bird.slice_blades * std::abs(share);
    middle   = edge + (turn.back(normal).dot(chord) < 0. ? -half : half) * turn.back(normal);
    relative = turn.back(flow);
  }
} // namespace birdstrike
