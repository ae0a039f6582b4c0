#pragma once

#include "structure/elements/element_blocks.h"
#include "structure/elements/solid/erosion.h"
#include "structure/elements/solid/solid_shell.h"
#include "structure/elements/solid/step_bound.h"
#include "structure/elements/stored_energy.h"
#include <birdstrike/core/simd/records.h>

namespace birdstrike
{
  /// Data and loops behind SolidElements. Elements lie in batches of n_lanes consecutive ones (the last batch is filled
  /// up with copies of the last element, whose forces and energies are never read).
  ///
  /// A step is three loops, each writing only what it owns, so that nothing depends on the number of threads: nodes
  /// (records), batches (half a row of force for every corner), nodes (sums over the corners, which lie side by side in
  /// a fixed order, and their work); block by block of some thousand elements, see ElementBlocks.
  class SolidElements::Implementation
  {
  public:
    Implementation(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 8>> cells,
                   const SolidSection &section, ThreadPool &pool);

    /// Position at t^{n+1} (m), increment (m), two unused: what a batch needs of a node, one cache line.
    using NodeRecord = Row;
    /// Force (N) on a corner or a node; the fourth number is zero.
    struct alignas(32) Force
    {
      double value[4];
    };

    struct Batch
    {
      Lanes         rest_det;           ///< m^3, 64 times the undeformed volume
      Lanes         inverse_mass;       ///< 1/kg, of the least mass that the nodes carry for the element
      Lanes         frequency;          ///< bound of 2/dt, 1/s
      Lanes         viscous_pressure;   ///< Pa
      std::uint32_t record[8][n_lanes]; ///< where the corners' records begin, in doubles
      std::uint32_t corner[8][n_lanes]; ///< which rows the corners' forces go to
    };
    using Stabilisation = one_point_solid::Stabilisation<Lanes>;
    using LayerPoint    = solid_shell::LayerPoint<Lanes>;

    /// Batches of one chunk belong to one thread; sums over chunks do not depend on the number of threads.
    struct Chunk
    {
      Lanes plastic = 0., hourglass = 0., viscous = 0.; ///< J, cumulative
      Lanes frequency = 0.;                             ///< largest of the chunk
    };
    static constexpr std::size_t batches_per_chunk = 16, nodes_per_chunk = 512;
    static constexpr std::size_t elements_per_block = 8192, n_resting_records = 8;

    void update_nodes(const ElementBlocks::Block &block, const double *position, const double *increment);
    void update_chunk(std::size_t chunk, double dt);
    void gather_forces(const ElementBlocks::Block &block, double *force);
    void erode(); ///< after all forces: takes out the elements that have failed
    bool is_failed(std::size_t element) const;
    void set_inverse_masses(std::span<const double> nodal_masses); ///< those of the nodes, none: eighths
    void update_scaled_frequencies();                              ///< of all, at rest
    /// The bound with scaled masses: a function of its own, for what does not happen shall cost no register.
    Lanes compute_scaled_frequency(const SolidModes<Lanes> &modes, const Lanes &rest_det, const Lanes &inverse_mass,
                                   const Lanes &drag, const MassFactors<Lanes> &factors) const;
    Lanes compute_frequency_at_rest(std::size_t batch, const MassFactors<Lanes> &factors) const;
    class Trial; ///< of factors

    std::size_t         n_elements_of(std::size_t batch) const;
    unsigned int        axis_in_batch(std::size_t element, unsigned int axis) const; ///< of an axis of the mesh's cell
    SolidModes<double>  modes(std::size_t element) const;                            ///< of its geometry
    std::size_t         n_points() const;                                            ///< of an element
    double              sum(Lanes Chunk::*energy) const;
    StoredEnergy::State stored(std::size_t point) const;  ///< of one of `points`, or an element of one point
    EntityPlace         place(std::size_t element) const; ///< its middle
    std::array<double, 6> point_stress(std::size_t element, std::size_t point) const;         ///< Kirchhoff's
    double                compute_volume_ratio(std::size_t element, std::size_t point) const; ///< J there
    /// At natural coordinates of the mesh's cell, of one point and of solid-shells.
    std::array<double, 6> stabilised_stress(std::size_t element, const std::array<double, 3> &xi) const;

