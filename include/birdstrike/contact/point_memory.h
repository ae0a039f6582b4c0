#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What contact remembers of one point, by its persistent id.
  ///
  /// Size and impedance are those of the undeformed liquid. They make the spring (law.h), so that its
  /// energy is a function of position alone, and torn-off spray, whose numerical volume grows without bound, keeps the
  /// size of the liquid it is. To the damper density and sound speed are floors: a droplet strikes as liquid, however
  /// far its particles have parted.
  struct PointRecord
  {
    /// The side on which the point met a piece of surface.
    struct Side
    {
      std::int32_t                 piece = -1;
      std::array<std::uint32_t, 4> nodes{};         ///< of the facet: a fold has several sheets of one piece
      std::int8_t                  sign        = 0; ///< +1 on the normal's side, -1 on the other, 0 beyond a free edge
      bool                         is_touching = false;
      bool                         is_through  = false;     ///< touching, and beyond the middle surface
      bool                         is_on_edge_face = false; ///< of a shell
      bool                         was_beyond      = false; ///< an edge's plane, where nothing is in the way
      double                       reference       = 0.;    ///< m, penetration when the facet was new: carries no force
      double                       overlap         = 0.;    ///< m, in the last call
      double                       depth           = 0.;    ///< m, in the last call; 0 without a force
      std::array<float, 3> outward{}; ///< of a one-sided surface: the direction away from it when last seen outside
    };

    double              size        = 0.; ///< V^(1/3), m; 0: not yet seen
    double              density     = 0.; ///< kg/m^3
    double              sound_speed = 0.; ///< m/s
    std::array<Side, 2> sides{};
    std::uint64_t       last_call = 0; ///< number of the call that wrote `sides`: older ones have left

    double        modulus    = 0.; ///< rho0 c0^2 of the spring, Pa; chosen where a touch begins, kept until it ends
    std::uint64_t last_touch = 0;  ///< number of the last call in which it touched
    std::uint32_t index      = 0;  ///< of the point when the views had the present revision; its id tells if it left

    /// Modulus of the liquid over that of the spring, 1 unless the target is light.
    double softening() const
    {
      return modulus > 0. ? density * sound_speed * sound_speed / modulus : 1.;
    }
  };

  /// Copied where a side is forgotten: one that is put together on the spot is read before its parts are written.
  inline constexpr PointRecord::Side unknown_side{};

  /// Records for all ids that ever existed.
  class PointMemory
  {
  public:
    /// Enters points that were never seen, and where all of them stand now.
    void update(const PointsView &points);

    void archive(Archive &archive);

    /// Forgets all sides (another surface).
    void forget_sides();

    PointRecord &operator[](const std::uint32_t id)
    {
      return records[id];
    }
    const PointRecord *data() const
    {
      return records.data();
    }
    double max_size() const
    {
      return largest_size;
    }

  private:
    std::vector<PointRecord> records;
    std::uint64_t            revision     = 0;
    bool                     is_empty     = true;
    double                   largest_size = 0.;
  };
} // namespace birdstrike
