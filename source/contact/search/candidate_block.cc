#include <birdstrike/contact/candidate_block.h>
#include <birdstrike/core/number.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  void CandidateBlock::clear()
  {
    points.clear();
    has_passed.clear();
    pair_near.clear();
    pair_facet.clear();
    pair_bound.clear();
    facets.restart(0);
    nodes.restart(0);
    n_paired_facets = 0;
    facet_nodes.clear();
    path    = 0.;
    speed   = 0.;
    n_awake = 0;
    is_new  = true;
  }

  void CandidateBlock::number_surface(const FacetsView &surface, const std::vector<std::uint32_t> &beside)
  {
    facets.restart(n_pairs() + beside.size());
    for (std::uint32_t &facet : pair_facet)
      facet = facets.number(facet);
    n_paired_facets = facets.keys().size();
    for (const std::uint32_t facet : beside)
      facets.number(facet);
    nodes.restart(4 * facets.keys().size());
    for (const std::uint32_t facet : facets.keys())
      {
        auto &numbers = facet_nodes.emplace_back();
        for (unsigned int k = 0; k < 4; ++k)
          numbers[k] = nodes.number(surface.nodes[facet][k]);
      }
    while (pair_bound.size() % n_lanes != 0)
      pair_bound.push_back(1e300);
  }

  void CandidateBlock::find_speed(const PointsView &all_points, const FacetsView &surface)
  {
    const auto node_velocity = [&](const std::size_t node) {
      return Point3(Eigen::Map<const Point3>(surface.velocity + node * surface.velocity_stride));
    };
    const Point3 frame          = node_velocity(0);
    double       points_squared = 0., nodes_squared = 0.;
    for (const std::uint32_t i : points)
      points_squared =
        std::max(points_squared,
                 (Point3(all_points.velocity[0][i], all_points.velocity[1][i], all_points.velocity[2][i]) - frame)
                   .squaredNorm());
    for (const std::uint32_t node : nodes.keys())
      nodes_squared = std::max(nodes_squared, (node_velocity(node) - frame).squaredNorm());
    speed = std::sqrt(points_squared) + std::sqrt(nodes_squared);
  }
} // namespace birdstrike
