#include "structure/histories/watched_blade.h"
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <Eigen/LU>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    template <int dim>
    double longest_edge(const CellMesh<dim> &mesh, const std::size_t cell)
    {
      double longest = 0.;
      for (unsigned int side = 0; side < 2 * dim; ++side)
        {
          const auto nodes = mesh.side_nodes(cell, side);
          for (std::size_t k = 0; k < nodes.size(); ++k)
            longest = std::max(longest, (mesh.node(nodes[k]) - mesh.node(nodes[(k + 1) % nodes.size()])).norm());
        }
      return longest;
    }

    /// The place of a number in a list; `labels`: the numbers where these are not the places themselves.
    std::uint32_t find_number(const std::uint32_t number, const std::vector<std::int64_t> &labels, const std::size_t n,
                              const std::string &noun, const std::string &name, const std::string &entry)
    {
      const auto        found = std::ranges::find(labels, static_cast<std::int64_t>(number));
      const std::size_t place = labels.empty() ? number : static_cast<std::size_t>(found - labels.begin());
      if (place >= n)
        throw InputError(fmt::format("{}: '{}' is {} {}, and {}.\nField '{}' of blade.pvd shows the numbers.", entry,
                                     name, noun, number,
                                     labels.empty() ? fmt::format("the mesh has {}, 0 to {}", n, n - 1)
                                                    : "the file of the mesh has none of this number",
                                     noun));
      return static_cast<std::uint32_t>(place);
    }

    /// From corner to corner of the box around the mesh, m.
    template <int dim>
    double extent_of(const CellMesh<dim> &mesh)
    {
      Point3 low = mesh.node(0), high = low;
      for (std::size_t n = 1; n < mesh.nodes.size(); ++n)
        {
          low  = low.cwiseMin(mesh.node(n));
          high = high.cwiseMax(mesh.node(n));
        }
      return (high - low).norm();
    }

    /// Of a place and the nearest that was found, m, where elements have this size.
    template <int dim>
    void judge_distance(const CellMesh<dim> &mesh, const Place &place, const std::string &found, const double distance,
                        const double size, const std::string &entry, Warnings &warnings)
    {
      if (!(distance > size))
        return;
      const double      extent = extent_of(mesh);
      const std::string where  = fmt::format("{}: '{}' at {} is {:.4g} mm from the nearest, {}", entry, place.name,
                                             text_of(place.point), 1e3 * distance, found);
      if (distance > farthest_place * extent)
        throw InputError(fmt::format("{}: farther than {:g} of the blade's size ({:.4g} m from corner to corner of its "
                                     "box).\nGive a place on the blade before the strike, in m.",
                                     where, farthest_place, extent));
      warnings.push_back({"history/far_from_mesh",
                          fmt::format("{}: farther than the elements there are long ({:.3g} mm).", where, 1e3 * size)});
    }

    double distance_to(const CellMesh<2> &mesh, const std::size_t cell, const Point3 &point)
    {
      std::array<Point3, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners[k] = mesh.node(mesh.cells[cell][k]);
      return std::sqrt(compute_closest_point(point, corners).distance_squared);
    }

    /// By the map linearised at its middle: exact in parallelepipeds.
    double distance_to(const CellMesh<3> &mesh, const std::size_t cell, const Point3 &point)
    {
      Matrix3<double> half; // half the mean edges
      half.setZero();
      for (unsigned int c = 0; c < 8; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          half.col(d) += (c >> d & 1u ? 0.125 : -0.125) * mesh.node(mesh.cells[cell][c]);
      Point3 xi = half.inverse() * (point - mesh.centroid(cell));
      for (unsigned int d = 0; d < 3; ++d)
        xi[d] -= std::clamp(xi[d], -1., 1.);
      return (half * xi).norm();
    }
  } // namespace

  template <int dim>
  std::string describe_node(const CellMesh<dim> &mesh, const std::size_t node)
  {
    return fmt::format("node {} at {}", mesh.node_label(node), text_of(mesh.node(node)));
  }

  template <int dim>
  std::string describe_element(const CellMesh<dim> &mesh, const std::size_t element)
  {
    return fmt::format("element {} at {}", mesh.element_label(element), text_of(mesh.centroid(element)));
  }

  template <int dim>
  std::uint32_t find_node(const BladeMesh<dim> &mesh, const Place &place, const std::string &entry, Warnings &warnings)
  {
    if (place.number)
      return find_number(*place.number, mesh.file_node_ids, mesh.nodes.size(), "node", place.name, entry);
    const std::uint32_t node = mesh.nearest_node(place.point).value_or(0);
    double              size = 0.;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      if (std::find(mesh.cells[cell].begin(), mesh.cells[cell].end(), node) != mesh.cells[cell].end())
        size = std::max(size, longest_edge(mesh, cell));
    judge_distance(mesh, place, describe_node(mesh, node), (mesh.node(node) - place.point).norm(), size, entry,
                   warnings);
    return node;
  }

  template <int dim>
  Warnings warn_of_far_probes(const std::string &probes, const BladeMesh<dim> &mesh)
  {
    const std::string entry = "Blade/Probes";
    Warnings          warnings;
    for (const auto &[name, text] : parse_pairs(probes, entry))
      {
        const auto x = parse_numbers(text, 3, entry);
        find_node(mesh, {name, {}, Point3(x[0], x[1], x[2]), {}}, entry, warnings);
      }
    return warnings;
  }

  template <int dim>
  std::uint32_t find_element(const CellMesh<dim> &mesh, const Place &place, const std::string &entry,
                             Warnings &warnings)
  {
    if (place.number)
      return find_number(*place.number, mesh.file_element_ids, mesh.cells.size(), "element", place.name, entry);
    std::size_t nearest  = 0;
    double      distance = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      if (const double here = distance_to(mesh, cell, place.point); here < distance)
        {
          nearest  = cell;
          distance = here;
        }
    judge_distance(mesh, place, describe_element(mesh, nearest), distance, longest_edge(mesh, nearest), entry,
                   warnings);
    return static_cast<std::uint32_t>(nearest);
  }

  template std::string   describe_node(const CellMesh<2> &, std::size_t);
  template std::string   describe_node(const CellMesh<3> &, std::size_t);
  template std::string   describe_element(const CellMesh<2> &, std::size_t);
  template std::string   describe_element(const CellMesh<3> &, std::size_t);
  template std::uint32_t find_node(const BladeMesh<2> &, const Place &, const std::string &, Warnings &);
  template std::uint32_t find_node(const BladeMesh<3> &, const Place &, const std::string &, Warnings &);
  template Warnings      warn_of_far_probes(const std::string &, const BladeMesh<2> &);
  template Warnings      warn_of_far_probes(const std::string &, const BladeMesh<3> &);
  template std::uint32_t find_element(const CellMesh<2> &, const Place &, const std::string &, Warnings &);
  template std::uint32_t find_element(const CellMesh<3> &, const Place &, const std::string &, Warnings &);
} // namespace birdstrike
