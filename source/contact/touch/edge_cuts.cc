#include "contact/touch/edge_frame.h"
#include "contact/touch/edge_profile.h"
#include <birdstrike/contact/sharp_edges.h>

#include <algorithm>
#include <cmath>

// What an edge takes off the offset surface at a point.
namespace birdstrike
{
  namespace
  {
    constexpr double at_it = 1e-9; // of the size: closer to an edge than this is on it

    /// Bounds a face at a right-angled edge, s beyond it and z above the face, by the plane s + z = 0. The normal is
    /// its gradient.
    void bound(const Point3 &outward, const double s, const Point3 &up, const double z, EdgeTouch &touch)
    {
      const double cosine = std::sqrt(0.5);
      touch.limit         = -cosine * (s + z);
      touch.limit_normal  = cosine * (outward + up - touch.slope);
      if (touch.limit <= 0.)
        touch.feature = EdgeTouch::Feature::beyond;
    }

    /// Makes it a touch of the edge face, which the planes of both faces bound. Whether the other one does.
    bool take_edge_face(const Point3 &outward, const double s, const Point3 &up, const double z, EdgeTouch &touch)
    {
      const double cosine = std::sqrt(0.5), z_of_other = -2. * touch.half_thickness - z;
      touch.feature    = EdgeTouch::Feature::edge_face;
      touch.overlap    = 0.5 * touch.size - s;
      touch.normal     = outward;
      touch.is_oblique = true;
      if (const double limit = -cosine * (s + z_of_other); limit < touch.limit)
        {
          touch.limit        = limit;
          touch.limit_normal = cosine * (outward - up - touch.slope);
          if (limit <= 0.)
            touch.feature = EdgeTouch::Feature::beyond;
          return true;
        }
      return false;
    }
    /// A depth a (...) - r.(alpha out + beta up), r from the edge to the point, as the face turns: `out` is the
    /// direction of r in the face, `up` its normal n or -n. By r.out = -sqrt(r^2 - (r.up)^2) it turns with n alone,
    ///   (alpha out + beta up)'.r = (beta - alpha (r.up)/(r.out)) r.up',   n' = phi o - (eta.n) e.
    /// Beside the edge `out` is o, and what r has along it moves the place on the edge instead (along_edge).
    EdgeTurn turn_of(const EdgeFrame &face, const Point3 &edge, const bool is_end, const Point3 &r, const Point3 &out,
                     const Point3 &up, const double alpha, const double beta)
    {
      const double side = up.dot(face.normal), s = r.dot(out);
      const double tilt = side * (s != 0. ? beta - alpha * r.dot(up) / s : 0.);
      if (!is_end)
        return {side * (beta * s - alpha * r.dot(up)), 0.};
      return {tilt * r.dot(face.outward), -tilt * r.dot(edge.normalized())};
    }

    /// What the foot of a point on an edge from a to b is beyond `share`: forces without a couple act below the point.
    double along_edge(const Point3 &edge, const bool is_end, const Point3 &r)
    {
      return is_end ? 0. : r.dot(edge) / std::max(edge.squaredNorm(), 1e-300);
    }
  } // namespace

  struct SharpEdges::Foot
  {
    const Edge *edge;
    Point3      from_closest; // to the foot
    double      distance;
    double      share; // of the edge

    bool is_end() const
    {
      return share == 0. || share == 1.;
    }
  };

  bool SharpEdges::is_before(const FacetsView &facets, const std::uint32_t facet, const Edge &one, const Edge &other,
                             const Point3 &from_corner, const double tied)
  {
    const auto beyond = [&](const Edge &edge) {
      const Point3 a = node_at(facets, edge.nodes[0]), b = node_at(facets, edge.nodes[1]);
      double       sum = 0.;
      for (const std::int32_t beside : edge.facets)
        if (beside >= 0)
          sum += from_corner.dot(edge_frame(facets, beside, a, b).outward);
      return sum;
    };
    const auto bounds = [&](const Edge &edge) {
      return std::find(edge.facets.begin(), edge.facets.end(), static_cast<std::int32_t>(facet)) != edge.facets.end();
    };
    const double further = beyond(one) - beyond(other);
    return further > tied || (further >= -tied && bounds(one) && !bounds(other));
  }

