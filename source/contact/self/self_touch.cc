#include "contact/touch/common_nodes.h"
#include <birdstrike/contact/self_touch.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double share_starts_at = 0.5, share_is_full_at = 0.2; // cosines between two directions of touch
    constexpr double tie           = 1e-9;                          // relative difference of equal distances
    constexpr double known_from    = 0.125;                         // edges beyond touch, or ...
    constexpr double known_before  = 1.5;  // ... so many steps' flight. When a look came must not matter
    constexpr double looks_outward = 0.25; // cosine between a facet's normal and where a node came from

    // below this share of an edge the direction p - q is round-off, and the facet's normal takes its place
    constexpr double no_distance_over_edge = 1e-7;

    Point3 point_at(const FacetsView &facets, const std::uint32_t node)
    {
      return Point3(facets.position + 3 * node);
    }

    Point3 relative_velocity(const FacetsView &facets, const std::uint32_t point,
                             const std::array<std::uint32_t, 4> &nodes, const std::array<double, 4> &weights)
    {
      Point3 velocity(facets.velocity + facets.velocity_stride * point);
      for (unsigned int k = 0; k < 4; ++k)
        velocity -= weights[k] * Point3(facets.velocity + facets.velocity_stride * nodes[k]);
      return velocity;
    }

    bool have_common_node(const std::array<std::uint32_t, 4> &a, const std::array<std::uint32_t, 4> &b)
    {
      return std::any_of(a.begin(), a.end(),
                         [&](const std::uint32_t n) { return std::find(b.begin(), b.end(), n) != b.end(); });
    }
  } // namespace

  void SelfTouches::update(const FacetsView &facets, const SurfaceTopology &topology, const SelfSearch &search,
                           const double step, const bool is_changed)
  {
    ++call;
    found.clear();
    tested            = 0;
    const auto &pairs = search.candidates();
    if (!pairs.empty() && records.size() != facets.n_nodes)
      records.assign(facets.n_nodes, Record());
    if (found.capacity() < 2 * pairs.size()) // lists grow with a look, never within a step
      found.reserve(4 * pairs.size());
    if (group.capacity() < pairs.size())
      group.reserve(2 * pairs.size());

    const Scene scene{facets,    topology, step, no_distance_over_edge * search.edge(), known_from * search.edge(),
                      is_changed};
    for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end)
      {
        const std::uint32_t point = pairs[begin].point;
        group.clear();
        for (; end < pairs.size() && pairs[end].point == point; ++end)
          evaluate(scene, pairs[end], search.reach());
        if (!group.empty())
          decide(scene, point);
      }
  }

  void SelfTouches::evaluate(const Scene &scene, const SelfSearch::Candidate &candidate, const double reach)
  {
    const auto  x     = facet_nodes(scene.facets, candidate.facet);
    const auto  p     = point_at(scene.facets, candidate.point);
    const auto &nodes = scene.facets.nodes[candidate.facet];
    double      gap   = scene.topology.half_thickness(candidate.point);
    double      most  = 0.;
    for (const std::uint32_t node : nodes)
      most = std::max(most, scene.topology.half_thickness(node));
    gap += most;
    const double box_gap = gap + reach;
    for (unsigned int d = 0; d < 3; ++d)
      if (p[d] - box_gap > std::max({x[0][d], x[1][d], x[2][d], x[3][d]}) ||
          p[d] + box_gap < std::min({x[0][d], x[1][d], x[2][d], x[3][d]}))
        return;
    ++tested;
    Near near{candidate.facet, compute_closest_point(p, x), 0., 0., compute_area_vector(x).normalized()};
    near.distance       = std::sqrt(near.closest.distance_squared);
    const double flight = relative_velocity(scene.facets, candidate.point, nodes, near.weights()).norm() * scene.step;
    if (near.distance > gap + std::max(scene.known_from, known_before * flight))
      return;
    bool is_own = true; // on the rim of the neighbourhood: the surface goes on there
    for (unsigned int k = 0; k < 4; ++k)
      if (near.closest.weights[k] > 0. && !(candidate.own & 1U << k))
        is_own = false;
    if (is_own)
      return;
    near.height = near.closest.offset.dot(near.normal);
    group.push_back(near);
  }

  std::size_t SelfTouches::nearest(const Scene &scene, const Record &before) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k < group.size(); ++k)
      if (group[k].distance < group[best].distance * (1. - tie) ||
          (group[k].distance <= group[best].distance * (1. + tie) &&
           std::abs(group[k].height) > std::abs(group[best].height) * (1. + tie)))
        best = k;
    if (scene.facets.two_sided || group[best].height >= 0. || before.last_call + 1 != call || !before.sides[0].is_known)
      return best;
    // inside a solid: out the way it came in
    std::size_t way_in = group.size();
    for (std::size_t k = 0; k < group.size(); ++k)
      if ((way_in == group.size() || group[k].distance < group[way_in].distance) &&
          group[k].normal.dot(before.sides[0].outward) > looks_outward)
        way_in = k;
    return way_in == group.size() ? best : way_in;
  }

  bool SelfTouches::is_local_minimum(const Scene &scene, const std::size_t place) const
  {
    const auto &nodes  = scene.facets.nodes[group[place].facet];
    const auto  shares = [&](const std::array<std::uint32_t, 4> &others) {
      for (unsigned int k = 0; k < 4; ++k)
        if (group[place].closest.weights[k] > 0. && std::find(others.begin(), others.end(), nodes[k]) == others.end())
          return false;
      return true;
    };
    for (const Near &other : group)
      if (other.distance < group[place].distance * (1. - tie) && shares(scene.facets.nodes[other.facet]))
        return false;
    return true;
  }

  std::size_t SelfTouches::opposed(const Scene &scene, const std::size_t first, const double reach) const
  {
    std::size_t  best = group.size();
    const Point3 r1   = group[first].closest.offset;
    for (std::size_t k = 0; k < group.size(); ++k)
      if (k != first && group[k].distance < reach && (scene.facets.two_sided || group[k].height >= 0.) &&
          (best == group.size() || group[k].distance < group[best].distance) &&
          group[k].closest.offset.dot(r1) < share_starts_at * group[k].distance * group[first].distance &&
          is_local_minimum(scene, k))
        best = k;
    return best;
  }

  SelfSide SelfTouches::remembered(const Scene &scene, const Near &near, const Record &before)
  {
    if (before.last_call + 1 == call)
      for (const SelfSide &old : before.sides)
        if (old.is_known && have_common_node(old.nodes, scene.facets.nodes[near.facet]))
          return old;
    return {};
  }

  bool SelfTouches::touch(const Scene &scene, const std::uint32_t point, const Near &near, const Record &before,
                          SelfTouch &result, SelfSide &side)
  {
    const auto  &nodes     = scene.facets.nodes[near.facet];
    const Point3 velocity  = relative_velocity(scene.facets, point, nodes, near.weights());
    const bool   is_beyond = scene.topology.is_on_rim(scene.facets, near.facet, near.weights());
    const bool   is_on_it  = near.distance < scene.no_distance;
    // on the surface itself the node is where it came from
    const std::int8_t seen = (is_on_it ? -velocity.dot(near.normal) : near.height) < 0. ? -1 : 1;

    side                    = remembered(scene, near, before);
    const bool   is_new     = !side.is_known;
    const bool   is_next    = side.is_known && !are_same(side.nodes, nodes); // another facet than in the last call
    const double travelled  = velocity.norm() * scene.step;
    const bool   is_passage = side.is_touching || near.distance <= 2. * travelled;
    if (is_beyond)
      side.sign = 0;
    else if (is_new || side.sign == 0 || (seen != side.sign && !is_passage))
      {
        side.sign = seen;
        if (!scene.facets.two_sided && seen < 0)
          return false; // within the solid: it was never outside
      }
    side.is_known = true;
    side.nodes    = nodes;
    if (!scene.facets.two_sided && seen > 0)
      side.outward = is_on_it ? near.normal : Point3(near.closest.offset / near.distance);

    const double sign = is_beyond ? 1. : side.sign * seen;
    double       gap  = scene.topology.half_thickness(point);
    for (unsigned int k = 0; k < 4; ++k)
      gap += near.closest.weights[k] * scene.topology.half_thickness(nodes[k]);
    const double overlap = gap - sign * near.distance;
    result.normal =
      is_on_it ? Point3((is_beyond ? seen : side.sign) * near.normal) : near.closest.offset * (sign / near.distance);
    // what it has not come nearer in this step it has from before: the way along the sheet would be energy for nothing
    const double approach = std::max(0., -velocity.dot(result.normal)) * scene.step;
    side.reference        = std::max(0., is_new && scene.is_changed ? overlap
                                         : is_new                   ? overlap - approach
                                                                    : std::min(side.reference, overlap));
    if (is_next && overlap - side.reference > side.depth + 2. * travelled)
      side.reference = overlap - side.depth - approach;
    side.is_touching   = overlap > side.reference;
    side.depth         = std::max(0., overlap - side.reference);
    result.point       = point;
    result.nodes       = nodes;
    result.weights     = near.weights();
    result.penetration = overlap - side.reference;
    if (!side.is_touching)
      side.stiffness = 0.;
    return side.is_touching;
  }

  void SelfTouches::decide(const Scene &scene, const std::uint32_t point)
  {
    const Record      before  = records[point];
    Record           &record  = records[point];
    const std::size_t closest = nearest(scene, before);
    record                    = Record();
    record.last_call          = call;

    SelfTouch first, second;
    first.side  = 0;
    second.side = 1;
    if (touch(scene, point, group[closest], before, first, record.sides[0]))
      first.share = 1.;
    const std::size_t other =
      opposed(scene, closest, scene.topology.max_half_thickness() + scene.topology.half_thickness(point));
    if (other < group.size() && touch(scene, point, group[other], before, second, record.sides[1]))
      {
        const double cosine = first.share > 0. ? first.normal.dot(second.normal) : -1.;
        const double ramp   = std::clamp((share_starts_at - cosine) / (share_starts_at - share_is_full_at), 0., 1.);
        second.share        = ramp * ramp * (3. - 2. * ramp);
      }
    for (const SelfTouch &touched : {first, second})
      if (touched.share > 0.)
        found.push_back(touched);
      else
        record.sides[touched.side].touch = 0;
  }
} // namespace birdstrike
