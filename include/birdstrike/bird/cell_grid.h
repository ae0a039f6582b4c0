#pragma once

#include <birdstrike/bird/particles.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/thread_pool.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Edges of the periodic cell; a zero stands for an open direction.
  using Period = std::array<double, 3>;

  /// Regular cells of an edge of at least `range` over the particles' box, x fastest. `update` sorts the particles by
  /// cell (stable, so that the order depends on positions alone) and remembers where each cell starts.
  class CellGrid
  {
  public:
    /// Re-orders all columns and ids of `particles`.
    void update(Particles &particles, double range, const Period &period, ThreadPool &pool);

    /// The cells and who is where in them. Reading sorts nothing: particles come in the order of their cells.
    void archive(Archive &archive, Particles &particles, ThreadPool &pool);

    std::array<int, 3> cell_coordinates(std::size_t cell) const;
    std::size_t        cell_index(int i, int j, int k) const
    {
      return (static_cast<std::size_t>(k) * n[1] + j) * n[0] + i;
    }

    /// Distinct cell coordinates within +-reach of c along direction d (wrapped where periodic); returns their number.
    int neighbors(int d, int c, int reach, int *coordinates) const;

    std::size_t n_cells() const
    {
      return static_cast<std::size_t>(n[0]) * n[1] * n[2];
    }
    std::size_t begin(const std::size_t cell) const
    {
      return start[cell];
    }
    std::size_t end(const std::size_t cell) const
    {
      return start[cell + 1];
    }
    int count(const int d) const
    {
      return n[d];
    }
    bool is_periodic(const int d) const
    {
      return periodic[d];
    }
    double edge() const ///< m, the smallest
    {
      return smallest_edge;
    }
    double lower_corner(const int d) const ///< m
    {
      return origin[d];
    }
    const std::vector<std::uint32_t> &occupied() const ///< indices of the cells that hold particles
    {
      return occupied_cells;
    }

  private:
    void lay_out(const Particles &particles, double range, const Period &period);
    void sort(Particles &particles, ThreadPool &pool); ///< by `cell_of`
    void permute(Particles &particles, ThreadPool &pool);

    std::array<int, 3>         n{1, 1, 1};
    std::array<bool, 3>        periodic{};
    Point3                     origin;
    Point3                     inverse_edge;
    double                     smallest_edge = 0.;
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> occupied_cells;
    std::vector<std::uint32_t> cell_of, order;
    AlignedVector<double>      scratch;
  };
} // namespace birdstrike
