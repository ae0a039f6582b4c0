#include "solid_round_meshes.h"

namespace solid_harness
{
  Mesh make_quarter_cylinder(const unsigned int n, const unsigned int n_z, const double radius, const double height)
  {
    const double a = 0.55 * radius, b = 0.45 * radius; // the square's corners (a, 0), (b, b), (0, a)
    const auto   square = [=](const double u, const double v) {
      return Point3(u * ((1. - v) * a + v * b), v * ((1. - u) * a + u * b), 0.);
    };
    const auto outer = [=](const double u, const double v, const bool is_upper) {
      const double angle = 0.25 * M_PI * v;
      const Point3 x     = (1. - u) * square(1., v) + u * radius * Point3(std::cos(angle), std::sin(angle), 0.);
      return is_upper ? Point3(x[1], x[0], 0.) : x;
    };
    Mesh                                         mesh;
    std::map<std::array<long, 3>, std::uint32_t> known;
    const auto                                   add = [&](Point3 x, const unsigned int k) {
      x[2]                          = height * k / n_z;
      const std::array<long, 3> key = {std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), long(k)};
      const auto [place, is_new] = known.insert({key, std::uint32_t(mesh.nodes.size())});
      if (is_new)
        mesh.nodes.push_back(x);
      return place->second;
    };
    for (unsigned int k = 0; k < n_z; ++k)
      for (int block = 0; block < 3; ++block)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              std::array<std::uint32_t, 8> cell;
              for (unsigned int c = 0; c < 8; ++c)
                {
                  // the upper block is the mirror image: its first two directions change places
                  const unsigned int p = block == 2 ? (c >> 1 & 1) : (c & 1), q = block == 2 ? (c & 1) : (c >> 1 & 1);
                  const double       u = double(i + p) / n, v = double(j + q) / n;
                  cell[c] = add(block == 0 ? square(u, v) : outer(u, v, block == 2), k + (c >> 2));
                }
              mesh.cells.push_back(cell);
            }
    return mesh;
  }

  Mesh make_octant(const unsigned int n_angle, const unsigned int n_radius, const double inner, const double outer)
  {
    Mesh                                         mesh;
    std::map<std::array<long, 3>, std::uint32_t> known;
    const auto                                   node = [&](const int axis, const std::array<unsigned int, 3> &at) {
      Point3 x;
      x[axis]           = 1.;
      x[(axis + 1) % 3] = std::tan(0.25 * M_PI * at[0] / n_angle);
      x[(axis + 2) % 3] = std::tan(0.25 * M_PI * at[1] / n_angle);
      x *= (inner + (outer - inner) * at[2] / n_radius) / x.norm();
      const std::array<long, 3> key = {std::lround(1e9 * x[0]), std::lround(1e9 * x[1]), std::lround(1e9 * x[2])};
      const auto [place, is_new] = known.insert({key, std::uint32_t(mesh.nodes.size())});
      if (is_new)
        mesh.nodes.push_back(x);
      return place->second;
    };
    for (int axis = 0; axis < 3; ++axis)
      for (unsigned int k = 0; k < n_radius; ++k)
        for (unsigned int j = 0; j < n_angle; ++j)
          for (unsigned int i = 0; i < n_angle; ++i)
            {
              std::array<std::uint32_t, 8> cell;
              for (unsigned int c = 0; c < 8; ++c)
                cell[c] = node(axis, {i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)});
              mesh.cells.push_back(cell);
            }
    return mesh;
  }
} // namespace solid_harness
