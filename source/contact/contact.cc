#include "contact/areal_mass.h"
#include "contact/block_forces.h"
#include "contact/touch_records.h"
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t min_cost = 256; // points and tested pairs worth a second thread's wake-up, at 30 ns each

    /// Share of leapfrog's bound, omega dt <= 2, that (P + 2 N) dt^2 may take: the other half is for the parts' own
    /// forces and for dampers.
    constexpr double largest_squared_phase = 2.;

    /// Calls from one update of thickness and sharp edges to the next; when a search comes, which the axes have a part
    /// in, must not matter.
    constexpr std::uint64_t slow_stride = 16;

    /// Kept by each thread from call to call, so that it stays in that core's cache.
    struct Workspace
    {
      NarrowPhase narrow_phase;
      BlockForces forces;
    };

    Workspace &workspace()
    {
      static thread_local Workspace mine;
      return mine;
    }
  } // namespace

  Contact::Contact(const ContactParameters &parameters)
    : parameters(parameters), patches(parameters.pressure_patches()), moving_patches(patches)
  {
    last.patch_pressures.assign(patches.size(), 0.);
  }

  void Contact::hold_patches(const FacetsView &facets)
  {
    moving_patches.hold(facets);
  }

  void Contact::set_clock(const double time)
  {
    clock    = time;
    is_first = true;
  }

  void Contact::add_forces(const PointsView &points, const FacetsView &facets, const double step, const Sink &sink,
                           ThreadPool &pool)
  {
    find(points, facets, step, pool);
    act(points, facets, step, sink, pool);
  }

  ContactScene Contact::describe(const PointsView &points, const FacetsView &facets, const double step) const
  {
    const double range = topology.max_half_thickness() + 0.5 * memory.max_size();
    return {points, facets, topology, step, range, last.calls, last.calls == 1, is_changed, search.nodes_motion()};
  }

  void Contact::begin_at(const double time)
  {
    clock    = time;
    is_first = false;
  }

  void Contact::find(const PointsView &points, const FacetsView &facets, const double step, ThreadPool &pool)
  {
    clock += is_first ? 0. : step;
    ++last.calls;

    update_candidates(points, facets, pool);
    dissipation.book_past(points, facets, memory, step);
    limit                    = {};
    const ContactScene scene = describe(points, facets, step);
    if (is_changed)
      note_depths(points);
    if (search.n_near() > 0)
      find_touches(scene, pool);
    book_released(scene);
  }

  void Contact::add_weights(std::vector<double> &weights) const
  {
    if (search.n_near() > 0)
      node_sums.add_weights(weights);
  }

  void Contact::act(const PointsView &points, const FacetsView &facets, const double step, const Sink &sink,
                    ThreadPool &pool, const std::vector<double> *const weights)
  {
    if (search.n_near() > 0)
      add_forces_of_touches(describe(points, facets, step), sink, pool, weights);
    is_first = false;
    sum_report(points.plane);
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
    if (last.calls % slow_stride == 0 || change != SurfaceTopology::Change::none)
      topology.update_slowly(facets, memory.max_size());
    if (change != SurfaceTopology::Change::none)
      areal_flexibility = compute_areal_flexibility(facets, memory.max_size());
    search.update(points, facets, topology.max_half_thickness() + 0.5 * memory.max_size(),
                  parameters.search_margin * points.spacing, pool, &topology.sharp_edges());
    last.skipped = search.counts().apart;
    last.reused  = search.counts().reused;
    if (search.counts().searches > last.searches)
      {
        last.searches = search.counts().searches;
        node_sums.set_nodes(search.blocks(), facets.n_nodes);
        size_touches();
      }
    block_reports.resize(search.blocks().size());
    touches.resize(search.blocks().size());
    for (BlockReport &report : block_reports)
      report.clear(patches.size());
  }

  void Contact::size_touches()
  {
    touches.resize(search.blocks().size());
    // at most two facets a point, and where two faces meet the facets of both: steps without a search allocate nothing
    for (std::size_t b = 0; b < touches.size(); ++b)
      {
        CandidateBlock &block = search.blocks()[b];
        touches[b].reserve(4 * block.points.size());
        block.has_passed.reserve(block.points.size());
      }
  }

  void Contact::find_touches(const ContactScene &scene, ThreadPool &pool)
  {
    auto &blocks = search.blocks();
    cost.assign(1, 0);
    for (const CandidateBlock &block : blocks)
      cost.push_back(cost.back() + block.points.size() / 8 + block.n_awake);

    const ContactLaw constants = law(scene);
    const auto       find      = [&](const std::size_t begin, const std::size_t end) {
      NarrowPhase &narrow_phase = workspace().narrow_phase;
      for (std::size_t b = begin; b < end; ++b)
        {
          CandidateBlock &block = blocks[b];
          touches[b].clear();
          if (block.points.empty())
            continue;
          node_sums.clear(block);
          narrow_phase.update(scene, block, memory);
          block_reports[b].n_tested        = block.n_awake;
          block_reports[b].n_active        = narrow_phase.n_active();
          block_reports[b].released_energy = energy_of(narrow_phase.released(), constants);
          record_touches(narrow_phase, block, scene.points, scene.facets, parameters.friction > 0., touches[b]);
          double *weights = node_sums.mobility_of(block);
          for (const TouchRecord &touch : touches[b])
            {
              choose_modulus(scene.points, scene.step, touch, block);
              for (unsigned int k = 0; k < 4; ++k)
                weights[touch.nodes[k]] += touch.share * touch.loads[k];
            }
        }
    };
    pool.parallel_for_balanced(blocks.size(), cost.back() < min_cost ? blocks.size() : 1, cost.data(), std::ref(find));
  }

  ContactLaw Contact::law(const ContactScene &scene) const
  {
    return {parameters.stiffness_scale,
            parameters.damping_scale,
            parameters.friction,
            scene.points.hugoniot_slope,
            scene.step,
            scene.points.shock_pressure};
  }

  void Contact::choose_modulus(const PointsView &points, const double step, const TouchRecord &touch,
                               const CandidateBlock &block)
  {
    PointRecord &record = memory[points.id[touch.point]];
    if (record.last_touch + 1 < last.calls || record.modulus == 0.)
      {
        double flexibility = 0.; // 1/mu
        for (unsigned int k = 0; k < 4; ++k)
          flexibility += touch.weights[k] * areal_flexibility[block.nodes.keys()[touch.nodes[k]]];
        // N of a full layer of points is rho0 c0^2/(mu L)
        const double liquid  = record.density * record.sound_speed * record.sound_speed;
        const double longest = std::max(points.strike_step, step);
        const double bound   = parameters.stability_share * record.size / (longest * longest);
        record.modulus       = flexibility * parameters.stiffness_scale * liquid > bound
                                 ? bound / (flexibility * parameters.stiffness_scale)
                                 : liquid;
      }
    record.last_touch = last.calls;
  }

  void Contact::add_forces_of_touches(const ContactScene &scene, const Sink &sink, ThreadPool &pool,
                                      const std::vector<double> *const weights)
  {
    auto &blocks = search.blocks();
    cost.assign(1, 0);
    for (const auto &list : touches)
      cost.push_back(cost.back() + list.size());
    if (cost.back() == 0)
      return;
    node_sums.share_masses(scene.facets, pool, weights);

    const ContactLaw                  constants = law(scene);
    const std::vector<PressurePatch> &discs     = moving_patches.move(scene.facets);
    const auto                        add       = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        if (!touches[b].empty())
          workspace().forces.add(constants, memory,
                                                              {scene.points, scene.facets, sink.points, touches[b], discs, node_sums.of(blocks[b]),
                                  node_sums.mobility_of(blocks[b]), block_reports[b]});
    };
    pool.parallel_for_balanced(blocks.size(), cost.back() < min_cost ? blocks.size() : 1, cost.data(), std::ref(add));
    update_limit(scene.points, scene.facets, node_sums.add_to(sink.nodes, scene.facets, pool));
    for (const auto &list : touches)
      dissipation.add(scene.points, scene.facets, list, is_first ? 0. : scene.step);
  }

  void Contact::update_limit(const PointsView &points, const FacetsView &facets, const NodeSums::Largest &nodes)
  {
    BlockReport::LargestPoint most;
    for (const BlockReport &report : block_reports)
      if (exceeds(report.largest_point.value, most.value))
        most = report.largest_point;
    last.largest_frequency = std::sqrt(most.value + nodes.value);
    limit.value            = std::sqrt(largest_squared_phase / (most.value + 2. * nodes.value));
    limit.reason           = step_limit_reason;
    if (!exceeds(nodes.value, most.value))
      limit.where = {
        "particle",
        points.id[most.index],
        {{points.position[0][most.index], points.position[1][most.index], points.position[2][most.index]}}};
    else
      {
        const double *x = facets.position + 3 * nodes.node;
        limit.where     = {"node", nodes.node, {{x[0], x[1], x[2]}}};
      }
  }

  double Contact::node_step_limit(const PointsView &points, const FacetsView &facets) const
  {
    const double c0        = points.undeformed_sound_speed;
    const double stiffness = points.undeformed_density * c0 * c0 / points.spacing; // N of a full layer * its areal mass
    const AlignedVector<double> flexibility = compute_areal_flexibility(facets, points.spacing);
    const double                lightest    = *std::max_element(flexibility.begin(), flexibility.end());
    if (lightest == 0.)
      return std::numeric_limits<double>::infinity();
    const double of_layer = std::sqrt(parameters.stability_share / (parameters.stiffness_scale * stiffness * lightest));
    return std::max(of_layer, points.strike_step); // lighter facets meet a modulus chosen for that step
  }
} // namespace birdstrike
