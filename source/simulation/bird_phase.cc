#include "simulation/bird_phase.h"

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
      std::array<double, 3> lower, upper;     // m
      std::array<double, 3> slowest, fastest; // m/s
    };

    std::vector<Block> make_blocks(const FacetsView &facets, const double offset)
    {
      std::vector<Block> blocks;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          if (f % facets_per_block == 0)
            {
              constexpr std::array<double, 3> high{{INFINITY, INFINITY, INFINITY}},
                low{{-INFINITY, -INFINITY, -INFINITY}};
              blocks.push_back({high, low, high, low});
            }
          Block       &block  = blocks.back();
          const double margin = offset + facets.half_thickness[f];
          for (const std::uint32_t node : facets.nodes[f])
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double x = facets.position[3 * node + d], v = facets.velocity[facets.velocity_stride * node + d];
                block.lower[d]   = std::min(block.lower[d], x - margin);
                block.upper[d]   = std::max(block.upper[d], x + margin);
                block.slowest[d] = std::min(block.slowest[d], v);
                block.fastest[d] = std::max(block.fastest[d], v);
              }
        }
      return blocks;
    }

    /// Cuts [first, last] to the times at which a + b t >= 0.
    void cut(const double a, const double b, double &first, double &last)
    {
      if (b > 0.)
        first = std::max(first, -a / b);
      else if (b < 0.)
        last = std::min(last, -a / b);
      else if (a < 0.)
        last = -INFINITY;
    }

    bool meets(const std::array<double, 3> &x, const std::array<double, 3> &v, const Block &block, const double horizon)
    {
      double first = 0., last = horizon;
      for (unsigned int d = 0; d < 3 && first <= last; ++d)
        {
          cut(x[d] - block.lower[d], v[d] - block.slowest[d], first, last);
          cut(block.upper[d] - x[d], block.fastest[d] - v[d], first, last);
        }
      return first <= last;
    }

    double relative_speed(const std::array<double, 3> &v, const Block &block)
    {
      std::array<double, 3> u;
      for (unsigned int d = 0; d < 3; ++d)
        u[d] = std::max(std::abs(v[d] - block.slowest[d]), std::abs(v[d] - block.fastest[d]));
      return std::hypot(u[0], u[1], u[2]);
    }
  } // namespace

  double compute_reachable_impulse(const PointsView &points, const FacetsView &facets, const double horizon)
  {
    const std::vector<Block> blocks = make_blocks(facets, 0.5 * points.spacing);
    double                   sum    = 0.;
    for (std::size_t p = 0; p < points.n; ++p)
      {
        const std::array<double, 3> x{{points.position[0][p], points.position[1][p], points.position[2][p]}};
        const std::array<double, 3> v{{points.velocity[0][p], points.velocity[1][p], points.velocity[2][p]}};
        double                      speed = 0.;
        for (const Block &block : blocks)
          if (meets(x, v, block, horizon))
            speed = std::max(speed, relative_speed(v, block));
        sum += points.mass[p] * speed;
      }
    return sum;
  }
} // namespace birdstrike
