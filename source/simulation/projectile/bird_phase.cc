#include "simulation/projectile/bird_phase.h"

#include <birdstrike/core/box.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t facets_per_block = 16;

    struct Block
    {
      Box box;      // m
      Box velocity; // m/s, the range of each component
    };

    std::vector<Block> make_blocks(const FacetsView &facets, const double offset)
    {
      std::vector<Block> blocks;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          if (f % facets_per_block == 0)
            blocks.emplace_back();
          Block       &block  = blocks.back();
          const double margin = offset + facets.half_thickness[f];
          for (const std::uint32_t node : facets.nodes[f])
            {
              block.box.add(facets.position + 3 * node, margin);
              block.velocity.add(facets.velocity + facets.velocity_stride * node);
            }
        }
      return blocks;
    }

    double relative_speed(const Point3 &v, const Box &velocity)
    {
      std::array<double, 3> u;
      for (unsigned int d = 0; d < 3; ++d)
        u[d] = std::max(std::abs(v[d] - velocity.low[d]), std::abs(v[d] - velocity.high[d]));
      return std::hypot(u[0], u[1], u[2]);
    }
  } // namespace

  double compute_reachable_impulse(const PointsView &points, const FacetsView &facets, const double horizon)
  {
    const std::vector<Block> blocks = make_blocks(facets, 0.5 * points.spacing);
    double                   sum    = 0.;
    for (std::size_t p = 0; p < points.n; ++p)
      {
        const Point3 x(points.position[0][p], points.position[1][p], points.position[2][p]);
        const Point3 v(points.velocity[0][p], points.velocity[1][p], points.velocity[2][p]);
        double       speed = 0.;
        for (const Block &block : blocks)
          {
            const TimeSpan inside = block.box.passage(x, v, block.velocity);
            if (inside.first <= std::min(inside.last, horizon))
              speed = std::max(speed, relative_speed(v, block.velocity));
          }
        sum += points.mass[p] * speed;
      }
    return points.plane.whole(sum);
  }
} // namespace birdstrike