    SolidSection                              section;
    SolidLaw                                  law;
    ThreadPool                               &pool;
    std::size_t                               n_nodes;
    std::vector<std::uint8_t>                 thickness_axis; ///< [n_elements] of solid-shells, in the mesh's cells
    std::vector<std::array<std::uint32_t, 8>> cells;          ///< of solid-shells with the thickness as third axis
    ElementBlocks                             blocks;
    std::vector<double>                       mass;       ///< [n_elements], kg
    std::vector<std::uint32_t>                work_begin; ///< [blocks], first of their sums in `work`
    AlignedVector<NodeRecord>                 records;
    AlignedVector<Force>                      corner_force; ///< a node's together
    AlignedVector<Force>                      node_force;   ///< [n_nodes], of the last step
    AlignedVector<Force>                      work;         ///< [chunks of nodes], J by component, cumulative
    AlignedVector<Batch>                      batches;
    AlignedVector<MassFactors<Lanes>>         mass_factors; ///< [n_batches] with scaled masses, else none
    AlignedVector<Chunk>                      chunks;
    AlignedVector<SolidPoint<Lanes>>          points;        ///< [n_batches][n_points]
    AlignedVector<Lanes>                      rest_det;      ///< of B-bar: the same, times 512, m^3
    AlignedVector<Stabilisation>              stabilisation; ///< [n_batches], not of B-bar
    ThicknessPoints                           rule;          ///< of solid-shells, as:
    std::vector<AlignedVector<LayerPoint>>    layers;        ///< [n_batches], empty while elastic
    std::unique_ptr<SolidErosion>             erosion;       ///< null where the metal cannot fail

  private:
    using Corners = Vector3<Lanes>[8];
    /// What the end of a step takes from its strains.
    struct Step
    {
      Lanes            midpoint_volume; ///< m^3
      Lanes            stiff_det;       ///< m^3, 64 times the volume that the moduli belong to
      Lanes            dilatation;      ///< trace of the mean strain increment
      Lanes            drag, pressure;  ///< of the bulk viscosity, m^2/s and Pa
      SolidWork<Lanes> work;            ///< J
    };

    void check_shape(std::size_t element);
    void build_batches();
    void update_viscosity(const SolidGeometry<Lanes> &midpoint, const Matrix3<Lanes> &gradient, double dt, Step &step);
    template <bool has_layers, bool can_fail>
    void             update_one_point(std::size_t batch, double dt, Chunk &chunk);
    SolidWork<Lanes> update_section(std::size_t batch, const Matrix3<Lanes> &gradient, const Stabilisation &strain,
                                    double dt, const SolidModes<Lanes> &end);
    SolidWork<Lanes> update_layers(std::size_t batch, double dt, const SolidModes<Lanes> &end);
    template <bool can_fail>
    void update_b_bar(std::size_t batch, double dt, Chunk &chunk);
    void finish(std::size_t batch, const SolidGeometry<Lanes> &end, const SolidModes<Lanes> &force, const Step &step,
                Chunk &chunk);
    void build_erosion();
    /// Position at the end and increment of the corners (m): what is turned inside out becomes a cube at rest.
    void  begin_failing(std::size_t batch, Corners (&corner)[2]);
    void  add_damage(std::size_t batch, const Lanes &plastic_strain, double dt);
    Lanes compute_damage(const SolidPoint<Lanes> &point, const Lanes &strain, const Lanes &von_mises, double dt) const;
    Lanes update_failing_point(std::size_t batch, int point, const Matrix3<Lanes> &gradient, const Lanes &volume,
                               double dt);
    void  release(std::size_t batch, const SolidGeometry<Lanes> &end, const SolidModes<Lanes> &u,
                  SolidModes<Lanes> &force, Step &step);
    void  take_out(std::size_t batch, std::size_t lane);
    [[noreturn]] void report_failure(std::size_t batch) const;
  };
} // namespace birdstrike
