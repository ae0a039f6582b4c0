#include "mesh/generated_surface.h"
#include "mesh/material_patches.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/mesh/blade_shape.h>

#include <cmath>
#include <string>

namespace birdstrike
{
  namespace
  {
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

    /// Lines of nodes, in shares of the whole span and chord.
    struct Lines
    {
      std::vector<double> span, chord;
    };

    Lines make_lines(const MeshParameters &p, const MaterialPatches &patches)
    {
      return {patches.lines_along_span(graded_positions(p.n_span, 1., p.span_grading)),
              patches.lines_along_chord(graded_positions(p.n_chord, 1., p.chord_grading))};
    }

    void set_material_ids(const MaterialPatches &patches, const Lines &lines, GeneratedSurface &surface)
    {
      const auto first = static_cast<unsigned int>(lines.chord.size()) - 1 - surface.n_chord; // of a half
      for (unsigned int i = 0; i < surface.n_span; ++i)
        for (unsigned int j = first; j < first + surface.n_chord; ++j)
          surface.material_ids.push_back(
            patches.id_at(0.5 * (lines.span[i] + lines.span[i + 1]), 0.5 * (lines.chord[j] + lines.chord[j + 1])));
    }

    void require_half(const MeshParameters &p, const MaterialPatches &patches)
    {
      if (p.n_chord % 2 != 0 || p.chord_grading != 1.)
        throw InputError("Blade/Mesh: " + std::to_string(p.n_chord) + " elements along the chord with grading " +
                         number_text(p.chord_grading) +
                         " have no half.\nAllowed with a symmetry plane: an even number of equal elements.");
      if (!patches.are_symmetric())
        throw InputError("Blade/Mesh/Material patches are not symmetric about the plane y = 0.\nGive each patch its "
                         "mirror image (s0 s1 1-c1 1-c0), or set Case/Symmetry plane to none.");
    }

    GeneratedSurface flat_plate(const MeshParameters &p, const bool is_halved)
    {
      const MaterialPatches patches(p.material_patches);
      if (is_halved)
        require_half(p, patches);
      const Lines lines = make_lines(p, patches);
      // Without patches by one division: neighbouring plates then agree to the last digit.
      std::vector<double> x = graded_positions(p.n_span, p.length, p.span_grading),
                          y = graded_positions(p.n_chord, p.chord, p.chord_grading);
      if (!patches.empty())
        {
          for (std::size_t i = 0; i < x.size(); ++i)
            x[i] = p.length * lines.span[i];
          for (std::size_t j = 0; j < y.size(); ++j)
            y[j] = p.chord * lines.chord[j];
        }
      for (double &y_j : y)
        y_j -= 0.5 * p.chord;
      if (is_halved)
        {
          y.erase(y.begin(), y.begin() + p.n_chord / 2);
          y[0] = 0.;
        }
      GeneratedSurface surface;
      surface.n_span    = p.n_span;
      surface.n_chord   = y.size() - 1;
      surface.is_halved = is_halved;
      for (const double x_i : x)
        for (const double y_j : y)
          surface.nodes.emplace_back(x_i, y_j, 0.);
      surface.normals.assign(surface.nodes.size(), Point3::UnitZ());
      set_material_ids(patches, lines, surface);
      return surface;
    }

    GeneratedSurface twisted_blade(const MeshParameters &p, const bool is_halved)
    {
      if (is_halved)
        throw InputError("Blade/Mesh/Generator: the built-in blade has no plane of symmetry.\nAllowed with one: flat "
                         "plate, file. Action: set Case/Symmetry plane to none.");
      const BladeShape      shape(p);
      const MaterialPatches patches(p.material_patches);
      const Lines           lines = make_lines(p, patches);
      GeneratedSurface      surface;
      surface.n_span  = p.n_span;
      surface.n_chord = p.n_chord;
      for (const double s : lines.span)
        for (const double c : lines.chord)
          {
            surface.nodes.push_back(shape.position(s, c));
            surface.normals.push_back(shape.normal(s, c));
          }
      set_material_ids(patches, lines, surface);
      return surface;
    }

    dealii::Point<3> point(const Point3 &p)
    {
      return {p[0], p[1], p[2]};
    }

    /// Calls add(node of one end, node of the other, id) for each edge of the rim, always in ascending direction.
    template <typename Add>
    void for_rim(const GeneratedSurface &s, const Add &add)
    {
      for (unsigned int j = 0; j < s.n_chord; ++j)
        {
          add(s.node(0, j), s.node(0, j + 1), 0);
          add(s.node(s.n_span, j), s.node(s.n_span, j + 1), 1);
        }
      for (unsigned int i = 0; i < s.n_span; ++i)
        {
          add(s.node(i, 0), s.node(i + 1, 0), s.is_halved ? 4 : 2);
          add(s.node(i, s.n_chord), s.node(i + 1, s.n_chord), 3);
        }
    }

    /// Adds to what describes one blade the others of the row.
    template <int dim, class Sides>
    void repeat(const MeshParameters::Row &row, std::vector<dealii::Point<3>> &vertices,
                std::vector<dealii::CellData<dim>> &cells, Sides &sides)
    {
      const auto n_vertices = static_cast<unsigned int>(vertices.size());
      const auto n_cells = cells.size(), n_sides = sides.size();
      const auto angles = row.angles();
      for (unsigned int blade = 1; blade < angles.size(); ++blade)
        {
          for (unsigned int v = 0; v < n_vertices; ++v)
            {
              const dealii::Point<3> &p = vertices[v];
              vertices.push_back(point(turn(row, angles[blade], Point3(p[0], p[1], p[2]))));
            }
          const auto add_copies = [&](auto &all, const std::size_t n) {
            for (std::size_t k = 0; k < n; ++k)
              {
                auto copy = all[k];
                for (unsigned int &vertex : copy.vertices)
                  vertex += blade * n_vertices;
                all.push_back(copy);
              }
          };
          add_copies(cells, n_cells);
          add_copies(sides, n_sides);
        }
    }

