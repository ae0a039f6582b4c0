#pragma once

#include <birdstrike/blade/loads.h>
#include <birdstrike/blade/sections.h>
#include <birdstrike/blade/shell_blade.h>
#include <birdstrike/blade/shell_elements.h>
#include <birdstrike/blade/shell_mesh.h>
#include <birdstrike/blade/supports.h>
#include <birdstrike/core/aligned_vector.h>

#include <deal.II/lac/vector.h>

#include <functional>

namespace birdstrike
{
  /// Everything a ShellBlade owns. Node-major arrays: unknown c of node n at 6n + c, coordinate d at 3n + d.
  struct ShellBlade::State
  {
    using Sums = std::array<double, 8>;

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

    static constexpr std::size_t chunk = 512; ///< nodes
    /// Chunks a thread takes at least: waking one costs as much as a kick of some thousand nodes.
    static constexpr std::size_t grain = 8;

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

    dealii::Vector<double>                             displacement, velocity, force, mass;        ///< [6 n_nodes]
    AlignedVector<double>                              inverse_mass, increment, contact, external; ///< [6 n_nodes]
    AlignedVector<double>                              reference, position;                        ///< [3 n_nodes]
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
