#include "study.h"

#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>

namespace birdstrike::studies
{
  namespace
  {
    /// Nodes of a plate of which the inner corners of elements are moved by up to a quarter of an edge; nodes between
    /// corners stand where the trilinear element has them.
    std::vector<double> distort(const Part &part, const Plate &plate)
    {
      const unsigned int  p       = part.degree;
      const double        edge[3] = {plate.length / plate.n[0], plate.chord / plate.n[1], plate.thickness / plate.n[2]};
      std::vector<double> position;
      for (std::size_t n = 0; n < part.nodes.size(); ++n)
        for (int c = 0; c < 3; ++c)
          {
            double sum = 0.; // of the moves of the corners around
            for (unsigned int k = 0; k < 8; ++k)
              {
                double share = 1., phase = 1. + c;
                bool   is_inner = true;
                for (int d = 0; d < 3; ++d)
                  {
                    const unsigned int g = part.grid[n][d], low = g / p, corner = low + (k >> d & 1);
                    const double       s = double(g % p) / p;
                    share *= k >> d & 1 ? s : 1. - s;
                    is_inner = is_inner && corner > 0 && corner < plate.n[d];
                    phase    = 7. * phase + 3. * corner;
                  }
                sum += is_inner ? share * 0.25 * std::sin(phase * phase) : 0.;
              }
            position.push_back(part.nodes[n][c] + edge[c] * sum);
          }
      return position;
    }

    double norm(const std::vector<double> &f)
    {
      double sum = 0.;
      for (const double v : f)
        sum += v * v;
      return std::sqrt(sum);
    }
  } // namespace

  double check_patch(const Part &original, const Plate &plate)
  {
    if (original.n_unknowns != 3 || std::min({plate.n[0], plate.n[1], plate.n[2]}) < 2)
      throw InputError("Checks are made on bricks, two at least in every direction.");
    const std::vector<double>   position = distort(original, plate);
    const std::unique_ptr<Part> part     = original.make_elastic(position.data());
    std::vector<double>         u, force(position.size()), x(position);
    for (std::size_t n = 0; n < part->nodes.size(); ++n)
      {
        const double *a = &position[3 * n];
        u.insert(u.end(), {1e-9 * (a[0] + 0.3 * a[1]), 1e-9 * (0.5 * a[1] - a[2]), 1e-9 * (0.7 * a[2] + 0.2 * a[0])});
      }
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += u[i];
    part->compute_internal_forces(x.data(), u.data(), 1., force.data());
    double inner = 0., outer = 0.;
    for (std::size_t n = 0; n < part->nodes.size(); ++n)
      {
        bool is_inner = true;
        for (int d = 0; d < 3; ++d)
          is_inner = is_inner && part->grid[n][d] > 0 && part->grid[n][d] < part->n_grid[d] - 1;
        for (int c = 0; c < 3; ++c)
          (is_inner ? inner : outer) = std::max(is_inner ? inner : outer, std::abs(force[3 * n + c]));
      }
    return inner / outer;
  }

  double check_turning(Part &part)
  {
    const double        angle = 2. * M_PI / 72.;
    std::vector<double> x, u, force(3 * part.nodes.size());
    for (const Point3 &p : part.nodes)
      {
        u.insert(u.end(), {1e-3 * p[0] * (1. + 50. * p[2]), -3e-4 * p[1] * p[1] / 0.01, 0.});
        x.insert(x.end(), {p[0], p[1], p[2]});
      }
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += u[i];
    part.compute_internal_forces(x.data(), u.data(), 1., force.data());
    const std::vector<double> before = force;
    const Matrix3<double>     turn   = Eigen::AngleAxisd(angle, Point3(1., 2., 3.).normalized()).toRotationMatrix();
    for (int k = 0; k < 72; ++k)
      {
        for (std::size_t n = 0; n < part.nodes.size(); ++n)
          {
            const Point3 old(&x[3 * n]), next = turn * old;
            for (int c = 0; c < 3; ++c)
              {
                u[3 * n + c] = next[c] - old[c];
                x[3 * n + c] = next[c];
              }
          }
        part.compute_internal_forces(x.data(), u.data(), 1., force.data());
      }
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] -= before[i];
    return norm(force) / norm(before);
  }
} // namespace birdstrike::studies
