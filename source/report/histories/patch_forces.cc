#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/report/patch_forces.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

namespace birdstrike
{
  namespace
  {
    const std::string entry = "Output/Histories/Patches";

    /// x y z radius, or xmin ymin zmin xmax ymax zmax.
    bool holds(const std::vector<double> &numbers, const Point3 &x)
    {
      if (numbers.size() == 4)
        return (x - Point3(numbers.data())).norm() <= numbers[3];
      for (unsigned int d = 0; d < 3; ++d)
        if (x[d] < numbers[d] || x[d] > numbers[3 + d])
          return false;
      return true;
    }

    std::vector<double> parse(const std::string &name, const std::string &text)
    {
      std::istringstream words(text);
      const auto         n = std::distance(std::istream_iterator<std::string>(words), {});
      const auto         numbers =
        parse_numbers(text, n == 4 ? 4 : 6, entry + ": '" + name + "' (x y z radius, or the corners of a box)");
      if (n == 4 && !(numbers[3] > 0.))
        throw InputError(entry + ": '" + name + ": " + text + "' has no radius above 0.\nGive 'x y z radius' in m.");
      if (name.find_first_of(" ,./\t") != std::string::npos)
        throw InputError(entry + ": the name '" + name +
                         "' holds a blank, a comma, a dot or a slash.\nNames become parts of columns.");
      return numbers;
    }

    /// Of a half: whether the patch is its own image; else it must lie on the side that is computed.
    bool is_on_plane(const std::string &name, const std::vector<double> &numbers)
    {
      const bool   is_ball = numbers.size() == 4;
      const double low     = is_ball ? numbers[1] - numbers[3] : numbers[1],
                   high    = is_ball ? numbers[1] + numbers[3] : numbers[4];
      if (low == -high)
        return true;
      if (low < 0.)
        throw InputError(entry + ": '" + name +
                         "' reaches across the plane y = 0, unequally.\nWith Case/Symmetry plane = y give a patch that "
                         "is its own mirror image, or one in y >= 0.");
      return false;
    }

    std::array<Point3, 4> corners(const double *position, const std::array<std::uint32_t, 4> &nodes)
    {
      std::array<Point3, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        x[k] = Point3(position + 3 * nodes[k]);
      return x;
    }

    /// |cos| to the axis below which a facet of bricks is of the rim.
    constexpr double rim_cosine = 0.5;
  } // namespace

  PatchForces::PatchForces(const std::string &requests, const FacetsView &surface,
                           const std::vector<std::uint32_t> &blades, const std::vector<unsigned int> &places)
    : position(surface.position)
  {
    name = "patches";
    std::set<std::string> taken;
    for (const auto &[patch, text] : parse_pairs(requests, entry))
      if (!taken.insert(patch).second)
        throw InputError(entry + " has the name '" + patch + "' twice.\nGive each patch a name of its own.");
      else
        {
          const std::vector<double> numbers = parse(patch, text);
          add(
            patch, surface, [&](std::size_t, const Point3 &middle) { return holds(numbers, middle); },
            [&](const Point3 &x) { return holds(numbers, x); });
          patches.back().plane = SymmetryPlane(surface.plane.exists() && is_on_plane(patch, numbers));
        }
    for (unsigned int place = 1; place <= places.size(); ++place)
      {
        const std::string blade = "blade_" + std::to_string(place);
        if (taken.contains(blade))
          throw InputError(entry + " has the name '" + blade +
                           "', which a blade of the row has.\nGive it another one.");
        const auto k = static_cast<std::uint32_t>(std::ranges::find(places, place) - places.begin());
        add(blade, surface, [&](const std::size_t facet, const Point3 &) { return blades[facet] == k; });
      }
  }

  template <class Holds>
  void PatchForces::add(const std::string &patch_name, const FacetsView &surface, const Holds &holds,
                        const std::function<bool(const Point3 &)> &inside)
  {
    Patch                                     patch;
    std::vector<std::array<std::uint32_t, 4>> held;
    std::vector<double> all(surface.n_nodes, 0.), here(surface.n_nodes, 0.); // area of the facets of each node
    for (std::size_t f = 0; f < surface.n_facets; ++f)
      {
        const auto  &nodes   = surface.nodes[f];
        const auto   x       = corners(position, nodes);
        const double area    = compute_area_vector(x).norm();
        const bool   is_here = holds(f, 0.25 * (x[0] + x[1] + x[2] + x[3]));
        for (const std::uint32_t n : nodes)
          {
            all[n] += area;
            here[n] += is_here ? area : 0.;
          }
        if (is_here)
          held.push_back(nodes);
      }
    if (held.empty())
      throw InputError(entry + ": '" + patch_name +
                       "' holds the centre of no facet of the blade.\nGive a place on its surface, or a larger patch.");
    std::vector<std::uint32_t> place(surface.n_nodes, 0);
    for (std::uint32_t n = 0; n < surface.n_nodes; ++n)
      if (here[n] > 0.)
        {
          place[n] = static_cast<std::uint32_t>(patch.nodes.size());
          patch.nodes.push_back({n, here[n] / all[n], surface.plane.exists() && position[3 * n + 1] == 0.});
        }
      else if (all[n] == 0. && inside && inside(Point3(position + 3 * n)))
        patch.nodes.push_back({n, 1., surface.plane.exists() && position[3 * n + 1] == 0.});
    for (const auto &nodes : held)
      patch.facets.push_back({{place[nodes[0]], place[nodes[1]], place[nodes[2]], place[nodes[3]]}, 1.});
    if (!surface.two_sided)
      find_sides(patch);
    patch.forces.assign(3 * patch.nodes.size(), 0.);
    add_columns(patch_name, held.size());
    patches.push_back(std::move(patch));
  }

