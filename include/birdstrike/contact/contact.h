#pragma once

#include <birdstrike/contact/dissipation.h>
#include <birdstrike/contact/moving_patches.h>
#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/contact/node_sums.h>
#include <birdstrike/contact/parameters.h>
#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/report.h>
#include <birdstrike/contact/search.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/contact/touch_record.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/step_limit.h>
#include <birdstrike/core/thread_pool.h>

#include <vector>

namespace birdstrike
{
  struct ContactLaw;

  /// Penalty contact of points with facets: candidates (search.h), sides and depths (narrow_phase.h), forces (law.h),
  /// equal and opposite shares.
  ///
  /// *Stability.* With springs of tangents k_i on points of mass m_p and nodes of mass m_n, weights w_in, by Jensen's
  /// inequality and an optimal split of each spring between its two sides
  ///   omega^2 <= P + N,   P = max over points sum_i k_i/m_p,   N = max over nodes sum_i k_i w_in/m_n,
  /// whatever the masses. step_limit() keeps (P + 2 N) dt^2 below 2 of leapfrog's 4; the rest is for the parts' own
  /// forces and for the damper. P follows the liquid's own Courant number. N grows as the target gets lighter than a
  /// layer of points; there the modulus of a point that begins to touch is taken as that with which a full layer gives
  /// N dt^2 = Step stability share at the step with which points meet it, so that no foil, however thin, asks for
  /// shorter steps than the liquid. A free foil carries in proportion less pressure, so that depths stay small; under
  /// one that is held the spring hardens until it carries the shock 0.3 L deep (ContactLaw::hardening), and the step
  /// follows what that makes of its tangent.
  ///
  /// The force on a point acts along the line to its closest point on the facet, and the facet's nodes take the
  /// opposite force in the shares that make up that closest point: linear and angular momentum are kept to round-off.
  /// Friction acts at the point, one offset g away from the surface; the couple that this leaves is given to the nodes
  /// as forces of zero sum, so that it too keeps both.
  ///
  /// Results are bitwise the same for any number of threads: blocks of a fixed number of points write their own
  /// entries, nodes gather what the blocks hold for them in the order of the blocks. Work and impulse are booked by the
  /// parts, in the kicks by these forces; what springs hold and dampers take by contact itself. Facets may come and go
  /// between calls (FacetsView::revision): sides are kept, and what the new facets overlap carries no force at first.
  /// Nothing here moves a point or removes one. Throws InputError from the constructor for bad patches.
  ///
  /// Measured on one Zen 4 core in the frontal strike (1700 points on the list, 790 of them with a pair awake, 130 in
  /// touch): 27 million pairs listed in 2 ms, 5 million closest points computed; about 120 ns a listed point and step,
  /// a third of it the searches, of which half come from points being sorted and not from their motion.
  class Contact
  {
  public:
    explicit Contact(const ContactParameters &parameters);

    /// From here on pressure patches go with the surface. Throws InputError for one that lies beside it.
    void hold_patches(const FacetsView &facets);

    /// Where the forces go.
    struct Sink
    {
      PointForces points;
      NodeForces  nodes;
    };

    /// Adds forces to points and nodes (not to be called twice for one state: velocities and sides have a history).
    /// `step` is the step that the forces are kicked with; positions and velocities as after the drift.
    void add_forces(const PointsView &points, const FacetsView &facets, double step, const Sink &sink,
                    ThreadPool &pool);

    /// The same in two parts, for several contacts on one surface (each of its own points): dampers of all of them
    /// share the masses of the nodes that they touch, so that together they take and never make energy. First each
    /// finds its touches and adds what they weigh on the nodes to `weights` ([n_nodes]), then each adds its forces.
    void find(const PointsView &points, const FacetsView &facets, double step, ThreadPool &pool);
    void add_weights(std::vector<double> &weights) const;
    void act(const PointsView &points, const FacetsView &facets, double step, const Sink &sink, ThreadPool &pool,
             const std::vector<double> *weights = nullptr); ///< of all contacts; none: of this one

    /// What the springs of the last call can bear, s; infinite where nothing touches.
    StepLimit step_limit() const
    {
      return limit;
    }

    /// The longest step (s) in which nodes may take the impulses of several contact steps together: N of a full layer
    /// of undeformed points on the lightest facet, N dt^2 <= Step stability share. Infinite on rigid ground.
    double node_step_limit(const PointsView &points, const FacetsView &facets) const;

    /// What the next call depends on, besides the views, which must be those of the archived state: positions are
    /// those of the last call.
    void archive(Archive &archive, const PointsView &points, const FacetsView &facets);

    const ContactReport &report() const
    {
      return last;
    }

    /// The clock for peak_force_time: 0 at the first call of add_forces, then the sum of the steps given.
    void set_clock(double time);
    void begin_at(double time); ///< the first call comes after a step

  private:
    void       update_candidates(const PointsView &points, const FacetsView &facets, ThreadPool &pool);
    void       find_touches(const ContactScene &scene, ThreadPool &pool);
    void       note_depths(const PointsView &points);
    void       book_released(const ContactScene &scene);
    double     energy_of(const std::vector<ReleasedDepth> &depths, const ContactLaw &law) const; // J
    ContactLaw law(const ContactScene &scene) const;
    void choose_modulus(const PointsView &points, double step, const TouchRecord &touch, const CandidateBlock &block);
    void add_forces_of_touches(const ContactScene &scene, const Sink &sink, ThreadPool &pool,
                               const std::vector<double> *weights);
    ContactScene describe(const PointsView &points, const FacetsView &facets, double step) const;
    void         update_limit(const PointsView &points, const FacetsView &facets, const NodeSums::Largest &nodes);
    void         sum_report(const SymmetryPlane &plane);
    void         update_peaks(double spacing);
    void         size_touches(); ///< for the present lists
    void         archive_report(Archive &archive);

    static constexpr const char *step_limit_reason = "contact, stiffness of the touches";

    ContactParameters          parameters;
    std::vector<PressurePatch> patches; // as they are given
    MovingPatches              moving_patches;

    SurfaceTopology          topology;
    PointMemory              memory;
    CandidateSearch          search;
    NodeSums                 node_sums;
    std::vector<BlockReport> block_reports;
    std::vector<std::size_t> cost; // [blocks + 1], summed

    std::vector<std::vector<TouchRecord>> touches;           // [blocks]
    std::vector<double>                   depths_before;     // [points], m, where facets have come or gone
    AlignedVector<double>                 areal_flexibility; // [n_nodes], area over mass, m^2/kg; 0 where held
    Dissipation                           dissipation;
    StepLimit                             limit;

    ContactReport last;
    double        clock      = 0.; // s
    bool          is_first   = true;
    bool          is_changed = false; // facets have come or gone since the last call
  };
} // namespace birdstrike
