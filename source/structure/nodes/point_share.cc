#include "structure/nodes/point_share.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Where a place lies in a brick, or the nearest that the brick has: shape functions there, and how far it is, m.
    struct InBrick
    {
      std::array<double, 8> weight{};
      double                distance = INFINITY;
    };

    InBrick find_in_brick(const std::array<Point3, 8> &x, const Point3 &place)
    {
      constexpr unsigned int n_iterations = 30; // Newton's; a parallelepiped takes one
      Point3                 r            = Point3::Zero();
      InBrick                found;
      for (unsigned int k = 0; k < n_iterations; ++k)
        {
          Point3          at         = Point3::Zero();
          Matrix3<double> derivative = Matrix3<double>::Zero();
          InBrick         now;
          for (unsigned int c = 0; c < 8; ++c)
            {
              const Point3 sign(c & 1u ? 1. : -1., c & 2u ? 1. : -1., c & 4u ? 1. : -1.);
              const Point3 f = 0.5 * (Point3::Ones() + sign.cwiseProduct(r));
              now.weight[c]  = f[0] * f[1] * f[2];
              at += now.weight[c] * x[c];
              for (unsigned int d = 0; d < 3; ++d)
                derivative.col(d) += 0.5 * sign[d] * f[(d + 1) % 3] * f[(d + 2) % 3] * x[c];
            }
          now.distance = (place - at).norm();
          if (now.distance < found.distance)
            found = now;
          r += derivative.partialPivLu().solve(place - at);
          r = r.cwiseMax(-1.).cwiseMin(1.);
        }
      return found;
    }
  } // namespace

  std::vector<NodeShare> share_force(const VolumeMesh &mesh, const std::uint32_t nearest, const Point3 &place)
  {
    constexpr double margin = 1e-9, least = 1e-9; // of a brick's size; a weight that is round-off
    InBrick          best;
    std::size_t      brick = 0;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        std::array<Point3, 8> x;
        Point3                low = Point3::Constant(INFINITY), high = -low;
        for (unsigned int c = 0; c < 8; ++c)
          {
            x[c] = mesh.node(mesh.cells[cell][c]);
            low  = low.cwiseMin(x[c]);
            high = high.cwiseMax(x[c]);
          }
        const Point3 wide   = Point3::Constant(margin * (high - low).norm());
        const bool may_hold = ((place - low + wide).array() >= 0.).all() && ((high + wide - place).array() >= 0.).all();
        const bool is_beside = std::ranges::find(mesh.cells[cell], nearest) != mesh.cells[cell].end();
        if (!may_hold && !is_beside)
          continue;
        if (const InBrick found = find_in_brick(x, place); found.distance < best.distance)
          {
            best  = found;
            brick = cell;
          }
      }
    std::vector<NodeShare> shares;
    double                 sum = 0.;
    for (unsigned int c = 0; c < 8; ++c)
      if (best.weight[c] > least)
        {
          shares.push_back({mesh.cells[brick][c], best.weight[c]});
          sum += best.weight[c];
        }
    for (NodeShare &share : shares)
      share.weight /= sum;
    return shares;
  }
} // namespace birdstrike
