#pragma once

#include <birdstrike/contact/self_search.h>
#include <birdstrike/contact/self_touch.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What self-contact did in its last call, and over all calls: of the whole, work excepted.
  struct SelfContactReport
  {
    double        stored_energy     = 0.; ///< J, sum of k d^2 / 2
    double        dissipated_energy = 0.; ///< J, over all calls: by dampers, and of springs that were softened or lost
    std::size_t   n_touching        = 0;  ///< pairs of node and facet
    double        max_penetration   = 0.; ///< m, over all calls
    std::uint64_t calls             = 0;
    std::uint64_t looks             = 0; ///< calls in which boxes were compared
    std::uint64_t pairs_tested      = 0; ///< closest points computed, over all calls
    std::uint64_t touches           = 0; ///< sum over calls of n_touching
  };

  /// Contact of a deformable surface with itself: its nodes against its facets, without friction.
  ///
  /// A touch (self_touch.h) of depth d and closing speed u pushes with
  ///
  ///   F = max(0, k d + c u),   c = 2 zeta sqrt(k m_s),   zeta = 0.1,
  ///
  /// a spring whose k is constant during a touch and a damper that only takes: with the spring it never turns u within
  /// a step, c u <= m_s u/dt - k d. The node gets F along p - q, the facet's nodes the opposite force by the weights of
  /// q: linear and angular momentum are kept to round-off.
  ///
  /// All touches of a node share its mass ("mass splitting", Tonge, Benevolenski and Voroshilov, ACM Trans. Graph. 31
  /// (4), 2012, section 4). With g_k the weight of a touch at node k (1 at the point) and S_k the sum of the weights of
  /// all touches there, a touch sees the mass 1/m_s = sum_k g_k S_k / m_k, and by Gershgorin's theorem on the rows of
  /// K G M^-1 G^T the touches together have no frequency above max sqrt(k/m_s). k = 0.4 m_s/dt^2 at first touch, and
  /// it is lowered where later touches or a longer step would bring k dt^2/m_s above 0.6 (what the spring then loses is
  /// booked as dissipated). The elements at nine tenths of their stable step leave 4 - 3.24 = 0.76: the step stays
  /// stable, and this part needs no vote.
  ///
  /// Energies: `stored_energy` is the springs'. `dissipated_energy` is the dampers' work by their own forces and the
  /// velocities of the adjoining drifts, as kicks book works (core/energy_report.h), and what springs take or keep in
  /// the steps in which they set in and end: there velocity-Verlet is off by up to k (u dt)^2/8, where two equal sheets
  /// meet a tenth of the energy of their approach. A spring that is about to end gives no more than it has.
  ///
  /// A touch goes as deep as d = u dt (m/2k dt^2)^(1/2), 2.2 steps' flight for equal nodes: sheets thinner than that
  /// are passed by nodes for some steps and push them back.
  ///
  /// Not here: edges of one sheet against edges of another (two corners that meet edge on can cross until their nodes
  /// reach a facet), friction, contact across a plane of symmetry.
  class SelfContact
  {
  public:
    static constexpr double default_damping_ratio = 0.1; ///< zeta

    explicit SelfContact(double damping_ratio = default_damping_ratio);

    /// Finds the forces at the present positions; velocities as after the drift. `step` (s) is the one that the forces
    /// are kicked with. Not to be called twice for one state.
    void update(const FacetsView &facets, double step);

    /// N, one entry for each node that is touched: their sum is zero.
    const std::vector<NodalForce> &forces() const
    {
      return nodal_forces;
    }

    /// What the next call depends on, besides the view, which must be that of the archived state.
    void archive(Archive &archive, const FacetsView &facets);

    SelfContactReport report() const;

  private:
    void   book_second_halves(const FacetsView &facets, double step);
    void   reserve(const FacetsView &facets);
    void   share_masses(const FacetsView &facets);
    double inverse_mass(const FacetsView &facets, const SelfTouch &touch, double least_sum) const;
    void   add_force(const FacetsView &facets, SelfTouch &touch, double step);
    void   add_to_node(std::uint32_t node, const Point3 &force);

    double                                    damping_ratio;
    SurfaceTopology                           topology;
    SelfSearch                                search;
    SelfTouches                               narrow;
    std::vector<SelfTouch>                    before; // touches of the last call
    std::vector<std::array<std::uint32_t, 2>> touched;
    std::vector<double>                       weight_sums; // [n_nodes], S_k
    std::vector<std::uint32_t>                place;       // [n_nodes], in nodal_forces + 1; 0: none
    std::vector<NodalForce>                   nodal_forces;
    SelfContactReport                         last; // of what is computed
    SymmetryPlane                             plane;
  };
} // namespace birdstrike
