#include "structure/nodes/supports.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <set>

namespace birdstrike
{
  namespace
  {
    template <class Mesh>
    void require_ids(const std::vector<unsigned int> &ids, const Mesh &mesh, const std::string &entry)
    {
      for (const unsigned int id : ids)
        if (!mesh.has_boundary_id(id) &&
            std::find(mesh.mirrored_ids.begin(), mesh.mirrored_ids.end(), id) == mesh.mirrored_ids.end())
          {
            std::string known;
            for (const unsigned int other : mesh.boundary_ids)
              known += (known.empty() ? "" : ", ") + std::to_string(other);
            throw InputError("Blade/Supports/" + entry + ": the mesh has no boundary id " + std::to_string(id) +
                             ".\nIds of this mesh: " + known + ".");
          }
    }

    template <unsigned int n_unknowns>
    class HeldSet
    {
    public:
      /// Returns those that are new.
      std::vector<std::uint32_t> add(const std::vector<std::uint32_t> &nodes, const std::array<bool, 6> &components)
      {
        std::vector<std::uint32_t> added;
        for (const std::uint32_t n : nodes)
          for (unsigned int c = 0; c < n_unknowns; ++c)
            if (components[c] && dofs.insert(n_unknowns * n + c).second)
              added.push_back(n_unknowns * n + c);
        return added;
      }
      std::vector<std::uint32_t> sorted() const
      {
        return {dofs.begin(), dofs.end()};
      }

    private:
      std::set<std::uint32_t> dofs;
    };

    /// Components of an entry; single rotations mean something on a shell only.
    template <unsigned int n_unknowns>
    std::array<bool, 6> read_components(const std::string &text, const std::string &entry)
    {
      const auto held     = parse_components(text, "Blade/" + entry);
      const bool has_some = held[3] || held[4] || held[5], has_all = held[3] && held[4] && held[5];
      if (n_unknowns == 3 && has_some && !(has_all && held[0] && held[1] && held[2]))
        throw InputError("Blade/" + entry + ": '" + text +
                         "' holds rotations, which the nodes of a solid do not have.\n"
                         "Allowed for a solid: ux uy uz, clamped or hinged (both all three). Two layers of held "
                         "displacements hold a rotation.");
      return held;
    }

    template <class Mesh>
    std::vector<std::uint32_t> nodes_in_box(const Mesh &mesh, const std::vector<double> &box)
    {
      // Coordinates of generated meshes carry round-off: a box that ends on a node includes it.
      const double               margin = 1e-9;
      std::vector<std::uint32_t> nodes;
      for (std::uint32_t n = 0; n < mesh.space.n_owned(); ++n)
        {
          bool is_inside = true;
          for (unsigned int d = 0; d < 3; ++d)
            is_inside = is_inside && mesh.nodes[n][d] >= box[d] - margin && mesh.nodes[n][d] <= box[3 + d] + margin;
          if (is_inside)
            nodes.push_back(n);
        }
      return nodes;
    }
  } // namespace

  Supports::Supports(const BladeParameters::Supports &parameters, const SurfaceMesh &mesh)
  {
    find_roles(parameters, mesh);
    find_held<6>(parameters, mesh);
  }

  Supports::Supports(const BladeParameters::Supports &parameters, const VolumeMesh &mesh)
  {
    find_roles(parameters, mesh);
    find_held<3>(parameters, mesh);
  }

  template <class Mesh>
  void Supports::find_roles(const BladeParameters::Supports &parameters, const Mesh &mesh)
  {
    const auto clamped = parse_ids(parameters.clamped, "Blade/Supports/Clamped");
    const auto hub     = parse_ids(parameters.hub, "Blade/Supports/Hub");
    require_ids(clamped, mesh, "Clamped");
    require_ids(hub, mesh, "Hub");
    require_ids(parse_ids(parameters.free, "Blade/Supports/Free"), mesh, "Free");
    // The default names the tip of the built-in plate, which a file need not have.
    if (parameters.tip != BladeParameters::Supports().tip)
      require_ids(parse_ids(parameters.tip, "Blade/Supports/Tip"), mesh, "Tip");
    root_ids = hub.empty() ? clamped : hub;
    for (const unsigned int id : parse_ids(parameters.tip, "Blade/Supports/Tip"))
      if (mesh.has_boundary_id(id))
        tip_ids.push_back(id);
  }

  template <unsigned int n_unknowns, class Mesh>
  void Supports::find_held(const BladeParameters::Supports &parameters, const Mesh &mesh)
  {
    constexpr std::array<bool, 6> all{{true, true, true, true, true, true}};
    HeldSet<n_unknowns>           held;
    held.add(mesh.nodes_on(parse_ids(parameters.clamped, "Blade/Supports/Clamped")), all);
    held.add(mesh.nodes_on(parse_ids(parameters.hub, "Blade/Supports/Hub")), all);
    // the mirror image at y = 0 has -u_y, -theta_x and -theta_z
    held.add(mesh.symmetry_nodes, {{false, true, false, true, false, true}});
    for (const auto &[key, components] : parse_pairs(parameters.held, "Blade/Supports/Held"))
      {
        const auto ids = parse_ids(key, "Blade/Supports/Held");
        require_ids(ids, mesh, "Held");
        held.add(mesh.nodes_on(ids), read_components<n_unknowns>(components, "Supports/Held"));
      }
    for (const auto &[key, components] : parse_pairs(parameters.held_boxes, "Blade/Supports/Held boxes"))
      {
        const auto nodes = nodes_in_box(mesh, parse_numbers(key, 6, "Blade/Supports/Held boxes"));
        if (nodes.empty() && mesh.space.is_whole())
          throw InputError("Blade/Supports/Held boxes: no node lies in the box '" + key + "'.\n" +
                           "Order: xmin ymin zmin xmax ymax zmax, in metres.");
        held.add(nodes, read_components<n_unknowns>(components, "Supports/Held boxes"));
      }
    for (const auto &[key, text] : parse_pairs(parameters.driven, "Blade/Supports/Driven"))
      {
        const auto ids    = parse_ids(key, "Blade/Supports/Driven");
        const auto equals = text.find('=');
        require_ids(ids, mesh, "Driven");
        if (equals == std::string::npos)
          throw InputError("Blade/Supports/Driven: '" + text +
                           "' has no formula.\nAllowed: '3: uz = 1e-3*sin(600*t)'.");
        const auto components = read_components<n_unknowns>(text.substr(0, equals), "Supports/Driven");
        if (!mesh.symmetry_nodes.empty() && (components[1] || components[3] || components[5]))
          throw InputError(
            "Blade/Supports/Driven: '" + text +
            "' moves both halves of a symmetric blade to one side.\nAllowed with a plane of symmetry: ux, "
            "uz and ry.");
        Driven driven_here{held.add(mesh.nodes_on(ids), components),
                           std::make_shared<const Expression>(text.substr(equals + 1), 1, "Supports/Driven")};
        if (driven_here.at(0.) != 0.)
          throw InputError("Blade/Supports/Driven: '" + text +
                           "' is not 0 at t = 0.\nA displacement begins where the mesh is; subtract its first value.");
        driven.push_back(std::move(driven_here));
      }
    held_dofs = held.sorted();
  }
} // namespace birdstrike
