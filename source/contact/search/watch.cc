#include <birdstrike/contact/search.h>

#include <algorithm>
#include <cmath>
#include <functional>

// What is looked at in every call: the boxes of points and nodes, and how far the tracked ones have moved.
namespace birdstrike
{
  namespace
  {
    constexpr std::size_t nodes_per_part = 1024; // a multiple of all lane counts
    constexpr std::size_t min_units      = 8;    // blocks that are worth a second thread's wake-up

    /// Low, high and largest squared motion of the points [i, i + lanes).
    template <class Number>
    struct PointsSeen
    {
      std::array<Number, 3> low{{Number(1e300), Number(1e300), Number(1e300)}},
        high{{Number(-1e300), Number(-1e300), Number(-1e300)}};
      Number motion_squared = Number(0.);

      template <bool is_tracked>
      [[gnu::always_inline]] void add(const PointsView &points, std::array<AlignedVector<double>, 3> &old,
                                      const Point3 &shift, const std::size_t i, double *own)
      {
        Number sum(0.);
        for (unsigned int d = 0; d < 3; ++d)
          {
            const Number x = load<Number>(points.position[d] + i);
            low[d]         = min(low[d], x);
            high[d]        = max(high[d], x);
            if constexpr (is_tracked)
              {
                const Number dx = x - load<Number>(old[d].data() + i) - Number(shift[d]);
                sum += dx * dx;
                store(x, old[d].data() + i);
              }
          }
        if constexpr (is_tracked)
          {
            motion_squared = max(motion_squared, sum);
            store(sum, own);
          }
      }
    };
  } // namespace

