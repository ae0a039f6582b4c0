#include "structure/nodes/supports.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace birdstrike
{
  namespace
  {
    template <class Mesh>
    std::string ids_of(const Mesh &mesh)
    {
      std::string known;
      for (const unsigned int id : mesh.boundary_ids)
        known += (known.empty() ? "" : ", ") + std::to_string(id);
      return known;
    }

    /// Boundary ids of an entry, which the mesh must have.
    template <class Mesh>
    std::vector<unsigned int> require_ids(const std::string &text, const Mesh &mesh, const std::string &entry)
    {
      const auto ids = mesh.boundary_names.parse(text, "Blade/Supports/" + entry);
      for (const unsigned int id : ids)
        if (!mesh.has_boundary_id(id) &&
            std::find(mesh.mirrored_ids.begin(), mesh.mirrored_ids.end(), id) == mesh.mirrored_ids.end())
          throw InputError("Blade/Supports/" + entry + ": the mesh has no boundary id " + std::to_string(id) +
                           ".\nIds of this mesh: " + ids_of(mesh) + "; names: " + mesh.boundary_names.list() + ".");
      return ids;
    }

    template <class Mesh>
    bool is_from_file(const Mesh &mesh)
    {
      return !mesh.file_node_ids.empty();
    }

    /// What a user may write for Clamped.
    template <class Mesh>
    [[noreturn]] void ask_for_clamped(const Mesh &mesh)
    {
      std::size_t n_unnamed = 0;
      for (const auto &side : mesh.boundary)
        n_unnamed += side.id == 0 && !mesh.boundary_names.names(0);
      throw InputError(
        "Blade/Supports/Clamped is not given: a mesh from a file has no root of its own.\nNames in this mesh: " +
        mesh.boundary_names.list() + "; ids: " + ids_of(mesh) + ". Set Clamped or Hub to those of the root" +
        (n_unnamed == 0
           ? std::string()
           : fmt::format(", to 0 to constrain all {} sides without a name ({} of the whole boundary)", n_unnamed,
                         n_unnamed == mesh.boundary.size() ? "all" : std::to_string(mesh.boundary.size()))) +
        ", or leave Clamped empty (Clamped =) for no constraint.");
    }

    template <class Mesh>
    std::vector<unsigned int> find_clamped(const BladeParameters::Supports &parameters, const Mesh &mesh)
    {
      if (parameters.clamped != parameters.automatic)
        return require_ids(parameters.clamped, mesh, "Clamped");
      if (!is_from_file(mesh))
        return require_ids("0", mesh, "Clamped");
      if (!is_present(parameters.hub))
        ask_for_clamped(mesh);
      return {};
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

    /// Whether some face of a solid has all of its nodes among these, sorted.
    bool holds_a_face(const SurfaceMesh &, const std::vector<std::uint32_t> &)
    {
      return false;
    }
    bool holds_a_face(const VolumeMesh &mesh, const std::vector<std::uint32_t> &nodes)
    {
      return std::ranges::any_of(mesh.boundary, [&](const auto &face) {
        return std::ranges::all_of(face.nodes,
                                   [&](const std::uint32_t n) { return std::ranges::binary_search(nodes, n); });
      });
    }

    /// Components of an entry; single rotations mean something on a shell only. `turns`: all, or none turn with a hub.
    template <unsigned int n_unknowns>
    std::array<bool, 6> read_components(const std::string &text, const std::string &entry, const bool turns = false)
    {
      const auto held     = parse_components(text, "Blade/" + entry);
      const bool has_some = held[3] || held[4] || held[5], has_all = held[3] && held[4] && held[5];
      if (n_unknowns == 3 && has_some && !(has_all && held[0] && held[1] && held[2]))
        throw InputError(
          "Blade/" + entry + ": '" + text +
          "' constrains rotations, which the nodes of a solid do not have.\nAllowed for a solid: ux uy uz, clamped or "
          "hinged (both all three). Constrained displacements in two layers of nodes constrain a rotation.");
      if (turns && std::count(held.begin(), held.begin() + n_unknowns, true) != n_unknowns)
        throw InputError("Blade/" + entry + ": '" + text +
                         "' constrains single components, which have no fixed direction on a rotating blade.\nAllowed "
                         "with Blade/Spin: clamped.");
      return held;
    }

    template <class Mesh>
    std::vector<std::uint32_t> nodes_of_blades(const Mesh &mesh, const std::vector<bool> &are_meant)
    {
      std::vector<std::uint32_t> nodes;
      for (std::size_t cell = 0; cell < mesh.cells.size() && !mesh.blades.empty() && !are_meant.empty(); ++cell)
        if (are_meant[mesh.blade_of(cell)])
          nodes.insert(nodes.end(), mesh.cells[cell].begin(), mesh.cells[cell].end());
      return nodes;
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

  Supports::Supports(const BladeParameters::Supports &parameters, const SurfaceMesh &mesh, const bool turns,
                     const std::vector<bool> &is_rigid)
  {
    find_roles(parameters, mesh);
    find_held<6>(parameters, mesh, turns, is_rigid);
  }

  Supports::Supports(const BladeParameters::Supports &parameters, const VolumeMesh &mesh, const bool turns,
                     const std::vector<bool> &is_rigid)
  {
    find_roles(parameters, mesh);
    find_held<3>(parameters, mesh, turns, is_rigid);
  }

  template <class Mesh>
  void Supports::find_roles(const BladeParameters::Supports &parameters, const Mesh &mesh)
  {
    clamped_ids = find_clamped(parameters, mesh);
    root_ids    = require_ids(parameters.hub, mesh, "Hub");
    clamped_ids.insert(clamped_ids.end(), root_ids.begin(), root_ids.end());
    if (root_ids.empty())
      root_ids = clamped_ids;
    for (const unsigned int id : require_ids(parameters.free, mesh, "Free"))
      if (std::ranges::find(clamped_ids, id) != clamped_ids.end())
        throw InputError(fmt::format("Blade/Supports/Free = {}: boundary {} is constrained by Clamped (of built-in "
                                     "parts by default 0) or Hub as well.\nTake it out of one of them.",
                                     parameters.free, id));
    // The default is the tip of the built-in parts. Where a file names its sides, 1 is the first that it names.
    const BladeParameters::Supports standard;
    const bool                      are_named = mesh.boundary_names.has_names() && !mesh.boundary_names.names(0);
    if (parameters.tip != standard.tip)
      tip_ids = require_ids(parameters.tip, mesh, "Tip");
    else if (!are_named) // a file need not have a tip
      for (const unsigned int id : mesh.boundary_names.parse(parameters.tip, "Blade/Supports/Tip"))
        if (mesh.has_boundary_id(id))
          tip_ids.push_back(id);
  }

  template <unsigned int n_unknowns, class Mesh>
  void Supports::find_held(const BladeParameters::Supports &parameters, const Mesh &mesh, const bool turns,
                           const std::vector<bool> &is_rigid)
  {
    constexpr std::array<bool, 6> all{{true, true, true, true, true, true}};
    HeldSet<n_unknowns>           held;
    const auto hold = [&](const std::vector<std::uint32_t> &nodes, const std::string &key, const std::string &text,
                          const std::string &entry) {
      const auto components = read_components<n_unknowns>(text, "Supports/" + entry, turns);
      held.add(nodes, components);
      if (components[0] && components[1] && components[2] && text.find("clamped") == std::string::npos &&
          holds_a_face(mesh, nodes))
        held_faces.push_back("Blade/Supports/" + entry + " = " + key + ": " + text);
    };
    held.add(mesh.nodes_on(clamped_ids), all);
    held.add(nodes_of_blades(mesh, is_rigid), all);
    // the mirror image at y = 0 has -u_y, -theta_x and -theta_z
    held.add(mesh.symmetry_nodes, {{false, true, false, true, false, true}});
    for (const auto &[key, components] : parse_pairs(parameters.held, "Blade/Supports/Held"))
      hold(mesh.nodes_on(require_ids(key, mesh, "Held")), key, components, "Held");
    for (const auto &[key, components] : parse_pairs(parameters.held_boxes, "Blade/Supports/Held boxes"))
      {
        const auto nodes = nodes_in_box(mesh, parse_numbers(key, 6, "Blade/Supports/Held boxes"));
        if (nodes.empty() && mesh.space.is_whole())
          throw InputError("Blade/Supports/Held boxes: no node lies in the box '" + key + "'.\n" +
                           "Order: xmin ymin zmin xmax ymax zmax, in metres.");
        hold(nodes, key, components, "Held boxes");
      }
    for (const auto &[key, text] : parse_pairs(parameters.driven, "Blade/Supports/Driven"))
      {
        const auto ids    = require_ids(key, mesh, "Driven");
        const auto equals = text.find('=');
        if (equals == std::string::npos)
          throw InputError("Blade/Supports/Driven: '" + text +
                           "' has no formula.\nAllowed: '3: uz = 1e-3*sin(600*t)'.");
        const auto components = read_components<n_unknowns>(text.substr(0, equals), "Supports/Driven");
        if (!mesh.symmetry_nodes.empty() && (components[1] || components[3] || components[5]))
          throw InputError(
            "Blade/Supports/Driven: '" + text +
            "' moves both halves of a symmetric blade to one side.\nAllowed with a plane of symmetry: ux, "
            "uz and ry.");
        const auto nodes = mesh.nodes_on(ids); // none where the mirror image has them all
        Driven     driven_here{
          held.add(nodes, components),
          std::make_shared<const TimeLaw>(dealii::Utilities::trim(text.substr(equals + 1)), "Supports/Driven")};
        if (driven_here.dofs.empty() && !nodes.empty())
          throw InputError("Blade/Supports/Driven: '" + key + ": " + text +
                           "' drives nothing: all its components are clamped, constrained or driven already.\nLet "
                           "Clamped, Hub and Held leave it free (Clamped = empty), and name each component once.");
        if (driven_here.at(0.) != 0.)
          throw InputError("Blade/Supports/Driven: '" + text +
                           "' is not 0 at t = 0.\nA displacement begins where the mesh is; subtract its first value.");
        driven.push_back(std::move(driven_here));
      }
    held_dofs = held.sorted();
    warn_of_whole_rim(mesh);
    warn_of_nodes_off_sides<n_unknowns>(parameters, mesh);
  }
} // namespace birdstrike
