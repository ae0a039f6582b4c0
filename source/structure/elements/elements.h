#pragma once

#include "structure/elements/element_group.h"
#include "structure/elements/stored_energy.h"
#include <birdstrike/core/archive.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/core/thread_pool.h>

#include <span>
#include <vector>

namespace birdstrike
{
  struct EnergyReport;
  struct SizeCensus;

  /// Which section each element has: all sections, and their numbers by element; none: all have the first.
  template <class Section>
  struct Sections
  {
    Sections(const Section &only) : all{only}
    {
    }
    Sections(std::vector<Section> all, std::vector<std::uint32_t> of_element, std::vector<bool> is_rigid = {},
             std::vector<std::int64_t> labels = {})
      : all(std::move(all)), of_element(std::move(of_element)), is_rigid(std::move(is_rigid)), labels(std::move(labels))
    {
    }

    const Section &of(const std::size_t element) const
    {
      return all[of_element.empty() ? 0 : of_element[element]];
    }

    std::vector<Section>       all;
    std::vector<std::uint32_t> of_element;
    std::vector<bool>          is_rigid; ///< by section; empty: none
    std::vector<std::int64_t>  labels;   ///< of elements, by which users know them; empty: their places
  };

  /// All elements of a blade, shells (ShellElements) or bricks (SolidElements): their strain increments, stresses,
  /// internal forces and energies; one group for each section. Those of a rigid section, all of whose nodes are held,
  /// have their mass, but neither force, energy nor vote, and are not computed.
  ///
  /// A step is three loops, each writing only what it owns, so that nothing depends on the number of threads: nodes
  /// (records), batches of elements (a row of force for every corner), nodes (sums over the corners, which lie side by
  /// side in the order of the mesh's elements whatever their group, and their work); block by block, see ElementBlocks.
  ///
  /// Where the metal can fail (material/failure.h), a point with D >= 1 carries nothing from then on, and an element
  /// whose stated share of points has failed, or which has collapsed, neither (erosion.h). Other metals pay nothing for
  /// it.
  ///
  /// Not here: mass of nodes, supports, loads, time. Throws InputError for a degenerate element or an impossible
  /// section, NumericalFailure when an element is turned inside out (unless Failure::smallest_step erodes it) or a
  /// force is not finite.
  template <class Group>
  class Elements
  {
  public:
    using Cell    = typename Group::Cell;
    using Section = typename Group::Section;

    static constexpr unsigned int n_unknowns = Group::n_unknowns;

    /// position [n_nodes][3] at t^{n+1} (m); increment [n_nodes][n_unknowns] of displacement (m) and rotation (rad)
    /// since the last call, which took dt (s); force, of the same shape, is overwritten with what the elements exert on
    /// the nodes, -f_int (N, N m).
    void compute_internal_forces(const double *position, const double *increment, double dt, double *force);
    /// The same, to be taken back by restore(): elements that fail are not taken out. False if there are such.
    bool try_internal_forces(const double *position, const double *increment, double dt, double *force);

    /// The largest dt for which central differences are stable: 2/omega_max by a bound on the largest eigenvalue of
    /// every element, for nodal masses and inertias that are not smaller than those of the functions below; of bricks
    /// shortened by the bulk viscosity. No safety factor.
    StepLimit step_limit() const;
    double    largest_stable_step() const; ///< s, the value of the same without its words: nothing is searched
    /// From now on energies, votes and reports are those of the elements and nodes that the process owns, but of all
    /// n_failed and is_failed: the others are computed for their forces on owned nodes.
    void set_owned(std::size_t n_nodes, const std::vector<bool> &elements);
    /// Masses (kg) that the nodes really carry, [n_nodes]: the bound then allows for other shares of the elements'.
    void use_nodal_masses(std::span<const double> mass);
    /// An equal part of each element's mass to each of its nodes (kg), [n_nodes].
    std::vector<double> compute_nodal_masses() const;

    /// All that compute_internal_forces changes, in memory: what it did is undone by setting the state of before. Not
    /// of elements that have failed meanwhile, see n_failed().
    struct Saved;
    std::shared_ptr<const Saved> save();
    void                         restore(const Saved &saved);
    /// While it is suspended no point flows, whatever its stress: the response is that of unloading. Afterwards the
    /// state of before is to be restored.
    void suspend_flow(bool is_suspended);

    /// All that the next step depends on, by section and element; `position` as of the last forces. What has been
    /// summed up over elements (dissipated energies, work) is booked with the first element of each sum: totals are the
    /// same in any build, and the sums to the last bit in this one.
    void archive(Archive &archive, const double *position);

