#include <birdstrike/contact/gather.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double share_starts_at = 0.5, share_is_full_at = 0.2; // cosines between two touching directions
    constexpr double tie = 1e-9;                                    // relative difference of equal distances

    // below this share of the size the direction p - q is round-off, and the facet's normal takes its place
    constexpr double no_distance = 1e-6;
  } // namespace

  void NarrowPhase::update(const ContactScene &scene, PointMemory &memory, ThreadPool &pool)
  {
    ++n_calls;
    touching.clear();
    if (scene.candidates.n_pairs() == 0)
      return;
    compute_closest_points(scene, pool);
    slots.resize(2 * scene.candidates.n_near());
    pool.parallel_for(scene.candidates.n_near(), 128, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t near = begin; near < end; ++near)
        decide(scene, near, memory);
    });
    for (const TouchingPair &slot : slots)
      if (slot.share > 0.)
        touching.push_back(slot);
  }

  void NarrowPhase::compute_closest_points(const ContactScene &scene, ThreadPool &pool)
  {
    const std::size_t n = scene.candidates.pair_point().size();
    distances.resize(n);
    for (auto *arrays : {&offsets, &normals})
      for (auto &array : *arrays)
        array.resize(n);
    for (auto &array : weights)
      array.resize(n);

    const auto batch = [&](const std::size_t b) {
      const auto           x = gather_facets(scene.facets, &scene.candidates.pair_facet()[b]);
      const auto           q = compute_closest_point(gather_points(scene.points, &scene.candidates.pair_point()[b]), x);
      const Vector3<Lanes> normal = compute_area_vector(x);
      const Lanes          length = sqrt(normal.dot(normal));
      store(sqrt(q.distance_squared), &distances[b]);
      for (unsigned int d = 0; d < 3; ++d)
        {
          store(q.offset[d], &offsets[d][b]);
          store(normal[d] / length, &normals[d][b]);
        }
      for (unsigned int k = 0; k < 4; ++k)
        store(q.weights[k], &weights[k][b]);
    };
    pool.parallel_for(n, 32 * n_lanes, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t b = begin; b < end; b += n_lanes)
        batch(b);
    });
  }

  std::uint32_t NarrowPhase::nearest(const std::uint32_t begin, const std::uint32_t end) const
  {
    double        smallest = distances[begin];
    std::uint32_t best     = begin;
    double        seen     = -1.; // |r . N| of the best, computed only for ties
    const auto    look     = [&](const std::uint32_t k) {
      return std::abs(offsets[0][k] * normals[0][k] + offsets[1][k] * normals[1][k] + offsets[2][k] * normals[2][k]);
    };
    for (std::uint32_t k = begin + 1; k < end; ++k)
      if (distances[k] < smallest * (1. - tie))
        {
          best     = k;
          smallest = distances[k];
          seen     = -1.;
        }
      else if (distances[k] <= smallest * (1. + tie))
        {
          seen = seen < 0. ? look(best) : seen;
          if (const double other = look(k); other > seen * (1. + tie))
            {
              best = k;
              seen = other;
            }
        }
    return best;
  }

  bool NarrowPhase::is_local_minimum(const ContactScene &scene, const std::size_t near, const std::uint32_t pair) const
  {
    const auto &facet_of = scene.candidates.pair_facet();
    const auto &nodes    = scene.facets.nodes[facet_of[pair]];
    const auto  shares   = [&](const std::array<std::uint32_t, 4> &others) {
      for (unsigned int k = 0; k < 4; ++k)
        if (weights[k][pair] > 0. && std::find(others.begin(), others.end(), nodes[k]) == others.end())
          return false;
      return true;
    };
    for (std::uint32_t k = scene.candidates.first_pair()[near]; k < scene.candidates.first_pair()[near + 1]; ++k)
      if (distances[k] < distances[pair] * (1. - tie) && shares(scene.facets.nodes[facet_of[k]]))
        return false;
    return true;
  }

  std::int64_t NarrowPhase::opposed(const ContactScene &scene, const std::size_t near, const std::uint32_t first,
                                    const double reach) const
  {
    std::int64_t best = -1;
    const Point3 r1   = offset(first);
    for (std::uint32_t k = scene.candidates.first_pair()[near]; k < scene.candidates.first_pair()[near + 1]; ++k)
      if (k != first && distances[k] < reach && (best < 0 || distances[k] < distances[best]) &&
          offset(k).dot(r1) < share_starts_at * distances[k] * distances[first] && is_local_minimum(scene, near, k))
        best = k;
    return best;
  }

  /// How a pair lies, before its side is known.
  struct NarrowPhase::Gap
  {
    double      range;         // g, m
    double      travel;        // of the point past the surface within the step, m
    std::int8_t seen;          // side of the facet on which the point is
    bool        is_beyond;     // a free edge
    bool        is_degenerate; // on the surface itself
  };

  NarrowPhase::Gap NarrowPhase::compute_gap(const ContactScene &scene, const std::uint32_t pair,
                                            const double size) const
  {
    const std::uint32_t i = scene.candidates.pair_point()[pair], f = scene.candidates.pair_facet()[pair];
    const double        w[4] = {weights[0][pair], weights[1][pair], weights[2][pair], weights[3][pair]};
    const Point3        facet_normal(normals[0][pair], normals[1][pair], normals[2][pair]);

    Gap    gap;
    Point3 velocity(scene.points.velocity[0][i], scene.points.velocity[1][i], scene.points.velocity[2][i]);
    gap.range = 0.5 * size;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const std::uint32_t node = scene.facets.nodes[f][k];
        velocity -= w[k] * Eigen::Map<const Point3>(scene.facets.velocity + node * scene.facets.velocity_stride);
        gap.range += w[k] * scene.topology.half_thickness(node);
      }
    gap.travel        = velocity.norm() * scene.step;
    gap.is_beyond     = scene.topology.is_on_rim(scene.facets, f, w);
    gap.is_degenerate = distances[pair] < no_distance * size;
    // on the surface itself the point is where it came from
    gap.seen = (gap.is_degenerate ? -velocity.dot(facet_normal) : offset(pair).dot(facet_normal)) < 0. ? -1 : 1;
    return gap;
  }

  bool NarrowPhase::touch(const ContactScene &scene, const std::uint32_t pair, const PointRecord &before,
                          TouchingPair &result, PointRecord::Side &side) const
  {
    const Gap          gap   = compute_gap(scene, pair, before.size);
    const std::int32_t piece = scene.topology.piece(scene.candidates.pair_facet()[pair]);
    side                     = {};
    if (before.last_call + 1 == n_calls)
      for (const PointRecord::Side &old : before.sides)
        if (old.piece == piece && side.piece < 0)
          side = old;

    // a change of sign within two steps' flight, or in touch, is a passage through the surface; else the point went
    // around
    const bool is_passage = side.is_touching || distances[pair] <= 2. * gap.travel;
    if (gap.is_beyond)
      side.sign = 0;
    else if (side.piece < 0 || side.sign == 0 || (gap.seen != side.sign && !is_passage))
      {
        if (!scene.facets.two_sided && gap.seen < 0)
          {
            side = {};
            return false;
          }
        side.sign = gap.seen;
      }
    side.piece           = piece;
    const double sign    = gap.is_beyond ? 1. : side.sign * gap.seen;
    const double overlap = gap.range - sign * distances[pair];
    side.reference       = std::max(scene.is_first ? overlap : std::min(side.reference, overlap), 0.);
    side.is_touching     = overlap > 0.;
    result.pair          = pair;
    result.penetration   = overlap - side.reference;
    result.normal        = offset(pair) * (sign / distances[pair]);
    if (gap.is_degenerate)
      result.normal =
        (gap.is_beyond ? gap.seen : side.sign) * Point3(normals[0][pair], normals[1][pair], normals[2][pair]);
    return result.penetration > 0.;
  }

  void NarrowPhase::decide(const ContactScene &scene, const std::size_t near, PointMemory &memory)
  {
    const std::uint32_t begin = scene.candidates.first_pair()[near], end = scene.candidates.first_pair()[near + 1];
    PointRecord        &record = memory[scene.points.id[scene.candidates.pair_point()[begin]]];
    const PointRecord   before = record;
    TouchingPair       &first = slots[2 * near], &second = slots[2 * near + 1];
    first.share = second.share = 0.;
    record.sides[1]            = {};
    record.last_call           = n_calls;

    const std::uint32_t closest = nearest(begin, end);
    if (touch(scene, closest, before, first, record.sides[0]))
      first.share = 1.;
    if (end - begin < 2)
      return;
    const std::int64_t other = opposed(scene, near, closest, scene.topology.max_half_thickness() + 0.5 * before.size);
    if (other < 0 || !touch(scene, static_cast<std::uint32_t>(other), before, second, record.sides[1]))
      return;
    const double cosine = first.share > 0. ? first.normal.dot(second.normal) : -1.;
    const double ramp   = std::clamp((share_starts_at - cosine) / (share_starts_at - share_is_full_at), 0., 1.);
    second.share        = ramp * ramp * (3. - 2. * ramp);
  }
} // namespace birdstrike
