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
} // namespace birdstrike
