#pragma once

#include "structure/elements/element_blocks.h"
#include "structure/elements/shell/erosion.h"
#include "structure/elements/shell/section.h"
#include "structure/elements/stored_energy.h"
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/simd/records.h>

namespace birdstrike
{
  /// Data and loops behind ShellElements. Elements lie in batches of n_lanes consecutive ones (the last batch is filled
  /// up with copies of the last element, whose forces and energies are never read).
  ///
  /// A step is three loops, each writing only what it owns, so that nothing depends on the number of threads:
  /// nodes (records with normals), batches (a row of force for every corner), nodes (sums over the corners, which lie
  /// side by side in a fixed order, and their work). Large meshes take them block by block of some thousand elements:
  /// nodes enter with the first of their elements and leave with the last; records and rows stay in the cache.
  class ShellElements::Implementation
  {
  public:
    Implementation(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 4>> cells,
                   const std::vector<double> &thickness, const ShellSection &section, ThreadPool &pool);

    /// What a batch needs of a node: two cache lines.
    struct alignas(64) NodeRecord
    {
      double position[3];        ///< at t^{n+1}, m
      double increment[3];       ///< displacement, m
      double rotation[3];        ///< increment, rad
      double midpoint_normal[3]; ///< mean of the normals at t^n and t^{n+1}
      double normal[3];          ///< averaged unit normal at t^{n+1}
      double unused = 0.;
    };

    /// The normal of a node: (x_0 - x_1) x (x_2 - x_3), of four nodes, is the sum of the normals of its elements there
    /// where up to four of them close a ring or up to two a fan; other nodes, and those on planes of symmetry, have
    /// four times themselves here, and are summed over their corners.
    using Diagonals = std::array<std::uint32_t, 4>;
    struct EnteringNode
    {
      std::uint32_t node;
      Diagonals     diagonals;
    };
    using LeavingNode = ElementBlocks::LeavingNode;

    /// Two neighbours of a node within one element: (next - node) x (previous - node) is the normal there.
    struct Corner
    {
      std::uint32_t next, previous;
    };

    struct Batch
    {
      Lanes         inverse_mass;       ///< 1/kg, of the least mass that the nodes carry for the element
      Lanes         eigenvalue;         ///< bound of omega^2, 1/s^2
      std::uint32_t record[4][n_lanes]; ///< where the corners' records begin, in doubles
      std::uint32_t corner[4][n_lanes]; ///< where the corners' forces go, see `corner_force`
    };

    /// Batches of one chunk belong to one thread; sums over chunks do not depend on the number of threads.
    struct Chunk
    {
      Lanes plastic = 0., hourglass = 0.; ///< J, cumulative
      Lanes eigenvalue = 0.;              ///< largest of the chunk
    };
    /// Of the lists below: chunks of batches, nodes that enter with them, nodes that leave after them, sums of work.
    struct Block
    {
      std::uint32_t chunk_begin, chunk_end, entering_begin, entering_end, leaving_begin, leaving_end, work_begin;
    };
    static constexpr std::size_t batches_per_chunk = 16, nodes_per_chunk = 512;
    static constexpr std::size_t elements_per_block = 8192, n_resting_records = 4;

    void update_nodes(const Block &block, const double *position, const double *increment);
    void promote(std::size_t section); ///< number in `points`
    void update_chunk(std::size_t chunk, double dt);
    void list_irregular();
    void gather_forces(const Block &block, double *force);
    void erode(const double *position); ///< after all forces: takes out the elements that have failed
    bool is_failed(std::size_t element) const;
    void set_inverse_masses(std::span<const double> nodal_masses); ///< those of the nodes, none: quarters

