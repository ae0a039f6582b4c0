#include "shell_mesh_grid.h"

#include <birdstrike/core/errors.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    using Vertices = std::vector<dealii::Point<3>>;

    /// n + 1 ascending positions on [0, length] whose spacings form a geometric row; last/first = grading.
    std::vector<double> graded_positions(const unsigned int n, const double length, const double grading)
    {
      std::vector<double> position(n + 1, 0.);
      const double        ratio = n > 1 ? std::pow(grading, 1. / (n - 1)) : 1.;
      double              total = 0.;
      for (unsigned int k = 0; k < n; ++k)
        total += std::pow(ratio, k);
      // Equal spacing by division: neighbouring plates then agree to the last digit.
      for (unsigned int k = 1; k <= n; ++k)
        position[k] = grading == 1. ? length * k / n : position[k - 1] + length * std::pow(ratio, k - 1) / total;
      position[n] = length;
      return position;
    }

    /// Positions along the chord, from the leading edge or, if halved, from the plane of symmetry.
    std::vector<double> chord_positions(const BladeParameters::Mesh &p, const bool is_halved)
    {
      std::vector<double> y = graded_positions(p.n_chord, p.chord, p.chord_grading);
      for (double &y_j : y)
        y_j -= 0.5 * p.chord;
      if (!is_halved)
        return y;
      if (p.n_chord % 2 != 0 || p.chord_grading != 1.)
        throw InputError("Blade/Mesh: " + std::to_string(p.n_chord) + " elements along the chord with grading " +
                         std::to_string(p.chord_grading) +
                         " have no half.\nAllowed with a symmetry plane: an even number of equal elements.");
      y.erase(y.begin(), y.begin() + p.n_chord / 2);
      y[0] = 0.;
      return y;
    }

    void make_flat_plate(const BladeParameters::Mesh &p, const bool is_halved,
                         dealii::Triangulation<2, 3> &triangulation)
    {
      const auto         x = graded_positions(p.n_span, p.length, p.span_grading);
      const auto         y = chord_positions(p, is_halved);
      const unsigned int m = y.size(), n_chord = m - 1;
      Vertices           vertices;
      for (const double x_i : x)
        for (const double y_j : y)
          vertices.emplace_back(x_i, y_j, 0.);

      std::vector<dealii::CellData<2>> cells;
      dealii::SubCellData              rim;
      const auto add_edge = [&](const unsigned int a, const unsigned int b, const unsigned int id) {
        dealii::CellData<1> edge;
        edge.vertices    = {a, b};
        edge.boundary_id = id;
        rim.boundary_lines.push_back(edge);
      };
      for (unsigned int i = 0; i < p.n_span; ++i)
        for (unsigned int j = 0; j < n_chord; ++j)
          {
            dealii::CellData<2> cell;
            cell.vertices = {i * m + j, (i + 1) * m + j, i * m + j + 1, (i + 1) * m + j + 1};
            cells.push_back(cell);
          }
      for (unsigned int j = 0; j < n_chord; ++j)
        {
          add_edge(j, j + 1, 0);
          add_edge(p.n_span * m + j, p.n_span * m + j + 1, 1);
        }
      for (unsigned int i = 0; i < p.n_span; ++i)
        {
          add_edge(i * m, (i + 1) * m, is_halved ? 4 : 2);
          add_edge(i * m + n_chord, (i + 1) * m + n_chord, 3);
        }
      triangulation.create_triangulation(vertices, cells, rim);
    }

    dealii::GridIn<2, 3>::Format format_of(const std::string &file)
    {
      const std::string suffix = file.substr(std::min(file.rfind('.'), file.size()));
      if (suffix == ".msh")
        return dealii::GridIn<2, 3>::msh;
      if (suffix == ".inp")
        return dealii::GridIn<2, 3>::ucd;
      if (suffix == ".vtk")
        return dealii::GridIn<2, 3>::vtk;
      throw InputError("Blade/Mesh/File: '" + file +
                       "' has an unknown ending.\nAllowed: .msh (Gmsh 2 and 4), .inp (UCD), .vtk.");
    }

    void read_file(const BladeParameters::Mesh &p, dealii::Triangulation<2, 3> &triangulation)
    {
      const auto    format = format_of(p.file);
      std::ifstream in(p.file);
      if (!in)
        throw InputError("Blade/Mesh/File: cannot open '" + p.file +
                         "'.\nPaths are relative to the working directory.");
      try
        {
          dealii::GridIn<2, 3> reader;
          reader.attach_triangulation(triangulation);
          reader.read(in, format);
          if (p.file_scale != 1.)
            dealii::GridTools::scale(p.file_scale, triangulation);
        }
      catch (const std::exception &)
        {
          throw InputError("Blade/Mesh/File: '" + p.file +
                           "' is not a mesh of quadrilaterals that can be read.\nAllowed: quadrilaterals with labelled "
                           "boundary lines, every other cell kind removed; Gmsh format 2 or 4, text.\n"
                           "Save again with 'Recombine' on and only physical surfaces and lines.");
        }
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->reference_cell().is_hyper_cube())
          throw InputError("Blade/Mesh/File: '" + p.file + "' contains cells that are not quadrilaterals (cell " +
                           std::to_string(cell->active_cell_index()) +
                           ").\nRecombine the triangles (Gmsh: Mesh.RecombineAll = 1).");
    }
  } // namespace

  SurfaceMesh ShellMesh::Grid::extract(const std::vector<std::uint32_t> &node_of_vertex) const
  {
    static const unsigned int counter_clockwise[4] = {0, 1, 3, 2};
    SurfaceMesh               mesh;
    mesh.nodes.resize(triangulation.n_vertices());
    for (std::size_t v = 0; v < triangulation.n_vertices(); ++v)
      for (unsigned int d = 0; d < 3; ++d)
        mesh.nodes[node_of_vertex[v]][d] = triangulation.get_vertices()[v][d];
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        std::array<std::uint32_t, 4> nodes;
        for (unsigned int k = 0; k < 4; ++k)
          nodes[k] = node_of_vertex[cell->vertex_index(counter_clockwise[k])];
        mesh.cells.push_back(nodes);
        mesh.material_ids.push_back(cell->material_id());
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            mesh.rim.push_back(
              {static_cast<std::uint32_t>(cell->active_cell_index()),
               0,
               {{node_of_vertex[cell->face(f)->vertex_index(0)], node_of_vertex[cell->face(f)->vertex_index(1)]}},
               cell->face(f)->boundary_id()});
      }
    update_topology(mesh);
    return mesh;
  }

  ShellMesh::ShellMesh(const BladeParameters::Mesh &parameters, const bool is_halved)
    : grid(std::make_unique<Grid>()), is_halved(is_halved), has_flat_plate(parameters.generator != "file")
  {
    if (has_flat_plate)
      make_flat_plate(parameters, is_halved, grid->triangulation);
    else
      read_file(parameters, grid->triangulation);
    std::vector<std::uint32_t> identity(grid->triangulation.n_vertices());
    std::iota(identity.begin(), identity.end(), 0);
    extract(identity);
    check_shape(plain);
  }

  ShellMesh::~ShellMesh() = default;

  void ShellMesh::extract(const std::vector<std::uint32_t> &node_of_vertex)
  {
    plain = grid->extract(node_of_vertex);
    if (!is_halved)
      return;
    cut_at_symmetry_plane(plain);
    if (has_flat_plate)
      plain.mirrored_ids = {2};
  }

  const SurfaceMesh &ShellMesh::surface() const
  {
    return plain;
  }
} // namespace birdstrike
