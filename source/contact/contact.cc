#include <birdstrike/contact/block_forces.h>
#include <birdstrike/contact/contact.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t min_cost = 256; // points and tested pairs worth a second thread's wake-up, at 30 ns each

    /// Kept by each thread from call to call, so that it stays in that core's cache.
    struct Workspace
    {
      NarrowPhase narrow_phase;
      BlockForces forces;
    };
  } // namespace

  Contact::Contact(const ContactParameters &parameters) : parameters(parameters), patches(parameters.pressure_patches())
  {
    last.patch_pressures.assign(patches.size(), 0.);
  }

  void Contact::set_clock(const double time)
  {
    clock    = time;
    is_first = true;
  }

  void Contact::add_forces(const PointsView &points, const FacetsView &facets, const double step, ThreadPool &pool)
  {
    if (!parameters.is_enabled)
      return;
    clock += is_first ? 0. : step;
    is_first = false;
    ++last.calls;

    update_candidates(points, facets, pool);
    if (search.n_near() > 0)
      {
        const double range = topology.max_half_thickness() + 0.5 * memory.max_size();
        add_block_forces({points, facets, topology, step, range, last.calls, last.calls == 1, is_changed}, pool);
        node_sums.add_to(facets, pool);
      }
    sum_report();
    update_peaks(points.spacing);
  }

  void Contact::update_candidates(const PointsView &points, const FacetsView &facets, ThreadPool &pool)
  {
    const auto change = topology.update(facets);
    is_changed        = change != SurfaceTopology::Change::none && last.calls > 1;
    if (is_changed)
      search.forget();
    if (is_changed && change == SurfaceTopology::Change::surface)
      memory.forget_sides();
    memory.update(points);
    search.update(points, facets, topology.max_half_thickness() + 0.5 * memory.max_size(),
                  parameters.search_margin * points.spacing, pool);
    last.skipped = search.counts().apart;
    last.reused  = search.counts().reused;
    if (search.counts().searches > last.searches)
      {
        last.searches = search.counts().searches;
        topology.update_thickness(facets); // it changes slowly
        node_sums.set_nodes(search.blocks(), facets.n_nodes);
      }
    block_reports.resize(search.blocks().size());
    for (BlockReport &report : block_reports)
      report.clear(patches.size());
  }

  void Contact::add_block_forces(const ContactScene &scene, ThreadPool &pool)
  {
    const ContactLaw law{parameters.stiffness_scale, parameters.damping_scale,    parameters.stability_share,
                         parameters.friction,        scene.points.hugoniot_slope, scene.step};
    auto            &blocks = search.blocks();
    cost.assign(1, 0);
    for (const CandidateBlock &block : blocks)
      cost.push_back(cost.back() + block.points.size() / 8 + block.n_awake);

    const auto add = [&](const std::size_t begin, const std::size_t end) {
      static thread_local Workspace workspace;
      for (std::size_t b = begin; b < end; ++b)
        {
          CandidateBlock &block = blocks[b];
          if (block.points.empty())
            continue;
          NodeSums::Force *sums = node_sums.of(block);
          std::fill(sums, sums + block.nodes.keys().size(), NodeSums::Force{});
          workspace.narrow_phase.update(scene, block, memory);
          block_reports[b].n_tested = block.n_awake;
          block_reports[b].n_active = workspace.narrow_phase.n_active();
          if (!workspace.narrow_phase.touches().empty())
            workspace.forces.add(law, workspace.narrow_phase, memory, {scene, block, patches, sums, block_reports[b]});
        }
    };
    pool.parallel_for_balanced(blocks.size(), cost.back() < min_cost ? blocks.size() : 1, cost.data(), std::ref(add));
  }

  void Contact::sum_report()
  {
    last.force         = {};
    last.stored_energy = last.dissipation_power = last.penetration = 0.;
    last.n_touching                                                = 0;
    std::fill(last.patch_pressures.begin(), last.patch_pressures.end(), 0.);
    for (const BlockReport &block : block_reports)
      {
        for (unsigned int d = 0; d < 3; ++d)
          last.force[d] += block.force[d];
        last.stored_energy += block.stored_energy;
        last.dissipation_power += block.dissipation_power;
        last.penetration = std::max(last.penetration, block.penetration);
        last.n_touching += block.n_touching;
        last.pairs_tested += block.n_tested;
        last.points_active += block.n_active;
        for (std::size_t k = 0; k < patches.size(); ++k)
          last.patch_pressures[k] += block.patch_pressures[k];
      }
    last.touches += last.n_touching;
    last.points_near += search.n_near();
    last.pairs_listed += search.n_pairs();
  }

  void Contact::update_peaks(const double spacing)
  {
    const double norm = Point3(last.force[0], last.force[1], last.force[2]).norm();
    if (norm > last.peak_force)
      {
        last.peak_force      = norm;
        last.peak_force_time = clock;
      }
    last.max_penetration              = std::max(last.max_penetration, last.penetration);
    last.max_penetration_over_spacing = spacing > 0. ? last.max_penetration / spacing : 0.;
  }
} // namespace birdstrike
