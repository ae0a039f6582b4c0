#pragma once

#include <birdstrike/blade/shell_section.h>
#include <birdstrike/core/aligned_vector.h>

namespace birdstrike
{
  /// Data and loops behind ShellElements. Elements lie in batches of n_lanes consecutive ones (the last batch is filled
  /// up with copies of the last element, whose forces and energies are never read).
  ///
  /// A step is three loops, each writing only what it owns, so that nothing depends on the number of threads:
  /// nodes (normals, director increments), batches (forces on corners), nodes (sums over the corners, fixed order).
  class ShellElements::Implementation
  {
  public:
    Implementation(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 4>> cells,
                   const std::vector<double> &thickness, const ShellSection &section, ThreadPool &pool);

    /// What a batch needs of a node, contiguous.
    struct alignas(64) NodeRecord
    {
      double position[3];        ///< at t^{n+1}, m
      double increment[3];       ///< displacement, m
      double normal[3];          ///< averaged unit normal at t^{n+1}
      double midpoint_normal[3]; ///< mean of the normals at t^n and t^{n+1}
      double rotation[3];        ///< increment, rad
      double unused = 0.;
    };

    /// Two neighbours of a node within one element: (next - node) x (previous - node) is the normal there.
    struct Corner
    {
      std::uint32_t next, previous;
      std::uint32_t element, corner;
    };

    struct Batch
    {
      ShellStress<Lanes> stress;
      Lanes              mass;                     ///< kg
      Lanes              area;                     ///< m^2, at t^{n+1}
      Lanes              eigenvalue;               ///< bound of omega^2, 1/s^2
      Lanes              work, plastic, hourglass; ///< J, cumulative
      Lanes              force[4][6];              ///< on the corners, N and N m
    };

    void update_nodes(const double *position, const double *increment);
    void update_normal(std::size_t node);
    void promote(std::size_t batch);
    void update_batch(std::size_t batch, double dt);
    void gather_forces(double *force) const;
    void check(std::size_t batch) const;

    ShellGeometry<double> geometry(std::size_t element) const;
    double                sum(Lanes Batch::*energy) const;

    ShellSection                              section;
    ShellSectionLaw                           law;
    double                                    initial_yield;
    ThreadPool                               &pool;
    std::size_t                               n_nodes;
    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<std::size_t>                  corner_begin; ///< [n_nodes + 1]
    std::vector<Corner>                       corners;
    std::vector<std::vector<Point3>>          symmetry; ///< [n_nodes], normals of symmetry planes; empty without any
    AlignedVector<NodeRecord>                 records;
    AlignedVector<Batch>                      batches;
    std::vector<AlignedVector<ShellPoint<Lanes>>> points; ///< [n_batches], empty while elastic
    std::vector<double> mass_ratio;                       ///< [n_elements], nodal mass over sum of quarters, worst node

  private:
    using CornerVectors = Vector3<Lanes>[4];
    void load_corners(std::size_t batch, double (NodeRecord::*member)[3], CornerVectors &result) const;
    void build_corners();
    void build_batches(const std::vector<double> &thickness);
    template <bool physical>
    void update_batch_as(std::size_t batch, double dt);
  };
} // namespace birdstrike