    /// Energies (J). Stored ones are those of the present stresses (StoredEnergy): of the stress that elements are
    /// integrated with, and of the stabilisation of bricks, which with one layer is the energy of bending, no error.
    /// Plastic, viscous (bulk viscosity of bricks) and hourglass (all work on the stabilisation of shells, stored or
    /// taken by its limits): cumulative, by their own rates; what the stabilisation of bricks dissipates is plastic
    /// work. `work` is that of the nodal forces, trapezoidal in time: what it differs from the sum of the others (and
    /// the eroded energy) is an error.
    StoredEnergy::Sums stored_energy() const;
    double             plastic_work() const;
    double             viscous_energy() const;
    double             work() const;
    /// What elements and points stored when they failed, less what forces have not paid for in that step; it has left
    /// the others. An element that has not paid for all of its last flow takes it off the plastic work.
    double eroded_energy() const;
    void   add_energies(EnergyReport &report) const;                         ///< all of these
    void   add_energies_of(std::size_t section, EnergyReport &report) const; ///< but for the work, of one section

    /// Failed elements carry nothing and have no vote on the step; their nodes keep their masses. Once failed, always.
    bool        can_fail() const;
    std::size_t n_failed() const;
    std::size_t n_collapsed() const; ///< of these, those taken away by Failure::smallest_step
    bool        is_failed(std::size_t element) const;
    double      failed_mass() const;               ///< kg
    bool        is_free(std::size_t node) const;   ///< all its elements have failed
    double      damage(std::size_t element) const; ///< largest D of its points; 1 and more: such a point failed
    std::size_t n_failed_points(std::size_t element) const;
    /// Of a section whose metal has size factors: its elements but for rigid ones. Otherwise adds nothing.
    void add_sizes(std::size_t section, SizeCensus &sizes) const;

    std::size_t   n_elements() const;
    ElementPrices prices() const;
    std::size_t   n_promoted() const; ///< elements that hold points through the thickness (bricks: or need none)
    std::size_t   bytes() const;      ///< counted, of all that these elements hold

    struct MaxPlasticStrain
    {
      double      value   = 0.;
      std::size_t element = 0;
    };
    std::vector<MaxPlasticStrain> max_plastic_strains() const; // by section

    std::size_t    n_sections() const;
    const Section &section(std::size_t element) const;
    /// Of one section: number of elements, their mass (kg) and plastic work (J).
    struct SectionSums
    {
      std::size_t n_elements;
      double      mass, plastic_work;
    };
    SectionSums section_sums(std::size_t section) const;

  protected:
    using Extra = typename Group::Extra; ///< what an element's group must know of it besides its nodes

    /// Positions (m), nodes of the elements, what else is to be known of each, sections. The pool must outlive this.
    Elements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells, const std::vector<Extra> &extra,
             const Sections<Section> &sections, ThreadPool &pool);

    /// Throws InputError unless there are cells, of nodes that are there.
    static const std::vector<Cell> &checked(const std::vector<Cell> &cells, std::size_t n_nodes);

    /// The group of an element, and its number there.
    std::pair<const Group &, std::size_t> find(std::size_t element) const
    {
      return {groups[place[element].group], place[element].number};
    }

    double sum(Lanes ElementChunk::*energy) const; ///< J
    template <class Part>
    double sum_erosion(const Part &part) const; ///< J, of part(energy of a batch)
    template <class Part>
    double sum_erosion(const Group &group, const Part &part) const;

    std::vector<Group> groups;

  private:
    struct Place
    {
      std::uint32_t group, number;
    };
    struct Chunk
    {
      std::uint32_t group, number;
    };
    using Row = typename Group::ForceOnCorner;

    void gather_forces(const ElementBlocks::Block &block, double *force);
    void erode(); ///< after all forces: takes out the elements that have failed
    void archive_failed(Archive &archive, Group &group);
    void archive_elements(Archive &archive, Group &group);
    void set_inverse_masses(std::span<const double> nodal_masses); ///< those of the nodes, none: equal parts
    std::vector<std::uint32_t> order(const Sections<Section> &sections, std::size_t n_elements);

    ThreadPool                &pool;
    std::size_t                n_nodes, n_owned_nodes;
    std::vector<Place>         place;  ///< [n_elements]
    std::vector<Chunk>         chunks; ///< of all groups, one after the other
    ElementBlocks              blocks;
    AlignedVector<Row>         corner_force; ///< a node's together; the last, one a group, take what copies write
    AlignedVector<Row>         node_force;   ///< [n_nodes], of the last step
    AlignedVector<Row>         node_work;    ///< [chunks of nodes], J by component, cumulative
    std::vector<std::uint32_t> n_left;       ///< [n_nodes], elements that have not failed; none where none can
    std::vector<bool>          is_rigid;     ///< by group

  protected:
    typename Group::Nodes nodes;
  };
} // namespace birdstrike
