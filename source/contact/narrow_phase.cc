#include "contact/thickness_slope.h"
#include <birdstrike/contact/narrow_phase.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double share_starts_at = 0.5, share_is_full_at = 0.2; // cosines between two touching directions
    constexpr double tie           = 1e-9;                          // relative difference of equal distances
    constexpr double looks_outward = 0.25; // cosine between a facet's normal and where a point came from

    // slopes below, of thickness that strains have changed, do no work worth their couples
    constexpr double no_slope = 1e-3;

    // below this share of the size the direction p - q is round-off, and the facet's normal takes its place
    constexpr double no_distance = 1e-6;

    Point3 unit_normal(const FacetsView &facets, const std::uint32_t facet)
    {
      const auto x = facet_nodes(facets, facet);
      return (x[2] - x[0]).cross(x[3] - x[1]).normalized();
    }

    Point3 slope_at(const ContactScene &scene, const std::array<std::uint32_t, 4> &nodes,
                    const std::array<double, 4> &weights)
    {
      const std::array<double, 4> t{scene.topology.half_thickness(nodes[0]), scene.topology.half_thickness(nodes[1]),
                                    scene.topology.half_thickness(nodes[2]), scene.topology.half_thickness(nodes[3])};
      const auto [least, most] = std::minmax_element(t.begin(), t.end());
      if (*most == *least)
        return {0., 0., 0.};
      std::array<Point3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = Point3(scene.facets.position + 3 * nodes[k]);
      if (*most - *least < no_slope * (x[2] - x[0]).norm())
        return {0., 0., 0.};
      return compute_thickness_slope(x, t, weights);
    }

    std::ptrdiff_t count_common_nodes(const std::array<std::uint32_t, 4> &a, const std::array<std::uint32_t, 4> &b)
    {
      return std::count_if(a.begin(), a.end(),
                           [&](const std::uint32_t node) { return std::find(b.begin(), b.end(), node) != b.end(); });
    }

    /// Which of the two sides the point remembers is that of this facet, or -1: the one with the most common nodes, of
    /// the facet itself before one next to it, else one of the same piece; of the second touch of a piece none that the
    /// first has `taken`. Nearest and second change places in a fold or a notch: its sheets must not change their
    /// memories.
    int find_remembered(const PointRecord &before, const std::array<std::uint32_t, 4> &nodes, const std::int32_t piece,
                        const bool is_other_sheet, const int taken)
    {
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

    /// Of the overlap, what carries no force.
    /// `is_new`: another sheet of the same surface, or facets that have just come; `is_elsewhere`: another place of the
    /// surface than the one remembered.
    double inherited_reference(const ContactScene &scene, const EdgeTouch &edge, const PointRecord::Side &side,
                               const bool is_new, const bool is_elsewhere, const double approach)
    {
      if (scene.is_first)
        return edge.overlap;
      if (edge.feature == EdgeTouch::Feature::beyond) // it comes in from the side, or not at all
        return edge.overlap - std::max(edge.limit, 0.);
      const double kept = std::min(side.reference, edge.overlap);
      // a slide over small facets, on which the overlap is continuous, or another sheet: it gives no depth
      if (is_elsewhere)
        return std::max(kept, edge.overlap - approach - (side.is_touching ? side.overlap - side.reference : 0.));
      // just come in from there: what it has flown in this step past the plane, not more
      if (side.was_beyond)
        return std::max(kept, edge.overlap - 0.5 * edge.limit);
      // through the edge face into the middle surface, or back
      if (side.is_touching && side.is_on_edge_face != (edge.feature == EdgeTouch::Feature::edge_face))
        return edge.overlap;
      // of a point that did not touch it before, all that it has not come nearer in this step is no contact: it was
      // there before, beside the nearest sheet
      if (is_new && !side.is_touching)
        return edge.overlap - approach;
      return kept;
    }

    bool has_passed(const PointRecord &record, const std::uint64_t call)
    {
      return record.last_call + 1 == call && (record.sides[0].is_through || record.sides[1].is_through);
    }
  } // namespace

  /// The awake pairs [begin, end) of one point.
  struct NarrowPhase::Group
  {
    std::uint32_t begin, end, near;
  };

  void NarrowPhase::update(const ContactScene &scene, CandidateBlock &present, PointMemory &memory)
  {
    touching.clear();
    n_active_points = 0;
    block           = &present;
    if (present.is_new)
      keep_passed_awake(scene, memory);
    const double reach = std::max(scene.range, 4. * std::max(present.step_motion, scene.step * present.speed));
    pairs.find_awake(present, reach);
    present.n_awake = pairs.n();
    if (pairs.n() == 0)
      return;
    pairs.compute(scene.points, scene.facets, scene.topology, present);
    const auto near_of = [&](const std::uint32_t place) { return present.pair_near[pairs.pair[place]]; };
    for (std::uint32_t begin = 0, end = 0; begin < pairs.n(); begin = end)
      {
        const std::uint32_t near = near_of(begin);
        while (end < pairs.n() && near_of(end) == near)
          ++end;
        ++n_active_points;
        decide(scene, {begin, end, near}, reach, memory);
      }
  }

  std::uint32_t NarrowPhase::nearest(const Group &group) const
  {
    double        smallest = pairs.distance[group.begin];
    std::uint32_t best     = group.begin;
    for (std::uint32_t k = group.begin + 1; k < group.end; ++k)
      if (const double distance = pairs.distance[k]; distance < smallest * (1. - tie))
        {
          best     = k;
          smallest = distance;
        }
      else if (distance <= smallest * (1. + tie) &&
               std::abs(pairs.height[k]) > std::abs(pairs.height[best]) * (1. + tie))
        best = k;
    return best;
  }

  std::uint32_t NarrowPhase::way_in(const Group &group, const ContactScene &scene, const std::uint32_t closest,
                                    const PointRecord &before) const
  {
    if (before.last_call + 1 != scene.call || before.sides[0].sign == 0)
      return closest;
    const auto   &from = before.sides[0].outward;
    const Point3  outward(from[0], from[1], from[2]);
    std::uint32_t best = group.end;
    for (std::uint32_t k = group.begin; k < group.end; ++k)
      if ((best == group.end || pairs.distance[k] < pairs.distance[best]) &&
          unit_normal(scene.facets, facet_of(k)).dot(outward) > looks_outward)
        best = k;
    return best == group.end ? closest : best;
  }

  bool NarrowPhase::is_local_minimum(const Group &group, const ContactScene &scene, const std::uint32_t place) const
  {
    const auto &nodes  = scene.facets.nodes[facet_of(place)];
    const auto  shares = [&](const std::array<std::uint32_t, 4> &others) {
      for (unsigned int k = 0; k < 4; ++k)
        if (pairs.weight[k][place] > 0. && std::find(others.begin(), others.end(), nodes[k]) == others.end())
          return false;
      return true;
    };
    for (std::uint32_t k = group.begin; k < group.end; ++k)
      if (pairs.distance[k] < pairs.distance[place] * (1. - tie) && shares(scene.facets.nodes[facet_of(k)]))
        return false;
    return true;
  }

  std::int64_t NarrowPhase::opposed(const Group &group, const ContactScene &scene, const std::uint32_t first,
                                    const double reach) const
  {
    std::int64_t best = -1;
    const Point3 r1   = pairs.offset_of(first);
    for (std::uint32_t k = group.begin; k < group.end; ++k)
      if (k != first && pairs.distance[k] < reach && (scene.facets.two_sided || pairs.height[k] >= 0.) &&
          (best < 0 || pairs.distance[k] < pairs.distance[best]) &&
          pairs.offset_of(k).dot(r1) < share_starts_at * pairs.distance[k] * pairs.distance[first] &&
          is_local_minimum(group, scene, k))
        best = k;
    return best;
  }

  bool NarrowPhase::touch(const ContactScene &scene, const std::uint32_t place, const PointRecord &before,
                          const bool is_other_sheet, int &taken, TouchingPair &result, PointRecord::Side &side) const
  {
    const std::uint32_t facet    = facet_of(place);
    const std::int32_t  piece    = scene.topology.piece(facet);
    const double        distance = pairs.distance[place];
    const Point3        offset = pairs.offset_of(place), velocity = pairs.velocity_of(place);
    const bool          is_beyond     = scene.topology.is_on_rim(scene.facets, facet, pairs.weights_of(place));
    const bool          is_degenerate = distance < no_distance * before.size; // on the surface itself
    const Point3        normal        = is_degenerate ? unit_normal(scene.facets, facet) : Point3(0., 0., 0.);
    // on the surface itself the point is where it came from
    const std::int8_t seen = (is_degenerate ? -velocity.dot(normal) : pairs.height[place]) < 0. ? -1 : 1;

    // a second facet of the same piece is met on the side on which it is seen, unless it was known before: where a
    // surface folds, the other side of the first one means nothing to it
    const auto &nodes = scene.facets.nodes[facet];
    taken = before.last_call + 1 == scene.call ? find_remembered(before, nodes, piece, is_other_sheet, taken) : -1;
    side  = taken < 0 ? PointRecord::Side() : before.sides[taken];
    const bool is_elsewhere = taken >= 0 && count_common_nodes(side.nodes, nodes) == 0;

    // a change of sign within two steps' flight, or in touch, is a passage through the surface; else the point went
    // around; of one in touch, if the overlap has grown by no more than its way: else it is another sheet of a fold
    const double way        = 2. * std::max(velocity.norm() * scene.step, block->step_motion);
    const double if_past    = 0.5 * before.size + pairs.half_thickness[place] + distance;
    const bool   is_passage = side.is_touching ? if_past <= side.overlap + way + 1e-3 * before.size
                                               : distance <= 2. * velocity.norm() * scene.step;
    if (is_beyond)
      side.sign = 0;
    else if (side.piece < 0 || side.sign == 0 || (seen != side.sign && !is_passage))
      {
        if (!scene.facets.two_sided && seen < 0)
          {
            side = {};
            return false;
          }
        side.sign = seen;
      }
    side.piece = piece;
    side.nodes = nodes;
    if (!scene.facets.two_sided && seen > 0)
      {
        const Point3 outward = is_degenerate ? normal : Point3(offset / distance);
        for (unsigned int d = 0; d < 3; ++d)
          side.outward[d] = static_cast<float>(outward[d]);
      }
    const double sign = is_beyond ? 1. : side.sign * seen;
    EdgeTouch    edge{offset,
                   sign * distance,
                   pairs.half_thickness[place],
                   before.size,
                   is_beyond,
                   side.is_touching && side.is_on_edge_face,
                   0.5 * before.size + pairs.half_thickness[place] - sign * distance,
                   is_degenerate ? Point3((is_beyond ? seen : side.sign) * normal) : offset * (sign / distance)};
    if (!is_beyond)
      edge.slope = slope_at(scene, nodes, pairs.weights_of(place));
    if (const SharpEdges &edges = scene.topology.sharp_edges(); edges.are_near(facet))
      edges.cut(scene.facets, facet, pairs.closest_of(scene.facets, scene.facets.nodes[facet], place), edge);

    const double approach   = std::max(0., -velocity.dot(edge.normal - edge.slope)) * scene.step;
    const bool   is_inside  = edge.overlap > 0. && edge.limit > 0.;
    const bool   is_new     = scene.is_changed || is_other_sheet;
    side.reference          = std::max(inherited_reference(scene, edge, side, is_new, is_elsewhere, approach), 0.);
    side.is_touching        = is_inside;
    side.is_through         = is_inside && sign < 0.;
    side.was_beyond         = edge.feature == EdgeTouch::Feature::beyond;
    side.is_on_edge_face    = edge.feature == EdgeTouch::Feature::edge_face;
    const double depth      = edge.overlap - side.reference;
    const bool   is_limited = edge.limit < depth;
    side.overlap            = edge.overlap;
    result.place            = place;
    result.penetration      = is_limited ? edge.limit : depth;
    if (side.is_on_edge_face)
      edge.slope.setZero(); // its place does not depend on the thickness
    result.normal     = is_limited ? edge.limit_normal : Point3(edge.normal - edge.slope);
    result.is_oblique = is_limited || edge.is_oblique || !edge.slope.isZero(0.);
    return result.penetration > 0.;
  }

  void NarrowPhase::decide(const ContactScene &scene, const Group &group, const double reach, PointMemory &memory)
  {
    std::uint32_t closest = nearest(group);
    if (!scene.facets.two_sided && pairs.height[closest] < 0.)
      closest = way_in(group, scene, closest, memory[scene.points.id[block->points[group.near]]]);
    if (pairs.distance[closest] >= reach && !block->has_passed[group.near])
      return;
    PointRecord &record = memory[scene.points.id[block->points[group.near]]];

    const PointRecord before = record;
    TouchingPair      first, second;
    first.near = second.near = group.near;
    first.share = second.share = 0.;
    record.sides[1]            = {};
    record.last_call           = scene.call;
    int taken                  = -1;
    if (touch(scene, closest, before, false, taken, first, record.sides[0]))
      first.share = 1.;
    if (group.end - group.begin > 1)
      {
        const std::int64_t other =
          opposed(group, scene, closest, scene.topology.max_half_thickness() + 0.5 * before.size);
        const bool is_other_sheet =
          other >= 0 && scene.topology.piece(facet_of(static_cast<std::uint32_t>(other))) == record.sides[0].piece;
        if (other >= 0 &&
            touch(scene, static_cast<std::uint32_t>(other), before, is_other_sheet, taken, second, record.sides[1]))
          {
            const double cosine = first.share > 0. ? first.normal.normalized().dot(second.normal.normalized()) : -1.;
            const double ramp   = std::clamp((share_starts_at - cosine) / (share_starts_at - share_is_full_at), 0., 1.);
            second.share        = ramp * ramp * (3. - 2. * ramp);
          }
      }
    for (const TouchingPair &touched : {first, second})
      if (touched.share > 0.)
        touching.push_back(touched);
    block->has_passed[group.near] = has_passed(record, scene.call + 1);
    if (block->has_passed[group.near])
      keep_awake(group.near);
  }

  void NarrowPhase::keep_passed_awake(const ContactScene &scene, PointMemory &memory)
  {
    block->has_passed.resize(block->points.size());
    for (std::uint32_t near = 0; near < block->points.size(); ++near)
      {
        block->has_passed[near] = has_passed(memory[scene.points.id[block->points[near]]], scene.call);
        if (block->has_passed[near])
          keep_awake(near);
      }
    block->is_new = false;
  }

  void NarrowPhase::keep_awake(const std::uint32_t near)
  {
    const auto &points = block->pair_near;
    const auto  range  = std::equal_range(points.begin(), points.end(), near);
    for (auto k = range.first; k != range.second; ++k)
      block->pair_bound[static_cast<std::size_t>(k - points.begin())] = -1e300;
  }
} // namespace birdstrike
