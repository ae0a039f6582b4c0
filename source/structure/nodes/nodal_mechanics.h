#pragma once

#include "structure/nodes/loads.h"
#include "structure/nodes/node_arrays.h"
#include "structure/nodes/scaled_nodes.h"
#include "structure/nodes/supports.h"
#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/fields.h>
#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/structure/reports.h>
#include <birdstrike/structure/rotor.h>

#include <span>

namespace birdstrike
{
  class ShellElements;
  class SolidElements;

  /// The nodes of a blade of finite elements, and their equations of motion
  ///
  ///   m dv/dt = f_elements + f_loads + f_contact - alpha m v,   held unknowns: v = 0,
  ///
  /// in the verbs of velocity-Verlet (blade.h). Damping acts as the factor exp(-alpha dt/2) in every internal half kick
  /// (unconditionally stable); its work is booked as damped, its impulse as external. Held unknowns book the
  /// impulse and the moment about the origin that they take. Kinetic energy is that of v^n; the staggering of
  /// energy_report.h is
  ///   -|J|^2 / (2 m) at the half step of reference,  J the impulse of the last second half kicks,
  /// where the reference follows the step when it has changed by more than a thousandth: what the change does to the
  /// energy that the scheme conserves is booked then.
  ///
  /// Driven unknowns follow a formula u(t), or the rotation of the hub: with h the half step,
  ///   v^{n+1/2} = (u(t_n + 2h) - u^n)/(2h),    v^n = (u(t_n + h) - u(t_n - h))/(2h),
  /// so that displacements are exact at whole steps. Of every half kick the support gives the impulse m dv - h f, and
  /// the work m (v_after^2 - v_before^2)/2 - h f v^{n+-1/2}, f all forces on the unknown: the ledger closes to
  /// round-off.
  ///
  /// A node has n_unknowns: 3 displacements (solid), or 3 displacements and 3 rotations (shell). Vectors are deal.II's
  /// distributed ones on the Partitioner of the NodeSpace: owned entries, then those of ghosts, unknown c of node n at
  /// n_unknowns n + c, coordinate d at 3n + d. Forces kick what is owned, and sums are over what is owned; a ghost
  /// drifts with the velocity that its owner gives it.
  template <unsigned int n_unknowns>
  class NodalMechanics
  {
    static_assert(n_unknowns == 3 || n_unknowns == 6, "nodes of a solid or of a shell");

  public:
    using Mesh     = BladeMesh<n_unknowns == 6 ? 2 : 3>;
    using Elements = std::conditional_t<n_unknowns == 6, ShellElements, SolidElements>;

    struct Masses
    {
      std::vector<double> translation; ///< kg, [n_nodes]
      std::vector<double> rotation;    ///< kg m^2, [n_nodes]; empty for a solid
    };

    /// Where the rotor turns, all that is held follows it.
    NodalMechanics(const Mesh &mesh, const Masses &masses, const Supports &supports, Loads loads, const Rotor &rotor,
                   ThreadPool &pool);
    ~NodalMechanics();

    /// Velocities of formulas and of a rigid spin about the origin, held unknowns excepted. Throws InputError.
    void initialize_velocity(const BladeParameters::Loads &parameters);
    /// Watches the nodes nearest to the points of a list "name: x y z; ...", as far as they are owned. Throws
    /// InputError.
    void watch(const std::string &probes, const Mesh &mesh);
    /// From now on the nodes of a solid have the mass matrix of column_mass.h; `coupling` (kg) as there.
    void scale(const NodeColumns &columns, std::vector<double> coupling) requires(n_unknowns == 3);

    void       kick_internal(double half_step, HalfKick half);
    void       kick_contact(double half_step, HalfKick half);
    void       drift(double step);
    NodeForces clear_contact_forces(); ///< see Blade

    /// Takes the pressure off a quadrilateral, by its number in the loads' list.
    void stop_pressing(const std::size_t quadrilateral)
    {
      loads.stop_pressing(quadrilateral);
    }

    /// Forces of the elements for the increment since the last call, and of the loads at the present time.
    void compute_internal_forces(Elements &elements);
    /// Of the loads at the present time and positions, after somebody else has moved nodes and set element forces.
    void update_loads();

    void add_internal_forces(std::span<const NodalForce> forces); ///< see Blade
    /// Those of formulas at a time (s) and the present positions, to `force` [n_nodes][n_unknowns] (N, N m).
    void add_loads(const double at, double *force) const
    {
      if (loads.is_active())
        loads.add_forces(at, positions(), force);
    }
    bool has_pressure() const
    {
      return loads.has_pressure();
    }
    /// Everything turns with the hub from now on.
    void turn_with_hub();
    /// From now on in_turning_frame() and support_forces() are of these nodes, and of no others.
    void report_nodes(std::vector<std::uint32_t> nodes);
    /// N and N m, [n_nodes][n_unknowns]: on held unknowns the force on their support,
    ///   f_elements + f_loads + f_contact + f_others - m (a + alpha v),   a as the support moves,
    /// the rate of MomentumReport::support_impulse. At t = 0 a hub has a steady speed, and driven unknowns are at rest:
    /// the equilibrium of implicit/equilibrium.h.
    const double *support_forces() const;
    /// As somebody on the hub sees them: positions (m), displacements and support_forces(), of all nodes in their
    /// places.
    struct InTurningFrame
    {
      std::vector<double> position, displacement, force;
    };
    const InTurningFrame &in_turning_frame() const;
    double                present_time() const ///< s
    {
      return time;
    }