  bool SharpEdges::is_sharp(const FacetsView &facets, const Edge &edge) const
  {
    if (edge.facets[1] < 0)
      return true;
    const Point3    a = node_at(facets, edge.nodes[0]), b = node_at(facets, edge.nodes[1]);
    const EdgeFrame one = edge_frame(facets, edge.facets[0], a, b), other = edge_frame(facets, edge.facets[1], b, a);
    return one.normal.dot(other.normal) <= std::cos(blunt_ridge) && one.normal.dot(other.outward) > 0.;
  }

  void SharpEdges::cut(const FacetsView &facets, const std::uint32_t facet, const Point3 &closest,
                       EdgeTouch &touch) const
  {
    // the nearest edge; on a corner all that meet there
    const auto to_foot = [&](const Edge &edge) {
      return Point3(closest_on_segment(closest, node_at(facets, edge.nodes[0]), node_at(facets, edge.nodes[1])) -
                    closest);
    };
    double smallest = edge_reach(touch.size);
    for (std::uint32_t n = first[facet]; n < first[facet + 1]; ++n)
      if (const Edge &edge = edges[near[n]];
          to_foot(edge).squaredNorm() < smallest * smallest && is_sharp(facets, edge))
        smallest = to_foot(edge).norm();
    if (smallest >= edge_reach(touch.size))
      return;
    const EdgeTouch smooth = touch;
    const double    tied   = at_it * touch.size;
    const Edge     *taken  = nullptr;
    for (std::uint32_t n = first[facet]; n < first[facet + 1]; ++n)
      {
        const Edge &edge = edges[near[n]];
        Foot        foot;
        foot.edge         = &edge;
        foot.from_closest = to_foot(edge);
        foot.distance     = foot.from_closest.norm();
        foot.share        = share_of_segment(closest, node_at(facets, edge.nodes[0]), node_at(facets, edge.nodes[1]));
        if (foot.distance > smallest + at_it * touch.size || !is_sharp(facets, edge))
          continue;
        EdgeTouch here = smooth;
        if (edge.facets[1] < 0)
          cut_rim(facets, foot, here);
        else
          cut_ridge(facets, foot, here);
        if (here.limit + here.limit_normal.dot(smooth.offset) < -tied)
          continue; // the closest point itself lies beyond the plane: a floor beside the wall that rises to the edge
        const double deeper = taken ? here.limit - touch.limit : -INFINITY;
        if (deeper < -tied ||
            (deeper <= tied && is_before(facets, facet, edge, *taken, smooth.offset - foot.from_closest, tied)))
          {
            touch = here;
            taken = &edge;
          }
      }
  }

