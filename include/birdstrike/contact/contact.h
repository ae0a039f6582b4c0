#pragma once

#include <birdstrike/contact/narrow_phase.h>
#include <birdstrike/contact/parameters.h>
#include <birdstrike/contact/point_memory.h>
#include <birdstrike/contact/report.h>
#include <birdstrike/contact/search.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// Penalty contact of points with facets: candidates (search.h), sides and depths (narrow_phase.h), forces (law.h),
  /// equal and opposite shares.
  ///
  /// The force on a point acts along the line to its closest point on the facet, and the facet's nodes take the
  /// opposite force in the shares that make up that closest point: linear and angular momentum are kept to round-off.
  /// Friction acts at the point, one offset g away from the surface; the couple that this leaves is given to the nodes
  /// as forces of zero sum, so that it too keeps both.
  ///
  /// Results are bitwise the same for any number of threads: pairs write their own entries, sums go in the order of the
  /// list. Work and impulse are booked by the parts, in the kicks by these forces. Nothing here limits the step, moves
  /// a point or removes one. Throws InputError from the constructor for bad patches.
  class Contact
  {
  public:
    explicit Contact(const ContactParameters &parameters);

    /// Adds forces to points and nodes (not to be called twice for one state: velocities and sides have a history).
    /// `step` is the step that the forces are kicked with; positions and velocities as after the drift.
    void add_forces(const PointsView &points, const FacetsView &facets, double step, ThreadPool &pool);

    const ContactReport &report() const
    {
      return last;
    }

    /// The clock for peak_force_time: 0 at the first call of add_forces, then the sum of the steps given.
    void set_clock(double time);

  private:
    struct Batch;
    void update_touches(const PointsView &points, const FacetsView &facets, double step, ThreadPool &pool);
    void compute_forces(const PointsView &points, const FacetsView &facets, double step, ThreadPool &pool);
    void compute_batch(const PointsView &points, const FacetsView &facets, double step, std::size_t begin);
    void scatter(const PointsView &points, const FacetsView &facets);
    void add_couple(const FacetsView &facets, std::size_t touch, const Point3 &force);
    void add_to_patches(const PointsView &points, std::size_t touch);
    void update_peaks(double spacing);

    ContactParameters          parameters;
    std::vector<PressurePatch> patches;

    SurfaceTopology topology;
    PointMemory     memory;
    CandidateSearch search;
    NarrowPhase     narrow_phase;

    std::array<AlignedVector<double>, 3> forces; // [touch], N, on the point
    AlignedVector<double>                stored, dissipated;

    ContactReport last;
    double        clock    = 0.; // s
    bool          is_first = true;
  };
} // namespace birdstrike