    void archive(Archive &archive);

    EnergyReport   energies() const; ///< kinetic, staggering, damped, works: nothing of the elements
    MomentumReport momenta() const;
    /// Of some nodes: kinetic energy (J), and the impulse of contact so far (N s).
    std::pair<double, std::array<double, 3>> kinetic_and_impulse(std::span<const std::uint32_t> nodes) const;
    std::array<double, 3>                    contact_force() const;
    std::vector<ProbeValues>                 probes() const;
    /// Displacement (m), velocity (m/s) and acceleration (m/s^2) of a node; the last of all forces, damping included,
    /// of driven components that of their formula.
    std::array<std::array<double, 3>, 3> motion_of(std::size_t node) const;
    NodeArrays                           arrays();
    FacetsView                           facets() const; ///< nodes only: the facets are the owner's
    void                                 add_fields(std::vector<Field> &fields) const;
    std::size_t                          bytes() const;

    const double *positions() const;      ///< m
    const double *displacements() const;  ///< m and rad
    const double *element_forces() const; ///< without what others have added
    const double *contact_forces() const;

  private:
    using Sums = std::array<double, 12>;
    double acceleration(std::size_t dof) const;
    /// Of the formulas and the hub that move a node; other components: 0.
    std::array<double, n_unknowns> driven_acceleration(std::size_t node) const;
    std::array<double, n_unknowns> support_force(std::size_t node) const;
    struct Vectors; ///< nodal_vectors.h: deal.II's headers stay with the sources that read entries

    void kick_loaded(double half_step, bool is_first);
    void book_damping_of_scaling(double half_step, bool is_first);
    void book_support(std::uint32_t dof, double impulse);
    void drive(double half_step, bool is_first); ///< after the other unknowns have been kicked
    /// One of them, from a displacement half a step before to one half a step after (a whole one, in first kicks).
    struct DrivenKick
    {
      double half_step, damped;
      bool   is_first;
    };
    void drive(const DrivenKick &kick, std::uint32_t dof, double from, double to);
    /// Of half kicks of this length (s) by internal and contact forces: kinetic energy of v^n, and |J|^2 / (2 m) (J).
    std::array<double, 2> kinetic(double half, double half_of_contact) const;
    void                  follow_step(double half_step);

    /// Calls body(begin, end) over ranges of the first n nodes.
    template <class Body>
    void for_nodes(std::size_t n, const Body &body);
    /// Sums of term(node, sums) over owned nodes in fixed chunks, bitwise the same for any number of threads.
    template <class Term>
    Sums sum_nodes(const Term &term) const;

    /// Sums of n quantities over the components of owned nodes: term(at, sums) adds what the Entries `at` contribute.
    /// Fixed chunks, bitwise the same for any number of threads.
    template <std::size_t n, class Term>
    std::array<std::array<double, n_unknowns>, n> sum_components(const Term &term) const;

    static constexpr std::size_t block = 24;                ///< entries of 4 nodes of a shell, 8 of a solid
    static constexpr std::size_t chunk = 3072 / n_unknowns; ///< nodes, whole blocks
    /// Chunks a thread takes at least: offering a range to one that is awake costs 1-2 us, a kick of some hundred
    /// nodes.
    static constexpr std::size_t grain = 2;

    ThreadPool                   &pool;
    Loads                         loads;
    std::vector<std::uint32_t>    held_dofs;
    std::vector<Supports::Driven> driven;
    Rotor                         rotor;
    std::vector<std::uint32_t>    hub_dofs;               ///< those that follow it, sorted
    double                        moment_of_inertia = 0.; ///< kg m^2, about the hub's axis at the start
    std::size_t                   n_nodes, n_owned;       ///< ghosts come last

    std::unique_ptr<Vectors>                           vectors;
    std::vector<std::pair<std::string, std::uint32_t>> watched;        ///< probes: name, node
    std::unique_ptr<ScaledNodes>                       scaled;         ///< none: masses are those of the nodes
    std::vector<NodalForce>                            added;          ///< to the forces, since they were computed
    mutable std::vector<double>                        of_elements;    ///< N, forces without them
    std::vector<std::uint32_t>                         reported_nodes; ///< their numbers
    mutable std::vector<double>                        on_support;     ///< support_forces()
    mutable InTurningFrame                             turned_back;

    double time           = 0.;                   ///< s
    double increment_time = 0.;                   ///< s since the last compute_internal_forces
    double internal_half = 0., contact_half = 0.; ///< s, of the last second half kicks; 0 after a first one
    double left_half      = 0.;                   ///< s, what contact_half was before the first half kick by contact
    double staggered_half = 0.;                   ///< s, the half step that the staggering refers to

    EnergyReport              booked; ///< staggering by changes of the step, damped, external_work, contact_work
    MomentumReport            impulses;
    mutable std::vector<Sums> partial;
  };
} // namespace birdstrike