  void CandidateSearch::set_node_parts(const FacetsView &facets)
  {
    node_parts.assign((facets.n_nodes + nodes_per_part - 1) / nodes_per_part, NodePart{});
    is_loose.assign(facets.n_nodes, 1);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t node : facets.nodes[f])
        is_loose[node] = 0;
    for (std::size_t n = 0; n < facets.n_nodes; ++n)
      node_parts[n / nodes_per_part].has_loose |= is_loose[n] != 0;
  }

  void CandidateSearch::watch(const PointsView &points, const FacetsView &facets, ThreadPool &pool)
  {
    const Point3 shift =
      is_tracking && facets.n_nodes > 0
        ? Point3(Eigen::Map<const Point3>(facets.position) - Eigen::Map<const Point3>(old_nodes.data()))
        : Point3(0., 0., 0.);
    const auto watch_units = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t u = begin; u < end; ++u)
        if (u < node_parts.size())
          node_parts[u].has_loose ? watch_facet_nodes(facets, shift, u) : watch_nodes(facets, shift, u);
        else
          watch_points(points, shift, all_blocks[u - node_parts.size()]);
    };
    pool.parallel_for(node_parts.size() + all_blocks.size(), min_units, std::ref(watch_units));

    surface                     = Box();
    double nodes_motion_squared = 0.;
    for (const NodePart &part : node_parts)
      {
        surface.add(part.box);
        nodes_motion_squared = std::max(nodes_motion_squared, part.motion_squared);
      }
    largest_node_motion = std::sqrt(nodes_motion_squared);
    last_motion         = 0.;
    for (CandidateBlock &block : all_blocks)
      {
        block.step_motion = block.is_tracked ? std::sqrt(block.motion_squared) + largest_node_motion : 0.;
        block.path += block.step_motion;
        last_motion = std::max(last_motion, block.step_motion);
      }
  }

  void CandidateSearch::watch_points(const PointsView &points, const Point3 &shift, CandidateBlock &block)
  {
    PointsSeen<Lanes>  wide;
    PointsSeen<double> tail;
    const auto         look = [&]<bool is_tracked>(std::integral_constant<bool, is_tracked>) {
      std::size_t i = block.begin;
      for (; i + n_lanes <= block.end; i += n_lanes)
        wide.add<is_tracked>(points, old_points, shift, i, &block.point_motions_squared[i - block.begin]);
      for (; i < block.end; ++i)
        tail.add<is_tracked>(points, old_points, shift, i, &block.point_motions_squared[i - block.begin]);
    };
    if (block.is_tracked)
      look(std::true_type());
    else
      look(std::false_type());
    for (unsigned int d = 0; d < 3; ++d)
      {
        block.box.low[d]  = std::min(stdx::hmin(wide.low[d]), tail.low[d]);
        block.box.high[d] = std::max(stdx::hmax(wide.high[d]), tail.high[d]);
      }
    block.motion_squared = std::max(stdx::hmax(wide.motion_squared), tail.motion_squared);
  }

  void CandidateSearch::watch_nodes(const FacetsView &facets, const Point3 &shift, const std::size_t part)
  {
    // x y z x y z ...: three registers hold whole nodes, and their lanes repeat the components
    const std::size_t begin = 3 * part * nodes_per_part, end = std::min(old_nodes.size(), begin + 3 * nodes_per_part);
    std::array<Lanes, 3>                        low, high, shifts;
    alignas(64) std::array<double, 3 * n_lanes> squares;
    Lanes                                       motion_squared(0.);
    for (std::size_t r = 0; r < 3; ++r)
      {
        low[r]    = Lanes(1e300);
        high[r]   = Lanes(-1e300);
        shifts[r] = Lanes([&](const auto j) { return shift[(r * n_lanes + j) % 3]; });
      }
    std::size_t e = begin;
    for (; e + 3 * n_lanes <= end; e += 3 * n_lanes)
      {
        for (std::size_t r = 0; r < 3; ++r)
          {
            double     *old = &old_nodes[e + r * n_lanes];
            const Lanes x   = load<Lanes>(facets.position + e + r * n_lanes);
            low[r]          = min(low[r], x);
            high[r]         = max(high[r], x);
            if (is_tracking)
              {
                const Lanes dx = x - load<Lanes>(old) - shifts[r];
                store(Lanes(dx * dx), &squares[r * n_lanes]);
                store(x, old);
              }
          }
        if (is_tracking)
          motion_squared =
            max(motion_squared,
                Lanes([&](const auto j) { return squares[3 * j] + squares[3 * j + 1] + squares[3 * j + 2]; }));
      }

    NodePart &seen = node_parts[part];
    seen           = {Box(), is_tracking ? stdx::hmax(motion_squared) : 0., false};
    for (std::size_t k = 0; k < 3 * n_lanes; ++k)
      {
        seen.box.low[k % 3]  = std::min(seen.box.low[k % 3], static_cast<double>(low[k / n_lanes][k % n_lanes]));
        seen.box.high[k % 3] = std::max(seen.box.high[k % 3], static_cast<double>(high[k / n_lanes][k % n_lanes]));
      }
    for (; e < end; e += 3)
      watch_node(facets, shift, e / 3, seen);
  }

  void CandidateSearch::watch_node(const FacetsView &facets, const Point3 &shift, const std::size_t n, NodePart &seen)
  {
    const Point3       x(facets.position + 3 * n);
    Eigen::Map<Point3> old(&old_nodes[3 * n]);
    seen.box.add(x.data());
    if (is_tracking)
      seen.motion_squared = std::max(seen.motion_squared, (x - old - shift).squaredNorm());
    old = x;
  }

  void CandidateSearch::watch_facet_nodes(const FacetsView &facets, const Point3 &shift, const std::size_t part)
  {
    NodePart &seen = node_parts[part];
    seen           = {Box(), 0., true};
    for (std::size_t n = part * nodes_per_part; n < std::min(facets.n_nodes, (part + 1) * nodes_per_part); ++n)
      if (is_loose[n] == 0)
        watch_node(facets, shift, n, seen);
      else
        std::copy_n(facets.position + 3 * n, 3, &old_nodes[3 * n]);
  }
} // namespace birdstrike
