#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/report/patch_forces.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

    Point3 area_vector(const double *position, const std::array<std::uint32_t, 4> &nodes)
    {
      const auto x = [&](const unsigned int k) { return Point3(position + 3 * nodes[k]); };
      return 0.5 * (x(2) - x(0)).cross(x(3) - x(1));
    }
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
          add(patch, surface, [&](std::size_t, const Point3 &middle) { return holds(numbers, middle); });
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
  void PatchForces::add(const std::string &patch_name, const FacetsView &surface, const Holds &holds)
  {
    Patch               patch;
    std::vector<double> all(surface.n_nodes, 0.), here(surface.n_nodes, 0.); // area of the facets of each node
    for (std::size_t f = 0; f < surface.n_facets; ++f)
      {
        const auto  &nodes  = surface.nodes[f];
        const double area   = area_vector(position, nodes).norm();
        Point3       middle = Point3::Zero();
        for (const std::uint32_t n : nodes)
          middle += 0.25 * Point3(position + 3 * n);
        const bool is_here = holds(f, middle);
        for (const std::uint32_t n : nodes)
          {
            all[n] += area;
            here[n] += is_here ? area : 0.;
          }
        if (is_here)
          patch.facets.push_back(nodes);
      }
    if (patch.facets.empty())
      throw InputError(entry + ": '" + patch_name +
                       "' holds the centre of no facet of the blade.\nGive a place on its surface, or a larger patch.");
    for (std::uint32_t n = 0; n < surface.n_nodes; ++n)
      if (here[n] > 0.)
        patch.nodes.push_back({n, here[n] / all[n]});
    const std::string what       = " on the " + std::to_string(patch.facets.size()) + " facets of this patch";
    const auto        add_vector = [&](const char *quantity, const char *unit, const std::string &words) {
      for (const char *axis : {"x", "y", "z"})
        columns.push_back({patch_name + "." + quantity + "_" + axis, unit, words + what + ", global axes"});
    };
    add_vector("F", "N", "Contact force");
    columns.push_back({patch_name + ".F_peak", "N", "Largest norm of the contact force since the row before" + what});
    columns.push_back(
      {patch_name + ".pressure", "Pa", "Mean contact pressure, force along the normal over area," + what});
    add_vector("impulse", "N s", "Time integral of the contact force");
    patches.push_back(std::move(patch));
  }

  void PatchForces::update(const NodeForces &forces, const double step)
  {
    for (Patch &patch : patches)
      {
        Point3 force = Point3::Zero();
        for (const Weighted &one : patch.nodes)
          force += one.weight * Point3(forces.of(one.node));
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
        Point3 normal = Point3::Zero();
        double area   = 0.;
        for (const auto &nodes : patch.facets)
          {
            const Point3 of_facet = area_vector(position, nodes);
            normal += of_facet;
            area += of_facet.norm();
          }
        if (patch.plane.exists()) // of the whole
          normal[1] = 0.;
        const double size = patch.plane.whole(area), length = normal.norm();
        next    = std::copy_n(patch.force.data(), 3, next);
        *next++ = patch.peak;
        *next++ = length > 0. ? std::abs(patch.force.dot(normal.normalized())) / size : 0.;
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
