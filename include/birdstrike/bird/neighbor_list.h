#pragma once

#include <birdstrike/bird/cell_candidates.h>
#include <birdstrike/bird/cell_grid.h>
#include <birdstrike/bird/mirror_images.h>
#include <birdstrike/core/aligned_vector.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// All pairs closer than range = support + skin (Verlet 1967), as one full list per particle: each owner sums over
  /// all its neighbours in list order, so sums do not depend on the number of threads. Lists are padded to whole SIMD
  /// registers with the index n of a dummy particle. No cap on the number of neighbours.
  ///
  /// Rebuilt by *relative* displacement. With u the displacement since the build, a pair that is missing from the list
  /// was at least `range` apart and matters only after |u_i - u_j| > skin. Cells have an edge >= range; hence
  ///  - cells up to two apart: the boxes of u of both cells bound |u_i - u_j|; rebuild if it exceeds the skin;
  ///  - cells farther apart: initially at least 2 edges apart; rebuild if 2 max |u - u_mean| exceeds 2 edge - support.
  /// A bird that flies as a whole never rebuilds. Of a mirrored bird the same holds with u reflected for images.
  class NeighborList
  {
  public:
    /// Lists are padded to multiples of `padding`, the width of the loops that read them.
    NeighborList(double support, double skin, const Period &period, std::size_t padding = n_lanes);

    /// Lists the images of particles beyond the plane y = 0 too, from the next update on.
    void mirror()
    {
      is_mirrored = true;
    }
    const MirrorImages &images() const
    {
      return mirror_images;
    }

    /// Sorts the particles and lists their neighbours.
    void update(Particles &particles, ThreadPool &pool);

    bool is_outdated(const Particles &particles, ThreadPool &pool);

    /// What lists are made of, the float positions of their build: reading makes the same lists again, whatever the
    /// particles have done since. `particles` are those of the archive.
    void archive(Archive &archive, Particles &particles, ThreadPool &pool);

    const std::uint32_t *neighbors(const std::size_t particle) const
    {
      return first[particle];
    }
    /// Entries of the list, a multiple of n_lanes.
    std::size_t padded_count(const std::size_t particle) const
    {
      return count[particle];
    }
    const std::size_t *cost_prefix() const ///< summed padded counts, n + 1 entries
    {
      return prefix.data();
    }
    std::size_t longest() const ///< entries of the longest list
    {
      return longest_count;
    }
    std::size_t n_builds() const
    {
      return builds;
    }
    const Period &period() const
    {
      return cell_period;
    }

  private:
    template <bool is_periodic>
    void   list_cells(std::size_t n, std::size_t chunk, std::size_t begin, std::size_t end);
    void   update_positions(const Particles &particles);
    void   reflect_positions(std::size_t n); ///< of n particles, to their images
    void   make_lists(std::size_t n, ThreadPool &pool);
    void   add_images(std::size_t cell, CellCandidates &candidates) const;
    double compute_image_spread(std::size_t o) const;
    void   list_near_cells();
    double update_extremes(const Particles &particles, ThreadPool &pool);
    double compute_largest_spread(std::size_t begin, std::size_t end) const;

    /// Occupied cells [begin, end).
    struct CellRun
    {
      std::uint32_t begin, end;
    };

    double       support, skin;
    std::size_t  list_padding;
    Period       cell_period;
    CellGrid     grid;
    bool         is_mirrored = false;
    MirrorImages mirror_images;
    /// Lists of one chunk of cells; chunks are made for threads, lists do not depend on them.
    std::vector<AlignedVector<std::uint32_t>> chunks;
    std::vector<CellCandidates>               candidates_of_chunk;
    std::vector<const std::uint32_t *>        first;
    std::vector<std::uint32_t>                count, offset;
    std::vector<std::size_t>                  prefix;
    std::vector<std::uint32_t>                near_start, occupied_before;
    std::vector<CellRun>                      near_runs;
    FloatPositions                            positions; ///< m, at the build, relative to origin
    std::array<double, 3>                     origin{};
    double                                    safe_range = 0.;
    Particles::Column3                        lowest, highest; ///< displacement, by occupied cell
    std::size_t                               longest_count = 0;
    std::size_t                               builds        = 0;
  };
} // namespace birdstrike
