#pragma once

#include <birdstrike/mesh/parameters.h>

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

namespace birdstrike::test
{
  /// A mesh file that lives as long as this object: a text, or Gmsh 2.2 of quadrilaterals and triangles (dim 2), or of
  /// hexahedra and tetrahedra (dim 3), with material 1 and no boundary ids.
  class TemporaryMesh
  {
  public:
    using Places = std::vector<std::array<double, 3>>;
    using Cells  = std::vector<std::vector<int>>;

    TemporaryMesh(const std::string &ending, const std::string &text)
      : path(std::filesystem::temp_directory_path() / ("birdstrike-mesh-" + std::to_string(getpid()) + ending))
    {
      std::ofstream(path) << text;
    }
    TemporaryMesh(const Places &nodes, const Cells &cells, const int dim = 2) : TemporaryMesh(".msh", "")
    {
      std::ofstream out(path);
      out.precision(17);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << nodes.size() << '\n';
      for (std::size_t n = 0; n < nodes.size(); ++n)
        out << n + 1 << ' ' << nodes[n][0] << ' ' << nodes[n][1] << ' ' << nodes[n][2] << '\n';
      out << "$EndNodes\n$Elements\n" << cells.size() << '\n';
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          const std::size_t n = cells[c].size();
          out << c + 1 << (dim == 2 ? (n == 4 ? " 3" : " 2") : (n == 8 ? " 5" : " 4")) << " 2 1 1";
          for (const int node : cells[c])
            out << ' ' << node + 1;
          out << '\n';
        }
      out << "$EndElements\n";
    }
    TemporaryMesh(const TemporaryMesh &) = delete;
    ~TemporaryMesh()
    {
      std::filesystem::remove(path);
    }

    MeshParameters parameters() const
    {
      MeshParameters p;
      p.generator = MeshGenerator::file;
      p.file      = path;
      return p;
    }

    const std::filesystem::path path;
  };
} // namespace birdstrike::test
