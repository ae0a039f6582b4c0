#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

/// A sheet folded to a U: two legs of 100 mm, 20 mm apart, joined and held at the riser x = 0.
namespace birdstrike::test::folded_sheet
{
  inline constexpr int    n_leg = 14, n_riser = 3, n_chord = 6;
  inline constexpr double length = 0.1, height = 0.02, width = 0.06, thickness = 0.003;

  /// Middle line from the end of the lower leg to that of the upper, x and z.
  inline std::vector<std::array<double, 2>> path()
  {
    std::vector<std::array<double, 2>> points;
    for (int k = n_leg; k > 0; --k)
      points.push_back({length * k / n_leg, 0.});
    for (int k = 0; k < n_riser; ++k)
      points.push_back({0., height * k / n_riser});
    for (int k = 0; k <= n_leg; ++k)
      points.push_back({length * k / n_leg, height});
    return points;
  }

  /// Gmsh 2.2 text: quadrilaterals, or bricks in one layer with mitred corners. Ends have the ids 10 and 11.
  inline std::string folded_mesh(const bool is_solid)
  {
    const auto         line = path();
    const int          n = static_cast<int>(line.size()), n_layers = is_solid ? 2 : 1, row = n_chord + 1;
    std::ostringstream nodes, cells;
    int                n_elements = 0;
    for (int layer = 0; layer < n_layers; ++layer)
      for (int i = 0; i < n; ++i)
        {
          const auto direction = [&](const int a, const int b) {
            return std::array<double, 2>{(line[b][0] - line[a][0]), (line[b][1] - line[a][1])};
          };
          const auto before = direction(std::max(i - 1, 0), std::max(i, 1)),
                     after  = direction(std::min(i, n - 2), std::min(i + 1, n - 1));
          const double lb = std::hypot(before[0], before[1]), la = std::hypot(after[0], after[1]);
          const double nx = -before[1] / lb - after[1] / la, nz = before[0] / lb + after[0] / la;
          const double offset = is_solid ? (layer - 0.5) * thickness * 2. / (nx * nx + nz * nz) : 0.;
          const double chord  = width * (line[i][1] > 0.5 * height ? 0.85 : 1.); // rims do not meet edge on
          for (int j = 0; j <= n_chord; ++j)
            nodes << 1 + (layer * n + i) * row + j << ' ' << line[i][0] + offset * nx << ' '
                  << chord * (static_cast<double>(j) / n_chord - 0.5) << ' ' << line[i][1] + offset * nz << '\n';
        }
    const auto node    = [&](const int layer, const int i, const int j) { return 1 + (layer * n + i) * row + j; };
    const auto element = [&](const int type, const int id, const std::vector<int> &list) {
      cells << ++n_elements << ' ' << type << " 2 " << id << ' ' << id;
      for (const int k : list)
        cells << ' ' << k;
      cells << '\n';
    };
    for (int j = 0; j < n_chord; ++j)
      for (const int end : {0, n - 1})
        if (is_solid)
          element(3, end == 0 ? 10 : 11, {node(0, end, j), node(0, end, j + 1), node(1, end, j + 1), node(1, end, j)});
        else
          element(1, end == 0 ? 10 : 11, {node(0, end, j), node(0, end, j + 1)});
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j < n_chord; ++j)
        if (is_solid)
          element(5, 1,
                  {node(0, i, j), node(0, i + 1, j), node(0, i + 1, j + 1), node(0, i, j + 1), node(1, i, j),
                   node(1, i + 1, j), node(1, i + 1, j + 1), node(1, i, j + 1)});
        else
          element(3, 1, {node(0, i, j), node(0, i + 1, j), node(0, i + 1, j + 1), node(0, i, j + 1)});
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(n_layers * n * row) + "\n" + nodes.str() +
           "$EndNodes\n$Elements\n" + std::to_string(n_elements) + "\n" + cells.str() + "$EndElements\n";
  }

  /// A case that throws the upper leg onto the lower one, with the mesh in a file.
  inline std::string folded_case(const bool is_solid, const std::string &mesh_file)
  {
    std::ostringstream text;
    text << "subsection Blade\n set Kind = " << (is_solid ? "solid" : "shell")
         << "\n subsection Mesh\n set Generator = file\n set File = " << mesh_file << "\n end\n"
         << " subsection Thickness\n set Value = " << thickness << "\n end\n"
         << " subsection Material\n set Name = Al 6061-T6\n end\n"
         << " subsection Supports\n set Clamped =\n set Hub = 10\n set Tip = 11\n set Free =\n"
         << (is_solid ? " set Held boxes = -0.01 -1 -1 0.0016 1 1: ux uy uz\n end\nend\n"
                      : " set Held boxes = -0.0001 -1 -1 0.0001 1 1: ux uy uz rx ry rz\n end\nend\n")
         << "subsection Bird\n set Mass = 0.03\n set Particle spacing = 0.005\n set Velocity = 0, 0, -150\n"
         << " set Aim point = 0.08, 0, 0.02\nend\nsubsection Time\n set End time = 0.5e-3\n set Threads = 1\nend\n";
    return text.str();
  }
} // namespace birdstrike::test::folded_sheet
