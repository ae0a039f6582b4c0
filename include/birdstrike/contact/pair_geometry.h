#pragma once

#include <birdstrike/contact/candidate_block.h>
#include <birdstrike/contact/node_records.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// How the awake pairs of one block lie at this moment: point p, closest point q of the facet.
  class PairGeometry
  {
  public:
    /// Finds the pairs that are awake: those that may be closer than `reach`.
    void find_awake(const CandidateBlock &block, double reach);

    /// Computes them, and when they next have to be looked at.
    void compute(const PointsView &points, const FacetsView &facets, const SurfaceTopology &topology,
                 CandidateBlock &block);

    std::size_t n() const
    {
      return n_awake;
    }

    std::vector<std::uint32_t>           pair;             ///< of the block, ascending; padded
    AlignedVector<double>                distance;         ///< |p - q|, m
    AlignedVector<double>                height;           ///< (p - q) . unit normal, m; sign: see look_at_folds
    AlignedVector<double>                half_thickness;   ///< at q, m
    std::array<AlignedVector<double>, 3> offset, velocity; ///< p - q, m; of p relative to q, m/s
    std::array<AlignedVector<double>, 4> weight;           ///< q = sum w_k x_k

    Point3 offset_of(const std::size_t a) const
    {
      return {offset[0][a], offset[1][a], offset[2][a]};
    }
    /// q, from the positions of the facet's nodes.
    Point3 closest_of(const FacetsView &facets, const std::array<std::uint32_t, 4> &corners, const std::size_t a) const
    {
      Point3 q = Point3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        q += weight[k][a] * Eigen::Map<const Point3>(facets.position + 3 * corners[k]);
      return q;
    }
    Point3 velocity_of(const std::size_t a) const
    {
      return {velocity[0][a], velocity[1][a], velocity[2][a]};
    }
    std::array<double, 4> weights_of(const std::size_t a) const
    {
      return {weight[0][a], weight[1][a], weight[2][a], weight[3][a]};
    }

  private:
    void load_block_nodes(const FacetsView &facets, const SurfaceTopology &topology, const CandidateBlock &block);
    /// Whether a point of the batch is over the inside of a facet that is bent there.
    bool compute_batch(const PointsView &points, const CandidateBlock &block, std::size_t begin);

    /// A facet that is warped so far that a triangle of its fan has turned over looks another way there than its mean
    /// normal does: over the inside of a triangle that one's own normal says on which side a point is.
    void look_at_folds(const CandidateBlock &block, std::size_t begin);

    std::size_t               n_awake = 0;
    AlignedVector<NodeRecord> nodes; // of the block, by its numbers
  };
} // namespace birdstrike
