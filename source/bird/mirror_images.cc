#include <birdstrike/bird/mirror_images.h>

namespace birdstrike
{
  void MirrorImages::update(const std::size_t n, const FunctionRef<bool(std::size_t)> is_near)
  {
    sources.clear();
    before.resize(n + 1);
    for (std::size_t p = 0; p < n; ++p)
      {
        before[p] = sources.size();
        if (is_near(p))
          sources.push_back(p);
      }
    before[n] = sources.size();
  }

  bool MirrorImages::may_meet(const CellGrid &grid, const int cy, const int other_cy)
  {
    return 2. * grid.lower_corner(1) + (cy + other_cy) * grid.edge() < 2. * grid.edge();
  }

  void take_image_of_those_beyond(Particles &particles)
  {
    const auto negate = [](auto &column, const std::size_t p) {
      if (!column.empty())
        column[p] = -column[p];
    };
    for (std::size_t p = 0; p < particles.size(); ++p)
      if (particles.x[1][p] < 0.)
        {
          for (auto *vector : {&particles.x, &particles.v, &particles.force, &particles.predicting_force})
            negate((*vector)[1], p);
          for (auto *tensor : {&particles.stress, &particles.velocity_gradient, &particles.predicting_velocity_gradient,
                               &particles.earlier_velocity_gradient})
            for (const int odd : {3, 5}) // xy, yz
              negate((*tensor)[odd], p);
          for (auto *tensor : {&particles.correction, &particles.shear_correction})
            for (const int odd : {3, 5})
              negate((*tensor)[odd], p);
          for (auto *axial : {&particles.spin, &particles.predicting_spin, &particles.earlier_spin})
            for (const int odd : {0, 2})
              negate((*axial)[odd], p);
        }
  }
} // namespace birdstrike