  void SharpEdges::cut_rim(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const
  {
    const Point3    a = node_at(facets, foot.edge->nodes[0]), b = node_at(facets, foot.edge->nodes[1]);
    const EdgeFrame frame   = edge_frame(facets, foot.edge->facets[0], a, b);
    const auto      outward = [&](const Point3 &direction, const double length, const Point3 &up) {
      const Point3 &along = length > at_it * touch.size ? direction : frame.outward;
      return Point3((along - along.dot(up) * up).normalized());
    };
    if (!touch.is_beyond)
      {
        // the plane stands at the edge: over a face that is curved, or has folds, its normal is not that below the
        // point, whose turns do no work
        const Point3 from_foot = touch.offset - foot.from_closest;
        const Point3 up        = (touch.normal.dot(frame.normal) < 0. ? -1. : 1.) * frame.normal;
        const Point3 out       = foot.is_end() ? outward(foot.from_closest, foot.distance, up) : frame.outward;
        const double s = from_foot.dot(out), z = from_foot.dot(up) - touch.half_thickness;
        bound(out, s, up, z, touch);
        const auto turns_by = [&](const double alpha, const double beta) {
          return turn_of(frame, b - a, foot.is_end(), from_foot, out, up, alpha, beta);
        };
        const double beside = along_edge(b - a, foot.is_end(), from_foot);
        touch.place  = {foot.edge->facets, foot.edge->nodes, foot.share + beside, from_foot - beside * (b - a), {}};
        double below = std::sqrt(0.5); // of the plane: that of the face
        if (touch.was_on_edge_face && z < 0. && touch.feature == EdgeTouch::Feature::face)
          below = take_edge_face(out, s, up, z, touch) ? -below : below;
        touch.place.turns[0] = turns_by(std::sqrt(0.5), below);
        touch.face_turn      = turns_by(1., 0.);
        return;
      }
    const double height = touch.offset.dot(frame.normal), side = touch.height < 0. ? -1. : 1.; // through it, or not
    const double z  = side * std::abs(height) - touch.half_thickness;
    const Point3 up = (height < 0. ? -side : side) * frame.normal, r = touch.offset - height * frame.normal;
    const double s = r.norm();
    // come through, and further than half a point beyond, it leaves the edge, however often it is looked at
    const double away = side < 0. ? std::abs(height) - touch.half_thickness - 0.5 * touch.size : z;
    touch.overlap     = 0.5 * touch.size - std::hypot(s, std::max(away, 0.));
    touch.normal      = outward(r, s, up);
    bound(touch.normal, s, up, z, touch);
    touch.is_oblique    = true;
    const bool   is_end = foot.is_end();
    const double beside = along_edge(b - a, is_end, touch.offset);
    touch.place = {foot.edge->facets, foot.edge->nodes, foot.share + beside, touch.offset - beside * (b - a), {}};
    touch.place.turns[0] =
      turn_of(frame, b - a, is_end, touch.offset, touch.normal, up, std::sqrt(0.5), std::sqrt(0.5));
    touch.face_turn = turn_of(frame, b - a, is_end, touch.offset, touch.normal, up, 1., 0.);
    if (z < 0. && touch.feature == EdgeTouch::Feature::face)
      touch.feature = EdgeTouch::Feature::edge_face;
  }

  void SharpEdges::cut_ridge(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const
  {
    const Edge      &edge = *foot.edge;
    const Point3     a = node_at(facets, edge.nodes[0]), b = node_at(facets, edge.nodes[1]);
    const EdgeFrame  one = edge_frame(facets, edge.facets[0], a, b), other = edge_frame(facets, edge.facets[1], b, a);
    const double     angle       = std::acos(std::clamp(one.normal.dot(other.normal), -1., 1.));
    const double     round       = 0.5 * touch.size * round_share(angle);
    const Point3     bisector    = (one.normal + other.normal).normalized();
    const Point3     from_foot   = touch.offset - foot.from_closest;
    const bool       is_over_one = from_foot.dot(one.outward) <= from_foot.dot(other.outward);
    const EdgeFrame &face        = is_over_one ? one : other;
    // past its ends the edge bounds what lies around them, not beside it
    const Point3 towards = foot.from_closest - foot.from_closest.dot(face.normal) * face.normal;
    const Point3 out     = foot.is_end() && towards.norm() > at_it * touch.size ? towards.normalized() : face.outward;
    touch.limit_normal   = bisector.dot(face.normal) * face.normal + bisector.dot(face.outward) * out;
    touch.limit          = round - touch.limit_normal.dot(from_foot);
    const double beside  = along_edge(b - a, foot.is_end(), from_foot);
    touch.place          = {edge.facets, edge.nodes, foot.share + beside, from_foot - beside * (b - a), {}};
    // the plane follows the angle between the faces, which both turn, and the face that it is over
    const double alpha = bisector.dot(face.outward), beta = bisector.dot(face.normal);
    const double opened =
      touch.size * round_share_slope(angle) - (beta * from_foot.dot(out) - alpha * from_foot.dot(face.normal));
    const EdgeTurn own = turn_of(face, is_over_one ? Point3(b - a) : Point3(a - b), foot.is_end(), from_foot, out,
                                 face.normal, alpha, beta);
    for (const bool is_first : {true, false})
      touch.place.turns[is_first ? 0 : 1] =
        is_first == is_over_one ? EdgeTurn{opened + 2. * own.about, 2. * own.across} : EdgeTurn{opened, 0.};
    if (touch.limit <= 0.)
      touch.feature = EdgeTouch::Feature::beyond;
  }
} // namespace birdstrike
