#include <birdstrike/contact/node_sums.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>
#include <functional>

namespace birdstrike
{
  namespace
  {
    constexpr std::uint32_t absent = 0xffffffffu;
    constexpr std::size_t   grain  = 512; // nodes that are worth a second thread, at 5 ns each
  }                                       // namespace

  void NodeSums::set_nodes(const std::vector<CandidateBlock> &blocks, const std::size_t n_nodes)
  {
    place.assign(n_nodes, absent);
    nodes.clear();
    first.assign(1, 0);
    for (const CandidateBlock &block : blocks)
      for (const std::uint32_t node : block.nodes.keys())
        {
          if (place[node] == absent)
            {
              place[node] = static_cast<std::uint32_t>(nodes.size());
              nodes.push_back(node);
              first.push_back(0);
            }
          ++first[place[node] + 1];
        }
    for (std::size_t n = 1; n < first.size(); ++n)
      first[n] += first[n - 1];
    sums.assign(first.back(), Sum{});
    mobilities.assign(first.back(), 0.);
    entries.resize(first.back());
    std::uint32_t entry = 0;
    for (const CandidateBlock &block : blocks)
      for (const std::uint32_t node : block.nodes.keys())
        entries[first[place[node]]++] = entry++;
    for (std::size_t n = nodes.size(); n > 0; --n)
      first[n] = first[n - 1];
    first[0] = 0;
  }

  void NodeSums::clear(const CandidateBlock &block)
  {
    const std::size_t end = block.first_node + block.nodes.keys().size();
    std::fill(sums.begin() + block.first_node, sums.begin() + end, Sum{});
    std::fill(mobilities.begin() + block.first_node, mobilities.begin() + end, 0.);
  }

  double NodeSums::sum_weights(const std::size_t n) const
  {
    double total = 0.;
    for (std::uint32_t e = first[n]; e < first[n + 1]; ++e)
      total += mobilities[entries[e]];
    return total;
  }

  void NodeSums::add_weights(std::vector<double> &weights) const
  {
    for (std::size_t n = 0; n < nodes.size(); ++n)
      weights[nodes[n]] += sum_weights(n);
  }

  void NodeSums::share_masses(const FacetsView &facets, ThreadPool &pool, const std::vector<double> *const weights)
  {
    const auto share = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        {
          const double total = weights ? (*weights)[nodes[n]] : sum_weights(n);
          for (std::uint32_t e = first[n]; e < first[n + 1]; ++e)
            mobilities[entries[e]] = total * facets.inverse_mass[nodes[n]];
        }
    };
    pool.parallel_for(nodes.size(), grain, std::ref(share));
  }

  NodeSums::Largest NodeSums::add_to(const NodeForces &forces, const FacetsView &facets, ThreadPool &pool) const
  {
    largest.assign((nodes.size() + grain - 1) / grain, Largest{});
    const auto add = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin * grain; n < std::min(nodes.size(), end * grain); ++n)
        {
          Sum total{};
          for (std::uint32_t e = first[n]; e < first[n + 1]; ++e)
            for (unsigned int d = 0; d < 4; ++d)
              total[d] += sums[entries[e]][d];
          for (unsigned int d = 0; d < 3; ++d)
            forces.of(nodes[n])[d] += total[d];
          Largest &most = largest[n / grain];
          if (const double value = total[3] * facets.inverse_mass[nodes[n]]; exceeds(value, most.value))
            most = {value, nodes[n]};
        }
    };
    pool.parallel_for(largest.size(), 1, std::ref(add));
    Largest most;
    for (const Largest &of_chunk : largest)
      if (exceeds(of_chunk.value, most.value))
        most = of_chunk;
    return most;
  }
} // namespace birdstrike
