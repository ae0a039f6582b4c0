#include "contact/touch/common_nodes.h"
#include "contact/touch/thickness_slope.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>

// On which side a point is of a facet that it may touch, and how deep.
namespace birdstrike
{
  namespace
  {
    // slopes below, of thickness that strains have changed, do no work worth their couples
    constexpr double no_slope = 1e-3;

    // below this share of the size the direction p - q is round-off, and the facet's normal takes its place
    constexpr double no_distance = 1e-6;

    Point3 slope_at(const ContactScene &scene, const std::array<std::uint32_t, 4> &nodes,
                    const std::array<double, 4> &weights)
    {
      const std::array<double, 4> t{scene.topology.half_thickness(nodes[0]), scene.topology.half_thickness(nodes[1]),
                                    scene.topology.half_thickness(nodes[2]), scene.topology.half_thickness(nodes[3])};
      const double                least = std::min(std::min(t[0], t[1]), std::min(t[2], t[3]));
      const double                most  = std::max(std::max(t[0], t[1]), std::max(t[2], t[3]));
      if (most == least)
        return {0., 0., 0.};
      std::array<Point3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = Point3(scene.facets.position + 3 * nodes[k]);
      if (most - least < no_slope * (x[2] - x[0]).norm())
        return {0., 0., 0.};
      return compute_thickness_slope(x, t, weights);
    }

    /// Which of the two sides the point remembers is that of this facet, or -1: the one with the most common nodes, of
    /// the facet itself before one next to it, else one of the same piece; of the second touch of a piece none that the
    /// first has `taken`. Nearest and second change places in a fold or a notch: its sheets must not change their
    /// memories.
    int find_remembered(const PointRecord &before, const std::array<std::uint32_t, 4> &nodes, const std::int32_t piece,
                        const bool is_other_sheet, const int taken)
    {
      if (taken != 0 && before.sides[0].piece == piece && are_same(before.sides[0].nodes, nodes))
        return 0; // as nearly always
      int            best = -1;
      std::ptrdiff_t most = 0;
      for (int k = 0; k < 2; ++k)
        if (k != taken && before.sides[k].piece == piece)
          if (const std::ptrdiff_t common = count_common_nodes(before.sides[k].nodes, nodes); common > most)
            {
              best = k;
              most = common;
            }
      for (int k = is_other_sheet ? 1 : 0; k < 2 && best < 0; ++k)
        if (k != taken && before.sides[k].piece == piece)
          best = k;
      return best;
    }

    void set_outward(const Point3 &direction, PointRecord::Side &side)
    {
      for (unsigned int d = 0; d < 3; ++d)
        side.outward[d] = static_cast<float>(direction[d]);
    }

    /// What a point comes nearer in this step, m.
    struct Approach
    {
      double to_face;       ///< or away from it
      double through_plane; ///< of the edge that bounds the face, or out

      /// Of its way to the face, what it has come since it was on the plane, `depth` above where it is now.
      double since_plane(const double depth) const
      {
        return std::max(0., to_face) * std::min(1., depth / std::max(through_plane, 1e-300));
      }
    };

    /// Of the overlap, what carries no force.
    /// `is_new`: another sheet of the same surface, or facets that have just come; `is_elsewhere`: another place of the
    /// surface than the one remembered.
    double inherited_reference(const ContactScene &scene, const EdgeTouch &edge, const PointRecord::Side &known,
                               const bool is_new, const bool is_elsewhere, const Approach &approach)
    {
      const double nearer = std::max(0., approach.to_face);
      if (scene.is_first)
        return edge.overlap;
      if (edge.feature == EdgeTouch::Feature::beyond) // it comes in from the side, or not at all
        return edge.overlap - std::max(edge.limit, 0.);
      const double kept = std::min(known.reference, edge.overlap);
      // a slide over small facets, on which the overlap is continuous, or another sheet: it gives no depth
      if (is_elsewhere)
        return std::max(kept, edge.overlap - nearer - (known.is_touching ? known.overlap - known.reference : 0.));
      // just come in from there: the height that it had in the plane is its stand-off, whatever the step
      if (known.was_beyond)
        return std::max(kept, edge.overlap - approach.since_plane(edge.limit));
      // through the edge face into the middle surface, or back
      if (known.is_touching && known.is_on_edge_face != (edge.feature == EdgeTouch::Feature::edge_face))
        return edge.overlap;
      // of a point that did not touch it before, all that it has not come nearer in this step is no contact: it was
      // there before, beside the nearest sheet
      if (is_new && !known.is_touching)
        return edge.overlap - nearer;
      return kept;
    }
    /// The depth that carries a force, and its direction. It comes by the point's own way, `most` at most in this step
    /// (m): what leaps from facet to facet and along an edge face, where jagged edges meet, or below an edge's plane,
    /// where a ridge goes flat, carries none. And of a depth below an edge's plane, which its faces share, nothing goes
    /// but by the point's own way when it comes from one of them to the next.
    void settle_depth(EdgeTouch &edge, const double known_depth, const double closing, const double most,
                      const bool has_plane, PointRecord::Side &side, TouchingPair &result)
    {
      const double present = std::min(edge.overlap - side.reference, edge.limit);
      if (present > known_depth + most)
        side.reference = edge.overlap - (known_depth + std::max(0., closing));
      else if (has_plane && present < known_depth - most)
        side.reference = std::min(side.reference, std::max(0., edge.overlap - (known_depth + std::min(0., closing))));
      const double depth      = edge.overlap - side.reference;
      const bool   is_limited = edge.limit < depth;
      side.overlap            = edge.overlap;
      result.penetration      = is_limited ? edge.limit : depth;
      side.depth              = std::max(result.penetration, 0.);
      if (side.is_on_edge_face)
        edge.slope.setZero(); // its place does not depend on the thickness
      result.normal     = is_limited ? edge.limit_normal : Point3(edge.normal - edge.slope);
      result.is_oblique = is_limited || edge.is_oblique || !edge.slope.isZero(0.);
      if (is_limited || side.is_on_edge_face || edge.is_oblique)
        result.edge = edge.place;
      if (!is_limited)
        result.edge.turns[0] = edge.face_turn;
    }
  } // namespace

