#include "contact/touch/common_nodes.h"
#include "contact/touch/edge_frame.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double tie           = 1e-9; // difference of equal distances over the range, of equal heights relative
    constexpr double looks_outward = 0.25; // cosine between a facet's normal and where a point came from

    /// m, from where on a point is looked at that moves by `way` in a step. Pairs are listed up to one step's way
    /// beyond the range (search.h); of what is further away the axes would say whether it was seen.
    double looked_at_from(const ContactScene &scene, const double way)
    {
      return std::max(scene.range, std::min(4. * way, scene.range + way));
    }

    bool has_passed(const PointRecord &record, const std::uint64_t call)
    {
      return record.last_call + 1 == call && (record.sides[0].is_through || record.sides[1].is_through);
    }
    /// A side of a hollow that ends below the point, at an edge of the nearest one: its depth goes on there. `taken`
    /// are the remembered sides that present ones continue, or -1.
    void take_over(const PointRecord &before, const std::array<int, 2> &taken, PointRecord::Side &nearest,
                   TouchingPair &result)
    {
      const bool is_limited = nearest.depth < nearest.overlap - nearest.reference;
      for (int k = 0; k < 2; ++k)
        if (const PointRecord::Side &gone = before.sides[k];
            k != taken[0] && k != taken[1] && gone.is_touching && gone.piece == nearest.piece &&
            gone.depth > nearest.depth && !is_limited && count_common_nodes(gone.nodes, nearest.nodes) > 0)
          {
            nearest.reference  = std::max(0., nearest.overlap - gone.depth);
            nearest.depth      = nearest.overlap - nearest.reference;
            result.penetration = nearest.depth;
          }
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
    released_depths.clear();
    touching.reserve(2 * present.points.size()); // never within a step without a search
    released_depths.reserve(present.points.size());
    n_active_points = 0;
    block           = &present;
    tied            = tie * scene.range;
    if (present.is_new)
      keep_passed_awake(scene, memory);
    const double reach = looked_at_from(scene, std::max(present.step_motion, scene.step * present.speed));
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
        decide(scene, {begin, end, near}, memory);
      }
  }

  bool NarrowPhase::is_before(const std::uint32_t k, const std::uint32_t best) const
  {
    const double further = pairs.distance[k] - pairs.distance[best];
    return further < -tied ||
           (further <= tied && std::abs(pairs.height[k]) > std::abs(pairs.height[best]) * (1. + tie));
  }

  std::uint32_t NarrowPhase::nearest(const Group &group) const
  {
    std::uint32_t best = group.begin;
    for (std::uint32_t k = group.begin + 1; k < group.end; ++k)
      if (is_before(k, best))
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
      if ((best == group.end || is_before(k, best)) &&
          compute_area_vector(facet_nodes(scene.facets, facet_of(k))).normalized().dot(outward) > looks_outward)
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
      if (pairs.distance[k] < pairs.distance[place] - tied && shares(scene.facets.nodes[facet_of(k)]))
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
          (best < 0 || is_before(k, static_cast<std::uint32_t>(best))) &&
          pairs.offset_of(k).dot(r1) < share_starts_at * pairs.distance[k] * pairs.distance[first] &&
          is_local_minimum(group, scene, k))
        best = k;
    return best;
  }

  void NarrowPhase::decide(const ContactScene &scene, const Group &group, PointMemory &memory)
  {
    std::uint32_t closest = nearest(group);
    if (!scene.facets.two_sided && pairs.height[closest] < 0.)
      closest = way_in(group, scene, closest, memory[scene.points.id[block->points[group.near]]]);
    if (pairs.distance[closest] >= looked_at_from(scene, way_of(scene, closest)) && !block->has_passed[group.near])
      return;
    PointRecord &record = memory[scene.points.id[block->points[group.near]]];

    const PointRecord before = record;
    TouchingPair     &first  = touching.emplace_back(); // written where it stays
    TouchingPair      second;
    first.near = second.near = group.near;
    record.sides[1]          = unknown_side;
    record.last_call         = scene.call;
    int taken                = -1;
    if (touch(scene, closest, before, false, taken, first, record.sides[0]))
      first.share = 1.;
    std::array<int, 2> continued{{taken, -1}};
    if (group.end - group.begin > 1)
      {
        const std::int64_t other =
          opposed(group, scene, closest, scene.topology.max_half_thickness() + 0.5 * before.size);
        const bool is_other_sheet =
          other >= 0 && scene.topology.piece(facet_of(static_cast<std::uint32_t>(other))) == record.sides[0].piece;
        if (other >= 0 &&
            touch(scene, static_cast<std::uint32_t>(other), before, is_other_sheet, taken, second, record.sides[1]))
          {
            // the deeper one counts, whichever is nearer: where they change places they are equally deep
            const double cosine = first.share > 0. ? first.normal.normalized().dot(second.normal.normalized()) : -1.;
            const double ramp   = std::clamp((share_starts_at - cosine) / (share_starts_at - share_is_full_at), 0., 1.);
            double      &shallower = first.penetration < second.penetration ? first.share : second.share;
            second.share           = 1.;
            shallower *= ramp * ramp * (3. - 2. * ramp);
          }
        continued[1] = taken;
      }
    if (first.share == 1. && before.last_call + 1 == scene.call && !scene.is_changed)
      take_over(before, continued, record.sides[0], first);
    const double depth =
      std::max(first.share > 0. ? first.penetration : 0., second.share > 0. ? second.penetration : 0.);
    if (!(first.share > 0.))
      touching.pop_back();
    if (second.share > 0.)
      touching.push_back(second);
    if (!scene.is_changed)
      note_release(scene, block->points[group.near], before, record, depth);
    block->has_passed[group.near] = has_passed(record, scene.call + 1);
    if (block->has_passed[group.near])
      keep_awake(group.near);
  }

  void NarrowPhase::note_release(const ContactScene &scene, const std::uint32_t point, const PointRecord &before,
                                 const PointRecord &record, const double depth)
  {
    double due = std::max(before.sides[0].depth, before.sides[1].depth) - leap * before.size;
    if (before.last_call + 1 != scene.call || due <= depth)
      return;
    // against any node of its facets: light ones go their own ways, and bend them
    const auto  &v = scene.points.velocity;
    const Point3 velocity(v[0][point], v[1][point], v[2][point]);
    double       largest = 0.;
    for (const auto *side : {&before.sides[0], &before.sides[1], &record.sides[0], &record.sides[1]})
      if (side->piece >= 0)
        for (const std::uint32_t n : side->nodes)
          largest =
            std::max(largest, (velocity - Point3(scene.facets.velocity + n * scene.facets.velocity_stride)).norm());
    due -= scene.step * largest;
    if (due > depth)
      released_depths.push_back({scene.points.id[point], due, depth});
  }

  /// Its own, by the velocities of the drift, not what the search has seen it move: which points share a block, and
  /// when it was tracked or sorted anew, is a matter of the axes.
  double NarrowPhase::way_of(const ContactScene &scene, const std::uint32_t place) const
  {
    return scene.step * pairs.velocity_of(place).norm();
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
