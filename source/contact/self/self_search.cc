#include <birdstrike/contact/self_search.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double margin_over_edge = 0.5;
    constexpr double margin_in_steps  = 12.;  // of the fastest node
    constexpr double margin_used      = 0.75; // of it before the next look: the rest is what reach() promises
    constexpr double own_range        = 2.;   // of a neighbourhood, in sums of half thicknesses
  }                                           // namespace

  bool SelfSearch::update(const FacetsView &facets, const SurfaceTopology &topology, const double step,
                          const std::vector<std::array<std::uint32_t, 2>> &touched)
  {
    const bool is_changed =
      !is_known || facets.revision != revision || facets.n_facets != n_facets || seen.size() != 3 * facets.n_nodes;
    if (is_changed)
      set_surface(facets, topology);
    if (is_changed || has_to_look(facets))
      look(facets, topology, step, touched);
    return is_changed;
  }

  void SelfSearch::set_surface(const FacetsView &facets, const SurfaceTopology &topology)
  {
    if (reference.size() != 3 * facets.n_nodes)
      {
        reference.assign(facets.position, facets.position + 3 * facets.n_nodes);
        is_torn = false;
      }
    else
      is_torn = true;
    patches.update(facets, reference, own_range * 2. * topology.max_half_thickness());
    list_facets_of_nodes(facets);
    revision = facets.revision;
    n_facets = facets.n_facets;
    is_known = true;
  }

  void SelfSearch::list_facets_of_nodes(const FacetsView &facets)
  {
    partners.resize(patches.size());
    facet_mark.assign(facets.n_facets, 0);
    node_mark.assign(facets.n_nodes, 0);
    mark = 0;

    first_facet.assign(facets.n_nodes + 1, 0);
    const auto each_corner = [&](const auto &body) {
      for (std::uint32_t f = 0; f < facets.n_facets; ++f)
        for (unsigned int k = 0; k < 4; ++k)
          if (k < 3 || facets.nodes[f][3] != facets.nodes[f][2])
            body(f, facets.nodes[f][k]);
    };
    each_corner([&](std::uint32_t, const std::uint32_t node) { ++first_facet[node + 1]; });
    for (std::size_t n = 0; n < facets.n_nodes; ++n)
      first_facet[n + 1] += first_facet[n];
    facets_of_node.resize(first_facet.back());
    std::vector<std::uint32_t> next(first_facet.begin(), first_facet.end() - 1);
    each_corner([&](const std::uint32_t f, const std::uint32_t node) { facets_of_node[next[node]++] = f; });

    anchor = facets.n_facets > 0 ? *std::min_element(facets.nodes[0].begin(), facets.nodes[0].end()) : 0;
  }

  bool SelfSearch::has_to_look(const FacetsView &facets)
  {
    const double motion = largest_motion(facets), of_step = motion - last_motion;
    last_motion = motion;
    return 2. * motion > margin_used * margin || 2. * motion + 4. * of_step > margin;
  }

  /// How far any node has moved since the last look in the frame of the anchor, m: its true distance, as the largest of
  /// each component would leave it to the axes when a look comes, and so which patches it finds turned back.
  double SelfSearch::largest_motion(const FacetsView &facets) const
  {
    if (facets.n_facets == 0)
      return 0.;
    const double *x = facets.position, *old = seen.data();
    const Point3  shift           = Point3(x + 3 * anchor) - Point3(old + 3 * anchor);
    double        largest_squared = 0.;
    const auto    add             = [&](const std::size_t node) {
      largest_squared =
        std::max(largest_squared, (Point3(x + 3 * node) - Point3(old + 3 * node) - shift).squaredNorm());
    };
    if (patches.has_loose_nodes())
      for (std::uint32_t p = 0; p < patches.size(); ++p)
        for (const std::uint32_t node : patches.points_of(p))
          add(node);
    else
      {
        // three registers hold whole nodes, and their lanes repeat the components; the sum of a node's three squares
        // stands in the lane of its first
        std::array<Lanes, 3>                            shifts, is_first;
        alignas(64) std::array<double, 3 * n_lanes + 2> squares{};
        Lanes                                           largest(0.);
        for (std::size_t r = 0; r < 3; ++r)
          {
            shifts[r]   = Lanes([&](const auto j) { return shift[static_cast<Eigen::Index>((r * n_lanes + j) % 3)]; });
            is_first[r] = Lanes([&](const auto j) { return (r * n_lanes + j) % 3 == 0 ? 1. : 0.; });
          }
        std::size_t e = 0;
        for (; e + 3 * n_lanes <= 3 * facets.n_nodes; e += 3 * n_lanes)
          {
            for (std::size_t r = 0; r < 3; ++r)
              {
                const Lanes dx = load<Lanes>(x + e + r * n_lanes) - load<Lanes>(old + e + r * n_lanes) - shifts[r];
                store(Lanes(dx * dx), &squares[r * n_lanes]);
              }
            for (std::size_t r = 0; r < 3; ++r)
              {
                const double *of = &squares[r * n_lanes];
                largest = max(largest, is_first[r] * (load<Lanes>(of) + load<Lanes>(of + 1) + load<Lanes>(of + 2)));
              }
          }
        largest_squared = stdx::hmax(largest);
        for (; e < 3 * facets.n_nodes; e += 3)
          add(e / 3);
      }
    return std::sqrt(largest_squared);
  }

  void SelfSearch::set_margin(const FacetsView &facets, const double step)
  {
    const auto velocity = [&](const std::uint32_t node) {
      return Point3(facets.velocity + facets.velocity_stride * node);
    };
    double fastest = 0.;
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (const std::uint32_t node : patches.points_of(p))
        fastest = std::max(fastest, (velocity(node) - velocity(anchor)).squaredNorm());
    margin = std::max(margin_over_edge * patches.smallest_edge(), margin_in_steps * std::sqrt(fastest) * step);
  }

  void SelfSearch::look(const FacetsView &facets, const SurfaceTopology &topology, const double step,
                        const std::vector<std::array<std::uint32_t, 2>> &touched)
  {
    ++looks;
    pairs.clear();
    seen.assign(facets.position, facets.position + 3 * facets.n_nodes);
    last_motion = 0.;
    if (facets.n_facets == 0)
      return;
    set_margin(facets, step);
    patches.look(facets);
    std::vector<SurfacePatches::Pair> always;
    for (const auto &[point, node] : touched)
      for (std::uint32_t e = first_facet[node]; e < first_facet[node + 1]; ++e)
        {
          const std::uint32_t a = patches.patch_of_point(point), b = patches.patch_of_facet(facets_of_node[e]);
          always.push_back({{std::min(a, b), std::max(a, b)}});
        }
    patches.find_close(facets, 2. * topology.max_half_thickness() + margin, std::move(always));
    add_candidates(facets, topology, patches.close_pairs(), false);
    if (is_torn)
      add_candidates(facets, topology, patches.flat_pairs(), true);
    std::sort(pairs.begin(), pairs.end(), [](const Candidate &a, const Candidate &b) {
      return a.point != b.point ? a.point < b.point : a.facet < b.facet;
    });
  }

  void SelfSearch::add_candidates(const FacetsView &facets, const SurfaceTopology &topology,
                                  const std::vector<SurfacePatches::Pair> &of_patches, const bool rims_alone)
  {
    if (of_patches.empty())
      return;
    for (auto &list : partners)
      list.clear();
    for (const auto &[a, b] : of_patches)
      {
        partners[a].push_back(b);
        if (a != b)
          partners[b].push_back(a);
      }
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      if (!partners[p].empty())
        add_candidates(facets, topology, p, rims_alone);
  }

  void SelfSearch::add_candidates(const FacetsView &facets, const SurfaceTopology &topology, const std::uint32_t patch,
                                  const bool rims_alone)
  {
    const auto has_rim = [&](const std::uint32_t facet) {
      for (unsigned int k = 0; k < 4; ++k)
        if (facets.neighbor[facet][k] == FacetsView::free_edge && is_edge(facets.nodes[facet], k))
          return true;
      return false;
    };
    for (const std::uint32_t point : patches.points_of(patch))
      {
        if (rims_alone && !topology.is_on_rim(point))
          continue;
        const double reach = topology.half_thickness(point) + topology.max_half_thickness() + margin;
        Box          here;
        here.add(facets.position + 3 * point);
        near_facets.clear();
        for (const std::uint32_t other : partners[patch])
          if (patches.box(other).separation(here) <= reach)
            for (const std::uint32_t f : patches.facets_of(other))
              if (patches.facet_box(f).separation(here) <= reach && (!rims_alone || has_rim(f)))
                near_facets.push_back(f);
        if (near_facets.empty())
          continue;
        mark_neighborhood(facets, topology, point);
        for (const std::uint32_t f : near_facets)
          if (facet_mark[f] != mark)
            {
              unsigned char own = 0;
              for (unsigned int k = 0; k < 4; ++k)
                if (node_mark[facets.nodes[f][k]] == mark)
                  own = static_cast<unsigned char>(own | 1U << k);
              pairs.push_back({point, f, own});
            }
      }
  }

  void SelfSearch::mark_neighborhood(const FacetsView &facets, const SurfaceTopology &topology,
                                     const std::uint32_t point)
  {
    ++mark;
    front.clear();
    const auto take = [&](const std::uint32_t facet) {
      facet_mark[facet] = mark;
      front.push_back(facet);
    };
    for (std::uint32_t e = first_facet[point]; e < first_facet[point + 1]; ++e)
      take(facets_of_node[e]);
    for (std::size_t k = 0; k < front.size(); ++k)
      for (const std::uint32_t node : facets.nodes[front[k]])
        {
          if (node_mark[node] == mark)
            continue;
          node_mark[node] = mark;
          for (std::uint32_t e = first_facet[node]; e < first_facet[node + 1]; ++e)
            if (const std::uint32_t f = facets_of_node[e];
                facet_mark[f] != mark && reference_distance(facets, point, f) <
                                           own_range * (topology.half_thickness(point) + facets.half_thickness[f]))
              take(f);
        }
  }

  double SelfSearch::reference_distance(const FacetsView &facets, const std::uint32_t point,
                                        const std::uint32_t facet) const
  {
    std::array<Point3, 4> x;
    for (unsigned int k = 0; k < 4; ++k)
      x[k] = Point3(&reference[3 * facets.nodes[facet][k]]);
    return std::sqrt(compute_closest_point(Point3(&reference[3 * point]), x).distance_squared);
  }
} // namespace birdstrike