  bool NarrowPhase::touch(const ContactScene &scene, const std::uint32_t place, const PointRecord &before,
                          const bool is_other_sheet, int &taken, TouchingPair &result, PointRecord::Side &side) const
  {
    const std::uint32_t facet    = facet_of(place);
    const std::int32_t  piece    = scene.topology.piece(facet);
    const double        distance = pairs.distance[place];
    const Point3        offset = pairs.offset_of(place), velocity = pairs.velocity_of(place);
    const bool          is_beyond     = scene.topology.is_on_rim(scene.facets, facet, pairs.weights_of(place));
    const bool          is_degenerate = distance < no_distance * before.size; // on the surface itself
    const Point3        normal =
      is_degenerate ? Point3(compute_area_vector(facet_nodes(scene.facets, facet)).normalized()) : Point3(0., 0., 0.);
    // on the surface itself the point is where it came from
    const std::int8_t seen = (is_degenerate ? -velocity.dot(normal) : pairs.height[place]) < 0. ? -1 : 1;

    // a second facet of the same piece is met on the side on which it is seen, unless it was known before: where a
    // surface folds, the other side of the first one means nothing to it
    const auto &nodes = scene.facets.nodes[facet];
    taken = before.last_call + 1 == scene.call ? find_remembered(before, nodes, piece, is_other_sheet, taken) : -1;
    const PointRecord::Side &known        = taken < 0 ? unknown_side : before.sides[taken];
    const bool               is_other     = !are_same(known.nodes, nodes);
    const bool               is_elsewhere = taken >= 0 && is_other && count_common_nodes(known.nodes, nodes) == 0;
    const bool               is_next      = is_other || known.was_beyond; // another face than in the last call

    // a change of sign within two steps' flight, or in touch, is a passage through the surface; else the point went
    // around; of one in touch, if the overlap has grown by no more than its way: else it is another sheet of a fold
    const double own_way = way_of(scene, place);
    const double if_past = 0.5 * before.size + pairs.half_thickness[place] + distance;
    const bool   is_passage =
      known.is_touching ? if_past <= known.overlap + 2. * own_way + 1e-3 * before.size : distance <= 2. * own_way;
    // come through, and out past the rim: it is behind the edge's plane still
    const bool  is_behind = is_beyond && known.is_touching && known.is_through && seen != known.sign;
    std::int8_t of_side   = known.sign;
    if (is_beyond && !is_behind)
      of_side = 0;
    else if (!is_behind && (known.piece < 0 || known.sign == 0 || (seen != known.sign && !is_passage)))
      {
        if (!scene.facets.two_sided && seen < 0)
          {
            side = unknown_side;
            return false;
          }
        of_side = seen;
      }
    side.sign    = of_side;
    side.piece   = piece;
    side.nodes   = nodes;
    side.outward = known.outward;
    if (!scene.facets.two_sided && seen > 0)
      set_outward(is_degenerate ? normal : Point3(offset / distance), side);
    const double sign = is_beyond && !is_behind ? 1. : of_side * seen;
    EdgeTouch    edge{offset,
                   sign * distance,
                   pairs.half_thickness[place],
                   before.size,
                   is_beyond,
                   known.is_touching && known.is_on_edge_face,
                   0.5 * before.size + pairs.half_thickness[place] - sign * distance,
                   is_degenerate ? Point3((is_beyond ? seen : of_side) * normal) : offset * (sign / distance)};
    if (!is_beyond)
      edge.slope = slope_at(scene, nodes, pairs.weights_of(place));
    if (const SharpEdges &edges = scene.topology.sharp_edges(); edges.are_near(facet))
      edges.cut(scene.facets, facet, pairs.closest_of(scene.facets, scene.facets.nodes[facet], place), edge);

    const bool     was_limited = known.is_touching && known.depth < known.overlap - known.reference;
    const bool     is_inside = edge.overlap > 0. && edge.limit > 0., is_new = scene.is_changed || is_other_sheet;
    const Approach approach{-velocity.dot(edge.normal - edge.slope) * scene.step,
                            -velocity.dot(edge.limit_normal) * scene.step};
    side.reference        = std::max(inherited_reference(scene, edge, known, is_new, is_elsewhere, approach), 0.);
    side.is_touching      = is_inside;
    side.is_through       = is_inside && sign < 0.;
    side.was_beyond       = edge.feature == EdgeTouch::Feature::beyond;
    side.is_on_edge_face  = edge.feature == EdgeTouch::Feature::edge_face;
    const bool   can_leap = (is_next || was_limited || side.is_on_edge_face) && before.last_call + 1 == scene.call;
    const double most     = can_leap ? own_way + leap * before.size : INFINITY;
    settle_depth(edge, known.depth, approach.to_face, most, was_limited && !is_elsewhere, side, result);
    result.place = place;
    return result.penetration > 0.;
  }
} // namespace birdstrike
