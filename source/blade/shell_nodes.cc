#include <birdstrike/blade/shell_implementation.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace birdstrike
{
  namespace
  {
    /// The mean of old and new normal, and the new one.
    template <class Record>
    void set_normal(Record &record, const double x, const double y, const double z)
    {
      const double normal[3] = {x, y, z};
      for (int c = 0; c < 3; ++c)
        {
          record.midpoint_normal[c] = 0.5 * (record.normal[c] + normal[c]);
          record.normal[c]          = normal[c];
        }
    }
  } // namespace

  void ShellElements::Implementation::update_normal(const std::size_t node, const double *position)
  {
    const auto   point  = [position](const std::size_t n) { return Point3(position + 3 * n); };
    const Point3 x      = point(node);
    Point3       normal = Point3::Zero();
    for (std::size_t k = corner_begin[node]; k < corner_begin[node + 1]; ++k)
      normal += (point(corners[k].next) - x).cross(point(corners[k].previous) - x);
    if (!symmetry.empty())
      for (const Point3 &plane : symmetry[node])
        normal -= normal.dot(plane) * plane;
    const double square = normal.squaredNorm();
    normal *= square > 0. ? inverse_root(square) : 0.;
    set_normal(records[node], normal[0], normal[1], normal[2]);
  }

  /// Nodes [begin, begin + n_lanes) of [0, n_nodes): their diagonals are read one by one, the rest is done at once.
  void ShellElements::Implementation::update_group(const std::size_t begin, const double *position,
                                                   const double *increment)
  {
    alignas(64) double difference[6][n_lanes];
    const std::size_t  n = std::min(n_lanes, n_nodes - begin);
    for (std::size_t k = 0; k < n_lanes; ++k)
      {
        const Diagonals &d = diagonals[begin + std::min(k, n - 1)];
        for (int c = 0; c < 3; ++c)
          {
            difference[c][k]     = position[3 * d[0] + c] - position[3 * d[1] + c];
            difference[3 + c][k] = position[3 * d[2] + c] - position[3 * d[3] + c];
          }
      }
    const auto           get = [&](const int c) { return load<Lanes>(difference[c]); };
    const Vector3<Lanes> a(get(0), get(1), get(2)), b(get(3), get(4), get(5));
    const Vector3<Lanes> cross  = a.cross(b);
    const Lanes          square = cross.dot(cross);
    const Vector3<Lanes> unit   = cross * select(square > Lanes(0.), inverse_root(square), Lanes(0.));
    for (int c = 0; c < 3; ++c)
      store(unit[c], difference[c]);
    for (std::size_t k = 0; k < n; ++k)
      {
        NodeRecord &record = records[begin + k];
        std::memcpy(record.position, position + 3 * (begin + k), sizeof record.position);
        std::memcpy(record.increment, increment + 6 * (begin + k), sizeof record.increment + sizeof record.rotation);
        set_normal(record, difference[0][k], difference[1][k], difference[2][k]);
      }
  }

  void ShellElements::Implementation::update_nodes(const double *position, const double *increment)
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin; n < end; n += n_lanes)
        update_group(n, position, increment);
      const auto first = std::lower_bound(irregular.begin(), irregular.end(), begin);
      for (auto node = first; node != irregular.end() && *node < end; ++node)
        update_normal(*node, position);
    };
    pool.parallel_for(n_nodes, nodes_per_chunk, std::cref(body));
  }

  void ShellElements::Implementation::gather_forces(double *force)
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
        {
          Row &sum = work[chunk];
          for (std::size_t n = chunk * nodes_per_chunk; n < std::min(n_nodes, (chunk + 1) * nodes_per_chunk); ++n)
            {
              Row           f{};
              const double *u = records[n].increment; // and rotation; what follows meets zeros
              for (std::size_t k = corner_begin[n]; k < corner_begin[n + 1]; ++k)
                for (int c = 0; c < 8; ++c)
                  f.value[c] += corner_force[k].value[c];
              for (int c = 0; c < 8; ++c)
                sum.value[c] += 0.5 * (node_force[n].value[c] + f.value[c]) * u[c];
              node_force[n] = f;
              for (int c = 0; c < 6; ++c)
                force[6 * n + c] = -f.value[c];
            }
        }
    };
    pool.parallel_for(work.size(), 1, std::cref(body));
  }
} // namespace birdstrike