  void PatchForces::add_columns(const std::string &patch_name, const std::size_t n_facets)
  {
    const std::string what       = " on the " + std::to_string(n_facets) + " facets of this patch";
    const auto        add_vector = [&](const char *quantity, const char *unit, const std::string &words) {
      for (const char *axis : {"x", "y", "z"})
        columns.push_back({patch_name + "." + quantity + "_" + axis, unit, words + what + ", global axes"});
    };
    add_vector("F", "N", "Contact force");
    columns.push_back({patch_name + ".F_peak", "N", "Largest norm of the contact force since the row before" + what});
    columns.push_back({patch_name + ".pressure", "Pa",
                       "Mean contact pressure" + what +
                         ": forces along the normals of its nodes, over the area of one side; where both sides are "
                         "struck, by how much one exceeds the other"});
    add_vector("impulse", "N s", "Time integral of the contact force");
  }

  Point3 PatchForces::area_vector(const Patch &patch, const Facet &facet) const
  {
    std::array<std::uint32_t, 4> nodes;
    for (unsigned int k = 0; k < 4; ++k)
      nodes[k] = patch.nodes[facet.places[k]].node;
    return compute_area_vector(corners(position, nodes));
  }

  void PatchForces::find_sides(Patch &patch) const
  {
    Eigen::Matrix3d faced = Eigen::Matrix3d::Zero(); // sum of A n (x) n, blind to which way n looks
    for (const Facet &facet : patch.facets)
      {
        const Point3 area = area_vector(patch, facet);
        faced += area * area.transpose() / std::max(area.norm(), std::numeric_limits<double>::min());
      }
    const Point3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(faced).eigenvectors().col(2); // the largest
    for (Facet &facet : patch.facets)
      {
        const Point3 area   = area_vector(patch, facet);
        const double cosine = area.dot(axis) / std::max(area.norm(), std::numeric_limits<double>::min());
        facet.side          = std::abs(cosine) < rim_cosine ? 0. : std::copysign(1., cosine);
      }
  }

  double PatchForces::pressure(const Patch &patch) const
  {
    std::vector<Point3>   normals(patch.nodes.size(), Point3::Zero());
    std::array<double, 2> area{}; // of each side
    for (const Facet &facet : patch.facets)
      if (facet.side != 0.)
        {
          const Point3 of_facet = area_vector(patch, facet);
          area[facet.side < 0.] += of_facet.norm();
          for (const std::uint32_t place : facet.places)
            normals[place] += facet.side * of_facet;
        }
    double sum = 0.; // of a half over its area: with the image's both are twice as much
    for (std::size_t k = 0; k < normals.size(); ++k)
      {
        if (patch.plane.exists() && patch.nodes[k].is_on_plane)
          normals[k][1] = 0.;
        if (const double length = normals[k].norm(); length > 0.)
          sum += normals[k].dot(Point3(&patch.forces[3 * k])) / length;
      }
    const double larger = std::max(area[0], area[1]);
    return larger > 0. ? std::abs(sum) / larger : 0.;
  }

  void PatchForces::update(const NodeForces &forces, const double step)
  {
    for (Patch &patch : patches)
      {
        Point3  force = Point3::Zero();
        double *next  = patch.forces.data();
        for (const Weighted &one : patch.nodes)
          {
            const Point3 share = one.weight * Point3(forces.of(one.node));
            force += share;
            next = std::copy_n(share.data(), 3, next);
          }
        if (patch.plane.exists())
          force = Point3(2. * force[0], 0., 2. * force[2]);
        if (!is_first)
          patch.impulse += 0.5 * step * (patch.force + force);
        patch.force = force;
        patch.peak  = std::max(patch.peak, force.norm());
      }
    is_first = false;
  }

  void PatchForces::start_row()
  {
    for (Patch &patch : patches)
      patch.peak = 0.;
  }

  void PatchForces::fill(const std::span<double> row) const
  {
    double *next = row.data();
    for (const Patch &patch : patches)
      {
        next    = std::copy_n(patch.force.data(), 3, next);
        *next++ = patch.peak;
        *next++ = pressure(patch);
        next    = std::copy_n(patch.impulse.data(), 3, next);
      }
  }

  void PatchForces::archive(Archive &archive)
  {
    const auto          group = archive.group("patches");
    std::vector<double> state;
    for (Patch &patch : patches)
      {
        state.insert(state.end(), patch.force.data(), patch.force.data() + 3);
        state.insert(state.end(), patch.impulse.data(), patch.impulse.data() + 3);
        state.push_back(patch.peak);
      }
    archive.list("forces, impulses and peaks", state);
    archive("is first", is_first);
    archive.entities("each", patches.size(),
                     [&](Archive::Row &row, const std::size_t p) { row.list("forces of nodes", patches[p].forces); });
    const double *next = state.data();
    for (Patch &patch : patches)
      {
        patch.force   = Point3(next);
        patch.impulse = Point3(next + 3);
        patch.peak    = next[6];
        next += 7;
      }
  }
} // namespace birdstrike
