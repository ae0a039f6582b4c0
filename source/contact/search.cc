#include <birdstrike/contact/gather.h>
#include <birdstrike/contact/search.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t points_per_chunk = 512;

    /// max over points of |x - x_old - shift|, m.
    double points_motion(const PointsView &points, const std::array<AlignedVector<double>, 3> &old, const Point3 &shift,
                         ThreadPool &pool)
    {
      const auto largest = [&](const std::size_t begin, const std::size_t end) {
        Lanes      square(0.);
        double     tail   = 0.;
        const auto motion = [&]<class Number>(const Number &, const std::size_t i) {
          Number sum(0.);
          for (unsigned int d = 0; d < 3; ++d)
            {
              const Number dx =
                load<Number>(points.position[d] + i) - load<Number>(old[d].data() + i) - Number(shift[d]);
              sum += dx * dx;
            }
          return sum;
        };
        std::size_t i = begin;
        for (; i + n_lanes <= end; i += n_lanes)
          square = max(square, motion(Lanes(), i));
        for (; i < end; ++i)
          tail = max(tail, motion(double(), i));
        return std::max(stdx::hmax(square), tail);
      };
      return points.n == 0 ? 0. : std::sqrt(pool.ordered_max(points.n, largest));
    }

    double nodes_motion(const FacetsView &facets, const AlignedVector<double> &old, const Point3 &shift,
                        ThreadPool &pool)
    {
      const auto largest = [&](const std::size_t begin, const std::size_t end) {
        double square = 0.;
        for (std::size_t n = begin; n < end; ++n)
          {
            double sum = 0.;
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double dx = facets.position[3 * n + d] - old[3 * n + d] - shift[d];
                sum += dx * dx;
              }
            square = max(square, sum);
          }
        return square;
      };
      return std::sqrt(pool.ordered_max(facets.n_nodes, largest));
    }

    Box box_of(const PointsView &points)
    {
      Box box;
      for (unsigned int d = 0; d < 3; ++d)
        if (points.n > 0)
          {
            const auto [low, high] = std::minmax_element(points.position[d], points.position[d] + points.n);
            box.low[d]             = *low;
            box.high[d]            = *high;
          }
      return box;
    }
  } // namespace

  void CandidateSearch::forget()
  {
    allowed_motion = -1.;
  }

  void CandidateSearch::update(const PointsView &points, const FacetsView &facets, const double range,
                               const double margin, ThreadPool &pool)
  {
    if (is_valid(points, facets, pool))
      {
        ++(is_apart ? n_calls.apart : n_calls.reused);
        return;
      }
    points_revision = points.revision;
    facets_revision = facets.revision;
    for (unsigned int d = 0; d < 3; ++d)
      old_points[d].assign(points.position[d], points.position[d] + points.n);
    old_nodes.assign(facets.position, facets.position + 3 * facets.n_nodes);
    last_motion = 0.;

    Box surface;
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t node : facets.nodes[f])
        surface.add(facets.position + 3 * node);
    const double distance = points.n == 0 || facets.n_facets == 0 ? 1e300 : surface.separation(box_of(points));
    is_apart              = distance > range + margin;
    allowed_motion        = is_apart ? distance - range : margin;
    if (is_apart)
      {
        ++n_calls.apart;
        n_real_pairs = 0;
        first_pair_of_near.clear();
        return;
      }
    ++n_calls.searches;
    find_pairs(points, facets, range + margin, pool);
  }

  bool CandidateSearch::is_valid(const PointsView &points, const FacetsView &facets, ThreadPool &pool)
  {
    if (allowed_motion < 0. || points.revision != points_revision || facets.revision != facets_revision ||
        points.n != old_points[0].size() || 3 * facets.n_nodes != old_nodes.size())
      return false;
    if (points.n == 0 || facets.n_facets == 0)
      return true;
    const Point3 shift  = Eigen::Map<const Point3>(facets.position) - Eigen::Map<const Point3>(old_nodes.data());
    const double motion = points_motion(points, old_points, shift, pool) + nodes_motion(facets, old_nodes, shift, pool);
    const double reserve = std::max(motion - last_motion, 0.);
    last_motion          = motion;
    return motion + reserve <= allowed_motion;
  }

  void CandidateSearch::find_pairs(const PointsView &points, const FacetsView &facets, const double reach,
                                   ThreadPool &pool)
  {
    grid.update(facets, reach);
    chunks.resize((points.n + points_per_chunk - 1) / points_per_chunk);
    const auto collect = [&](Chunk &chunk, const std::size_t begin, const std::size_t end) {
      chunk.points.clear();
      chunk.facets.clear();
      for (std::size_t i = begin; i < end; ++i)
        {
          const Point3 p(points.position[0][i], points.position[1][i], points.position[2][i]);
          if (!grid.box().contains(p))
            continue;
          for (const std::uint32_t f : grid.near(p))
            if (grid.box(f).contains(p))
              {
                chunk.points.push_back(static_cast<std::uint32_t>(i));
                chunk.facets.push_back(f);
              }
        }
      keep_close(chunk, points, facets, reach);
    };
    pool.parallel_for(chunks.size(), 1, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        collect(chunks[c], c * points_per_chunk, std::min(points.n, (c + 1) * points_per_chunk));
    });
    join_chunks();
  }

  void CandidateSearch::keep_close(Chunk &chunk, const PointsView &points, const FacetsView &facets, const double reach)
  {
    const std::size_t n      = chunk.points.size();
    std::size_t       n_kept = 0;
    while (n > 0 && chunk.points.size() % n_lanes != 0)
      {
        chunk.points.push_back(chunk.points.back());
        chunk.facets.push_back(chunk.facets.back());
      }
    for (std::size_t b = 0; b < n; b += n_lanes)
      {
        const auto closest =
          compute_closest_point(gather_points(points, &chunk.points[b]), gather_facets(facets, &chunk.facets[b]));
        const auto is_close = closest.distance_squared <= Lanes(reach * reach);
        for (std::size_t j = 0; j < n_lanes && b + j < n; ++j)
          if (is_close[j])
            {
              chunk.points[n_kept] = chunk.points[b + j];
              chunk.facets[n_kept] = chunk.facets[b + j];
              ++n_kept;
            }
      }
    chunk.points.resize(n_kept);
    chunk.facets.resize(n_kept);
  }

  void CandidateSearch::join_chunks()
  {
    point_of_pair.clear();
    facet_of_pair.clear();
    first_pair_of_near.clear();
    for (const Chunk &chunk : chunks)
      {
        point_of_pair.insert(point_of_pair.end(), chunk.points.begin(), chunk.points.end());
        facet_of_pair.insert(facet_of_pair.end(), chunk.facets.begin(), chunk.facets.end());
      }
    n_real_pairs = point_of_pair.size();
    for (std::size_t k = 0; k < n_real_pairs; ++k)
      if (k == 0 || point_of_pair[k] != point_of_pair[k - 1])
        first_pair_of_near.push_back(static_cast<std::uint32_t>(k));
    first_pair_of_near.push_back(static_cast<std::uint32_t>(n_real_pairs));
    while (n_real_pairs > 0 && point_of_pair.size() % n_lanes != 0)
      {
        point_of_pair.push_back(point_of_pair.back());
        facet_of_pair.push_back(facet_of_pair.back());
      }
  }
} // namespace birdstrike
