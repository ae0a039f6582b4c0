#pragma once

#include <birdstrike/bird/cell_grid.h>
#include <birdstrike/bird/particles.h>
#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/function_ref.h>

#include <cstdint>

namespace birdstrike
{
  /// The particles within range of the symmetry plane y = 0, seen from its other side: (x, -y, z), (v_x, -v_y, v_z).
  ///
  /// Half a bird (y > 0) moves as if whole when every particle sums over the images too. Images are numbered after the
  /// particles and the dummy that pads the lists: image g has the index n + 1 + g and the state of particle source(g).
  /// They follow the order of their sources, so the images of consecutive particles are consecutive.
  class MirrorImages
  {
  public:
    /// Images of those of n particles for which `is_near` says yes.
    void update(std::size_t n, FunctionRef<bool(std::size_t)> is_near);

    std::size_t size() const
    {
      return sources.size();
    }
    std::size_t source(const std::size_t image) const
    {
      return sources[image];
    }
    /// Number of images of particles [0, particle).
    std::size_t count_before(const std::size_t particle) const
    {
      return before[particle];
    }

    /// Whether cells of these coordinates along y may hold a particle and an image closer than two cell edges.
    static bool may_meet(const CellGrid &grid, int cy, int other_cy);

  private:
    AlignedVector<std::uint32_t> sources, before;
  };

  /// A particle that comes through the plane meets its image on the way: of the whole, which cannot tell one from the
  /// other, the image is then that on this side. Without it half a blade, which ends at the plane, would not be below
  /// the particle.
  void take_image_of_those_beyond(Particles &particles);
} // namespace birdstrike