    /// Section k of a batch, and its points through the thickness.
    const SectionStress<Lanes>             &section_of(std::size_t batch, std::size_t k) const;
    const AlignedVector<ShellPoint<Lanes>> &points_of(std::size_t batch, std::size_t k) const;
    bool                                    has_points(std::size_t batch) const;          ///< any of its sections
    double                                  largest_thickness(std::size_t element) const; ///< m, of its sections
    /// Area, and at the points of a fully integrated element four times theirs: the smallest of them (m^2).
    double                smallest_area(std::size_t element) const;
    double                eigenvalue_bound(std::size_t element, double inverse_mass) const;
    std::size_t           n_elements_of(std::size_t batch) const;
    ShellGeometry<double> geometry(std::size_t element) const;
    double                sum(Lanes Chunk::*energy) const;
    StoredEnergy::State   stored(std::size_t section) const; ///< of section_of, by number: [n_batches][n_in_plane]
    Point3                compute_normal(std::size_t node, const double *position) const;
    EntityPlace           place(std::size_t element) const; ///< its middle

    ShellSection                              section;
    ShellSectionLaw                           law;
    double                                    initial_yield;
    ThreadPool                               &pool;
    std::size_t                               n_nodes;
    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<double>                       mass;         ///< [n_elements], kg
    std::vector<std::uint32_t>                corner_begin; ///< [n_nodes + 1]
    std::vector<Corner>                       corners;
    std::vector<Block>                        blocks;
    std::vector<EnteringNode>                 entering;  ///< by block
    std::vector<LeavingNode>                  leaving;   ///< by block
    std::vector<std::uint32_t>                irregular; ///< which of those that enter have no diagonals
    std::vector<std::vector<Point3>>          symmetry;  ///< [n_nodes], normals of symmetry planes; empty without any
    AlignedVector<NodeRecord>                 records;
    AlignedVector<Row>                        corner_force; ///< force and moment on the corners, a node's together
    AlignedVector<Row>                        node_force;   ///< [n_nodes], of the last step
    AlignedVector<Row>                        work;         ///< [chunks of nodes], J by component, cumulative
    AlignedVector<Batch>                      batches;
    AlignedVector<Chunk>                      chunks;
    std::size_t                               n_in_plane;  ///< sections of an element: one, or four fully integrated
    AlignedVector<ShellStress<Lanes>>         stress;      ///< [n_batches] of one-point elements
    AlignedVector<SectionStress<Lanes>>       sections;    ///< [4 n_batches] of fully integrated ones
    std::vector<AlignedVector<ShellPoint<Lanes>>> points;  ///< [n_in_plane n_batches], empty while elastic
    std::unique_ptr<ShellErosion>                 erosion; ///< null where the metal cannot fail

  private:
    void build_corners();
    void check_shape(std::size_t element, double thickness);
    void build_batches(const std::vector<double> &thickness, const std::vector<std::uint32_t> &corner_row);
    std::vector<std::uint32_t> build_blocks(); ///< returns the rows of the elements' corners
    Diagonals                  find_diagonals(std::uint32_t node) const;
    void update_group(const EnteringNode *nodes, std::size_t n, const double *position, const double *increment,
                      const double *last);
    void update_irregular(std::size_t node, const double *position);
    template <bool physical>
    void             update_batch(std::size_t batch, double dt, Chunk &chunk);
    ShellWork<Lanes> update_points(std::size_t batch, const ShellVector<Lanes> &strain, const Lanes &area, double dt);
    ShellWork<Lanes> update_failing_points(std::size_t batch, const ShellVector<Lanes> &strain, const Lanes &area,
                                           double dt);
    void             update_fully_integrated(std::size_t batch, double dt, Chunk &chunk);
    Lanes            update_section(std::size_t section, const SectionVector<Lanes> &strain, double dt);
    Lanes            update_failing_section(std::size_t section, const SectionVector<Lanes> &strain, double dt);
    void             release_sections(std::size_t batch, const SectionVector<Lanes> *strain, const Lanes *area);
    bool             can_collapse() const; ///< whether elements that do are eroded
    bool             has_finite_state(std::size_t element) const;
    void             take_collapsed(std::size_t chunk);
    void             collapse(std::size_t batch, Chunk &chunk);
    double           drop_forces(std::size_t batch, std::size_t lane);
    void             build_erosion();
    void             take_out(std::size_t batch, std::size_t lane, std::vector<std::uint32_t> &nodes);
    void             report_failure(std::size_t batch); ///< throws, unless what is unsound collapses and goes
  };
} // namespace birdstrike