    dealii::CellData<2> face(const unsigned int a, const unsigned int b, const unsigned int c, const unsigned int d,
                             const unsigned int id)
    {
      dealii::CellData<2> quadrilateral;
      quadrilateral.vertices    = {a, b, c, d};
      quadrilateral.boundary_id = id;
      return quadrilateral;
    }
  } // namespace

  GeneratedSurface generate_surface(const MeshParameters &parameters, const bool is_halved)
  {
    return parameters.generator == MeshGenerator::blade ? twisted_blade(parameters, is_halved)
                                                        : flat_plate(parameters, is_halved);
  }

  Point3 turn(const MeshParameters::Row &row, const double angle, const Point3 &point)
  {
    const Point3 axis = Point3(row.axis.data()).normalized(), centre(row.centre.data());
    return centre + Eigen::AngleAxisd(angle, axis) * (point - centre);
  }

  void make_shell(const GeneratedSurface &s, const MeshParameters::Row &row, dealii::Triangulation<2, 3> &triangulation)
  {
    std::vector<dealii::Point<3>>    vertices;
    std::vector<dealii::CellData<2>> cells;
    dealii::SubCellData              rim;
    for (const Point3 &node : s.nodes)
      vertices.push_back(point(node));
    for (unsigned int i = 0; i < s.n_span; ++i)
      for (unsigned int j = 0; j < s.n_chord; ++j)
        {
          dealii::CellData<2> cell;
          cell.vertices    = {s.node(i, j), s.node(i + 1, j), s.node(i, j + 1), s.node(i + 1, j + 1)};
          cell.material_id = s.material_ids[i * s.n_chord + j];
          cells.push_back(cell);
        }
    for_rim(s, [&rim](const unsigned int a, const unsigned int b, const unsigned int id) {
      dealii::CellData<1> edge;
      edge.vertices    = {a, b};
      edge.boundary_id = id;
      rim.boundary_lines.push_back(edge);
    });
    repeat(row, vertices, cells, rim.boundary_lines);
    triangulation.create_triangulation(vertices, cells, rim);
  }

  std::vector<double> layer_heights(const unsigned int n_layers, const double grading)
  {
    std::vector<double> height(n_layers + 1, 0.);
    const double        ratio = n_layers > 2 ? std::pow(grading, 1. / ((n_layers - 1) / 2)) : 1.;
    const auto          share = [&](const unsigned int k) { return std::pow(ratio, std::min(k, n_layers - 1 - k)); };
    for (unsigned int k = 0; k < n_layers; ++k)
      height[k + 1] = height[k] + share(k);
    const double total = height[n_layers];
    for (unsigned int k = 0; k <= n_layers / 2; ++k)
      {
        height[k]            = height[k] / total - 0.5;
        height[n_layers - k] = -height[k];
      }
    if (n_layers % 2 == 0)
      height[n_layers / 2] = 0.;
    return height;
  }

  void make_solid(const GeneratedSurface &s, const std::vector<double> &heights,
                  const std::function<double(const Point3 &)> &thickness, const MeshParameters::Row &row,
                  dealii::Triangulation<3> &triangulation)
  {
    const unsigned int               m = heights.size(), n_layers = m - 1;
    std::vector<dealii::Point<3>>    vertices;
    std::vector<dealii::CellData<3>> cells;
    dealii::SubCellData              skin;
    for (std::size_t n = 0; n < s.nodes.size(); ++n)
      {
        const Point3 across = thickness(s.nodes[n]) * s.normals[n];
        for (const double height : heights)
          vertices.push_back(point(s.nodes[n] + height * across));
      }
    for (unsigned int i = 0; i < s.n_span; ++i)
      for (unsigned int j = 0; j < s.n_chord; ++j)
        {
          const unsigned int column[4] = {m * s.node(i, j), m * s.node(i + 1, j), m * s.node(i, j + 1),
                                          m * s.node(i + 1, j + 1)};
          for (unsigned int k = 0; k < n_layers; ++k)
            {
              dealii::CellData<3> cell;
              for (unsigned int v = 0; v < 8; ++v)
                cell.vertices[v] = column[v % 4] + k + v / 4;
              cell.material_id = s.material_ids[i * s.n_chord + j];
              cells.push_back(cell);
            }
          const unsigned int *c = column, top = n_layers;
          skin.boundary_quads.push_back(face(c[0], c[1], c[2], c[3], 5));
          skin.boundary_quads.push_back(face(c[0] + top, c[1] + top, c[2] + top, c[3] + top, 6));
        }
    for_rim(s, [&](const unsigned int a, const unsigned int b, const unsigned int id) {
      for (unsigned int k = 0; k < n_layers; ++k)
        skin.boundary_quads.push_back(face(m * a + k, m * b + k, m * a + k + 1, m * b + k + 1, id));
    });
    repeat(row, vertices, cells, skin.boundary_quads);
    triangulation.create_triangulation(vertices, cells, skin);
  }
} // namespace birdstrike
