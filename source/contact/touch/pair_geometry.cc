#include <birdstrike/contact/pair_geometry.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/simd/compress.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double along_normal = 0.9; // cosine from which on a facet's own normal says on which side a point is
  }

  void PairGeometry::find_awake(const CandidateBlock &block, const double reach)
  {
    const double limit = reach + block.path;
    n_awake            = 0;
    pair.resize(std::max(pair.size(), block.pair_bound.size() + n_lanes));
    const auto lane = count_lanes<LaneNumbers<Lanes>>();
    for (std::size_t b = 0; b < block.pair_bound.size(); b += n_lanes)
      n_awake += compress_lanes(lane + static_cast<std::uint32_t>(b),
                                to_bits(load<Lanes>(&block.pair_bound[b]) < limit), &pair[n_awake]);
    for (std::size_t a = n_awake; a % n_lanes != 0; ++a)
      pair[a] = pair[n_awake - 1];
  }

  void PairGeometry::load_block_nodes(const FacetsView &facets, const SurfaceTopology &topology,
                                      const CandidateBlock &block)
  {
    const auto &keys = block.nodes.keys();
    nodes.resize(std::max(nodes.size(), keys.size()));
    for (std::size_t n = 0; n < keys.size(); ++n)
      {
        const double *x = facets.position + 3 * keys[n], *v = facets.velocity + facets.velocity_stride * keys[n];
        nodes[n].value = {
          x[0], x[1], x[2], v[0], v[1], v[2], facets.inverse_mass[keys[n]], topology.half_thickness(keys[n])};
      }
  }

  void PairGeometry::compute(const PointsView &points, const FacetsView &facets, const SurfaceTopology &topology,
                             CandidateBlock &block)
  {
    const std::size_t n_padded = (n_awake + n_lanes - 1) / n_lanes * n_lanes;
    // for all pairs of the block, awake or not: steps without a search allocate nothing
    const std::size_t n_most = block.pair_bound.size() + n_lanes;
    const auto        grow   = [&](AlignedVector<double> &array) { array.resize(std::max(array.size(), n_most)); };
    for (auto *array : {&distance, &height, &half_thickness})
      grow(*array);
    for (auto *arrays : {&offset, &velocity})
      for (auto &array : *arrays)
        grow(array);
    for (auto &array : weight)
      grow(array);

    load_block_nodes(facets, topology, block);
    for (std::size_t a = 0; a < n_padded; a += n_lanes)
      if (compute_batch(points, block, a))
        look_at_folds(block, a);
    for (std::size_t a = 0; a < n_awake; ++a)
      block.pair_bound[pair[a]] = distance[a] + block.path;
  }

  bool PairGeometry::compute_batch(const PointsView &points, const CandidateBlock &block, const std::size_t begin)
  {
    std::array<std::array<std::uint32_t, n_lanes>, 4> corner;
    std::array<std::uint32_t, n_lanes>                point;
    for (std::size_t j = 0; j < n_lanes; ++j)
      {
        const std::uint32_t k     = pair[begin + j];
        const auto         &facet = block.facet_nodes[block.pair_facet[k]];
        for (unsigned int c = 0; c < 4; ++c)
          corner[c][j] = facet[c];
        point[j] = block.points[block.pair_near[k]];
      }

    std::array<std::array<Lanes, 8>, 4> node;
    std::array<Vector3<Lanes>, 4>       x;
    for (unsigned int c = 0; c < 4; ++c)
      {
        node[c] = load_records(nodes.data(), corner[c].data());
        x[c]    = {node[c][0], node[c][1], node[c][2]};
      }
    const Vector3<Lanes> p(gather(points.position[0], point.data()), gather(points.position[1], point.data()),
                           gather(points.position[2], point.data()));
    const auto           q      = compute_closest_point(p, x);
    const Vector3<Lanes> normal = compute_area_vector(x);
    const Lanes          far = sqrt(q.distance_squared), above = q.offset.dot(normal) / sqrt(normal.dot(normal));
    store(far, &distance[begin]);
    store(above, &height[begin]);

    Lanes thickness(0.);
    for (unsigned int c = 0; c < 4; ++c)
      {
        thickness += q.weights[c] * node[c][7];
        store(q.weights[c], &weight[c][begin]);
      }
    store(thickness, &half_thickness[begin]);
    for (unsigned int d = 0; d < 3; ++d)
      {
        Lanes relative = gather(points.velocity[d], point.data());
        for (unsigned int c = 0; c < 4; ++c)
          relative -= q.weights[c] * node[c][3 + d];
        store(q.offset[d], &offset[d][begin]);
        store(relative, &velocity[d][begin]);
      }
    const Lanes least = min(min(q.weights[0], q.weights[1]), min(q.weights[2], q.weights[3]));
    return stdx::any_of(least > Lanes(0.) && abs(above) < Lanes(along_normal) * far);
  }

  void PairGeometry::look_at_folds(const CandidateBlock &block, const std::size_t begin)
  {
    for (std::size_t a = begin; a < std::min(begin + n_lanes, n_awake); ++a)
      {
        const auto   w = weights_of(a);
        const double m = std::min({w[0], w[1], w[2], w[3]});
        if (m == 0. || !(std::abs(height[a]) < along_normal * distance[a]))
          continue;
        const auto &corner = block.facet_nodes[block.pair_facet[pair[a]]];
        const auto  node   = [&](const unsigned int k) {
          const auto &x = nodes[corner[k % 4]].value;
          return Point3(x[0], x[1], x[2]);
        };
        const Point3 c = 0.25 * ((node(0) + node(1)) + (node(2) + node(3)));
        for (unsigned int k = 0; k < 4; ++k)
          if (w[k] > m && w[(k + 1) % 4] > m) // within one triangle
            height[a] = std::copysign(height[a], offset_of(a).dot((node(k) - c).cross(node(k + 1) - c)));
      }
  }
} // namespace birdstrike
