#include "oriented_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace birdstrike::test
{
  std::vector<std::vector<unsigned int>> rotations_of_a_cube()
  {
    std::vector<std::vector<unsigned int>> all;
    for (const std::array<unsigned int, 3> &axes :
         {std::array{0u, 1u, 2u}, {1u, 2u, 0u}, {2u, 0u, 1u}, {0u, 2u, 1u}, {2u, 1u, 0u}, {1u, 0u, 2u}})
      for (unsigned int flipped = 0; flipped < 8; ++flipped)
        {
          const bool is_even = axes[1] == (axes[0] + 1) % 3;
          if (((flipped & 1) + (flipped >> 1 & 1) + (flipped >> 2)) % 2 != (is_even ? 0 : 1))
            continue; // a reflection
          std::vector<unsigned int> order(8, 0);
          for (unsigned int v = 0; v < 8; ++v)
            for (unsigned int k = 0; k < 3; ++k)
              order[v] |= ((v >> k ^ flipped >> k) & 1) << axes[k];
          all.push_back(order);
        }
    return all;
  }

  PlateFile::PlateFile(const std::array<unsigned int, 3> &n, const Listing &listing)
    : n(n), listing(listing), random(listing.seed)
  {
    const bool        is_gmsh = listing.format == MeshFormat::gmsh, is_abaqus = listing.format == MeshFormat::abaqus;
    const std::string ending  = is_gmsh ? ".msh" : is_abaqus ? ".inp" : ".k";
    std::string       pattern = (std::filesystem::temp_directory_path() / "birdstrike-XXXXXX").string() + ending;
    const int         file    = ::mkstemps(pattern.data(), static_cast<int>(ending.size()));
    std::ofstream     out(path = pattern);
    ::close(file);
    add_nodes();
    for (unsigned int d = 0; d < (n[2] > 0 ? 3u : 2u); ++d)
      add_sides(d);
    add_cells();
    mesh.names = {{10, "root"}, {11, "tip"}, {12, "leading edge"}, {13, "trailing edge"}};
    (is_gmsh ? write_gmsh : is_abaqus ? write_abaqus : write_ls_dyna)(out, mesh);
  }

  PlateFile::~PlateFile()
  {
    std::filesystem::remove(path);
  }

  BladeParameters PlateFile::parameters() const
  {
    const bool      is_gmsh = listing.format == MeshFormat::gmsh;
    BladeParameters p       = elastic_plate(n[0], n[1]);
    p.kind                  = n[2] > 0 ? BladeKind::solid : BladeKind::shell;
    p.mesh.generator        = MeshGenerator::file;
    p.mesh.file             = path;
    p.supports.clamped      = is_gmsh ? "10" : "root";
    p.supports.tip          = is_gmsh ? "11" : "tip";
    return p;
  }

  unsigned int PlateFile::node(const std::array<unsigned int, 3> &i) const
  {
    return number[(i[0] * (n[1] + 1) + i[1]) * (n[2] + 1) + i[2]];
  }

  void PlateFile::shuffle(auto &list)
  {
    if (listing.seed > 0)
      std::shuffle(list.begin(), list.end(), random);
  }

  void PlateFile::add_nodes()
  {
    const BladeParameters p = elastic_plate(n[0], n[1]);
    std::vector<Point3>   places;
    for (unsigned int i = 0; i <= n[0]; ++i)
      for (unsigned int j = 0; j <= n[1]; ++j)
        for (unsigned int k = 0; k <= n[2]; ++k)
          places.emplace_back(p.mesh.length * i / n[0], p.mesh.chord * (double(j) / n[1] - 0.5),
                              n[2] > 0 ? 0.00427 * (double(k) / n[2] - 0.5) : 0.);
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), 0);
    shuffle(order);
    number.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      {
        number[order[k]] = static_cast<unsigned int>(k + 1);
        const Point3 &x  = places[order[k]];
        mesh.nodes.push_back(listing.turned * (listing.shape ? listing.shape(x) : x));
      }
  }

  void PlateFile::add_sides(const unsigned int d)
  {
    static constexpr unsigned int ids[3][2] = {{10, 11}, {12, 13}, {15, 16}};
    const unsigned int            e = (d + 1) % 3, f = (d + 2) % 3;
    for (const unsigned int end : {0u, 1u})
      for (unsigned int a = 0; a < std::max(n[e], 1u); ++a)
        for (unsigned int b = 0; b < std::max(n[f], 1u); ++b)
          {
            const auto at = [&](const unsigned int i, const unsigned int j) {
              std::array<unsigned int, 3> place;
              place[d] = end * n[d];
              place[e] = std::min(a + i, n[e]);
              place[f] = std::min(b + j, n[f]);
              return node(place);
            };
            if (n[2] > 0)
              mesh.sides.push_back({ids[d][end], {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}});
            else
              mesh.sides.push_back({ids[d][end], {at(0, 0), at(1, 1)}});
          }
  }

  void PlateFile::add_cells()
  {
    std::vector<std::array<unsigned int, 3>> cells;
    for (unsigned int i = 0; i < n[0]; ++i)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int k = 0; k < std::max(n[2], 1u); ++k)
          cells.push_back({i, j, k});
    shuffle(cells);
    for (const auto &[i, j, k] : cells)
      {
        std::vector<unsigned int> corners, listed;
        const bool                is_solid = n[2] > 0;
        for (unsigned int v = 0; v < (is_solid ? 8u : 4u); ++v)
          corners.push_back(is_solid ? node({i + (v & 1), j + (v >> 1 & 1), k + (v >> 2)})
                                     : node({i + (v == 1 || v == 2), j + (v > 1), 0}));
        const auto order = listing.corners();
        for (const unsigned int v :
             is_solid ? std::vector{0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u} : std::vector{0u, 1u, 2u, 3u})
          listed.push_back(corners[order[v]]); // files go round the faces
        mesh.cells.push_back(listed);
      }
  }
} // namespace birdstrike::test
