#pragma once

#include "structure/elements/element_blocks.h"
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// What a batch of shells needs of a node: two cache lines.
  struct alignas(64) ShellRecord
  {
    double position[3];        ///< at t^{n+1}, m
    double increment[3];       ///< displacement, m
    double rotation[3];        ///< increment, rad
    double midpoint_normal[3]; ///< mean of the directors at t^n and t^{n+1}
    double normal[3];          ///< unit director at t^{n+1}
    double unused = 0.;
  };

  /// Where shells meet in a fold each sheet keeps a director of its own. One that all of them shared would stand across
  /// none: the gradient of the directors is then that of a shell as sharply curved as its elements are short, and the
  /// Shifter bends it too easily (a strip of 2 mm folded by 90 / 120 / 150 degrees, elements of 2.5 mm: 0.2 / 0.8 / 5 %
  /// of the deflection, twice as much with half of these; at 60 degrees 0.04 %).
  ///
  /// The sheets of a node are chains of elements across whose common edges the normals turn by less than the angle from
  /// which on contact, too, takes a surface for two. A node has a record for each of its sheets.
  struct ShellSheets
  {
    static constexpr double least_cosine = 0.5 - 1e-6; ///< 60 degrees, which themselves are no fold whatever round-off

    /// Records behind `first_record` are of the nodes' second sheets and of those that follow.
    ShellSheets(const std::vector<Point3> &points, const std::vector<std::array<std::uint32_t, 4>> &cells,
                std::uint32_t first_record);

    std::vector<std::array<std::uint32_t, 4>> records_of_corners; ///< as cells; none where there is no fold
    std::vector<std::uint32_t>                nodes;              ///< of the records behind the first, ascending
  };

  /// The nodes of shells: their records, and the director of each. At rest it is the averaged normal, the normalised
  /// sum of those of the elements of one of the node's sheets (ShellSheets); then it turns with the node. Of a step's
  /// rotation increment theta, taken as a Cayley (Rodrigues) vector, n^{n+1} - n^n = theta x (n^n + n^{n+1})/2 to
  /// round-off, which is what strain increments at the midpoint count (Hughes & Winget 1980). A director that followed
  /// the positions instead would leave bending moments a tangent that is not symmetric, on which short waves of
  /// elements as thick as long grow by flutter.
  class ShellNodes
  {
  public:
    using Cell = std::array<std::uint32_t, 4>;

    /// Positions (m) and cells, counter-clockwise about the positive normal.
    ShellNodes(const std::vector<Point3> &points, const std::vector<Cell> &cells, const ElementBlocks &blocks,
               ThreadPool &pool);

    /// Records of the nodes that enter with the block, from positions [n_nodes][3] and increments [n_nodes][6].
    void update(const ElementBlocks::Block &block, const double *position, const double *increment);

    /// The directors of these are in the plane, before the first step; those of sheets that meet their mirror images in
    /// a fold stay their own.
    void add_symmetry_plane(std::span<const std::uint32_t> nodes, const Point3 &plane_normal);

    /// Of one node, besides its position.
    void archive(Archive::Row &row, const std::size_t node)
    {
      row("normal", records[node].normal);
    }
    /// Of the other sheets of folds, with positions [n_nodes][3].
    void archive_folds(Archive &archive, const double *position);

    /// Unit vector about which the node may turn without effect; zero in a fold, where there is none unless its sheets
    /// lie on one another.
    Point3 director(std::uint32_t node) const;

    std::size_t bytes() const;

    std::size_t                n_nodes;
    ShellSheets                sheets;
    AlignedVector<ShellRecord> records; ///< of the nodes, of a square of 1 m at rest, of the nodes' other sheets

  private:
    void update_group(const std::uint32_t *node, const std::uint32_t *record, std::size_t n, const double *position,
                      const double *increment);
    void sort_folds(const ElementBlocks &blocks);
    std::size_t first_fold() const ///< record
    {
      return n_nodes + 4;
    }

    ThreadPool                &pool;
    std::vector<std::uint32_t> entering; ///< nodes by block
    /// The same of other sheets' records, and their nodes; [n_blocks + 1] where those of a block begin, none without.
    std::vector<std::uint32_t> folds, folded, folds_begin;
    std::vector<std::uint32_t> folded_on_plane; ///< nodes, ascending
    std::vector<Point3>        sums; ///< by record, of the area vectors of a sheet's elements at the node at rest, m^2
  };
} // namespace birdstrike
