#pragma once

#include "registers.h"

#include <birdstrike/blade/loads.h>
#include <birdstrike/blade/sections.h>
#include <birdstrike/blade/shell_blade.h>
#include <birdstrike/blade/shell_elements.h>
#include <birdstrike/blade/shell_mesh.h>
#include <birdstrike/blade/supports.h>
#include <birdstrike/core/aligned_vector.h>

#include <functional>

namespace birdstrike
{
  /// Everything a ShellBlade owns. Node-major arrays: unknown c of node n at 6n + c, coordinate d at 3n + d. Those of
  /// six numbers a node are padded with zeros to blocks of four nodes, which loops take in three registers of eight.
  struct ShellBlade::State
  {
    using Sums = std::array<double, 12>;

    State(const BladeParameters &parameters, ThreadPool &pool);

    void initialize_nodes();
    void initialize_velocity(const BladeParameters::Loads &parameters);
    void initialize_facets();
    void update_loads();

    /// Calls body(begin, end) over ranges of nodes. Passed by reference: std::function then allocates nothing.
    template <class Body>
    void for_nodes(const Body &body)
    {
      pool.parallel_for(n_nodes, grain * chunk, std::cref(body));
    }

    /// Sums of term(node, sums) over all nodes in fixed chunks, bitwise the same for any number of threads.
    template <class Term>
    Sums sum_nodes(const Term &term) const
    {
      const auto body = [&](const std::size_t begin, const std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
          {
            Sums sums{};
            for (std::size_t n = c * chunk; n < std::min(n_nodes, (c + 1) * chunk); ++n)
              term(n, sums);
            partial[c] = sums;
          }
      };
      pool.parallel_for(partial.size(), grain, std::cref(body));
      Sums total{};
      for (const Sums &sums : partial)
        for (std::size_t k = 0; k < total.size(); ++k)
          total[k] += sums[k];
      return total;
    }

    /// Sums of n quantities over the six components of all nodes: term(i, sums) adds what entries [i, i + 8) of the
    /// node-major arrays contribute. Fixed chunks, bitwise the same for any number of threads.
    template <std::size_t n, class Term>
    std::array<std::array<double, 6>, n> sum_components(const Term &term) const
    {
      const auto body = [&](const std::size_t begin, const std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
          {
            Eight sums[3][n] = {};
            for (std::size_t i = 6 * c * chunk; i < std::min(n_padded, 6 * (c + 1) * chunk); i += block)
              for (std::size_t k = 0; k < 3; ++k)
                term(i + 8 * k, sums[k]);
            for (std::size_t q = 0; q < n; ++q)
              for (std::size_t i = 0; i < 6; ++i)
                {
                  const auto at         = [&](const std::size_t j) { return sums[j / 8][q][j % 8]; };
                  partial[c][6 * q + i] = at(i) + at(6 + i) + at(12 + i) + at(18 + i);
                }
          }
      };
      pool.parallel_for(partial.size(), grain, std::cref(body));
      std::array<std::array<double, 6>, n> total{};
      for (const Sums &sums : partial)
        for (std::size_t q = 0; q < n; ++q)
          for (std::size_t i = 0; i < 6; ++i)
            total[q][i] += sums[6 * q + i];
      return total;
    }

    static constexpr std::size_t chunk = 512; ///< nodes
    static constexpr std::size_t block = 24;  ///< entries of four nodes
    /// Chunks a thread takes at least: offering a range to one that is awake costs 1-2 us, as a kick of some hundred
    /// nodes.
    static constexpr std::size_t grain = 2;

    ThreadPool     &pool;
    ShellMesh       mesh;
    Supports        supports;
    Loads           loads;
    ShellMesh::Mass lumped;
    ShellElements   elements;
    RootSection     root;
    TipRow          tip;
    std::size_t     n_nodes;
    double          damping;

    std::size_t                                        n_padded;                            ///< entries
    AlignedVector<double>                              displacement, velocity, force, mass; ///< [n_padded]
    AlignedVector<double>                              inverse_mass, increment, contact, external;
    AlignedVector<double>                              reference, position; ///< [3 n_nodes]
    std::vector<double>                                node_inverse_mass, half_thickness;
    std::vector<std::pair<std::string, std::uint32_t>> watched; ///< probes: name, node

    double time           = 0.;                   ///< s
    double increment_time = 0.;                   ///< s since the last compute_internal_forces
    double internal_half = 0., contact_half = 0.; ///< s, of the last second half kicks; 0 after a first one

    EnergyReport              booked; ///< dissipated, external_work, contact_work
    MomentumReport            impulses;
    mutable std::vector<Sums> partial;
  };
} // namespace birdstrike
