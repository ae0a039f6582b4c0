#include "structure/nodes/supports.h"
#include <birdstrike/core/text_lists.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace birdstrike
{
  namespace
  {
    /// Of a set of n nodes, of which these lie off its sides and are free.
    template <class Mesh>
    std::string describe_partly_held(const std::string &entry, const std::string &name, const std::size_t n,
                                     const std::vector<std::uint32_t> &free, const Mesh &mesh)
    {
      Point3 low = mesh.node(free.front()), high = low;
      for (const std::uint32_t node : free)
        {
          low  = low.cwiseMin(mesh.node(node));
          high = high.cwiseMax(mesh.node(node));
        }
      return fmt::format("Blade/Supports/{0} = {1}: {2} of the {3} nodes of the set '{1}' are constrained, {4} stay "
                         "free (one is node {5}). A name selects the sides whose nodes all belong to it, no single "
                         "nodes and none inside. To constrain these as well, set Blade/Supports/Held boxes = {6:.10g} "
                         "{7:.10g} {8:.10g} {9:.10g} {10:.10g} {11:.10g}: clamped.",
                         entry, name, n - free.size(), n, free.size(), mesh.node_label(free.front()), low[0], low[1],
                         low[2], high[0], high[1], high[2]);
    }
  } // namespace

  template <class Mesh>
  void Supports::warn_of_whole_rim(const Mesh &mesh)
  {
    const auto is_clamped = [&](const unsigned int id) {
      return std::ranges::find(clamped_ids, id) != clamped_ids.end();
    };
    if (!mesh.file_node_ids.empty() && is_clamped(0) && !mesh.boundary_names.names(0) && !mesh.boundary.empty() &&
        std::ranges::all_of(mesh.boundary, [&](const auto &side) { return is_clamped(side.id); }))
      warnings.push_back(
        {"blade/whole_rim_held",
         fmt::format("Blade/Supports/Clamped = 0 constrains all sides of the mesh without a name: here the whole "
                     "boundary, {} nodes. Name the root in the file if that is not meant.",
                     mesh.nodes_on(clamped_ids).size())});
  }

  template <unsigned int n_unknowns, class Mesh>
  void Supports::warn_of_nodes_off_sides(const BladeParameters::Supports &parameters, const Mesh &mesh)
  {
    std::unordered_map<std::int64_t, std::uint32_t> node_of;
    const auto                                      is_free = [&](const std::uint32_t node) {
      for (std::uint32_t c = 0; c < 3; ++c)
        if (!std::ranges::binary_search(held_dofs, n_unknowns * node + c))
          return true;
      return false;
    };
    const auto look_at = [&](const std::string &entry, const std::string &names) {
      for (const std::string &name : parse_words(names))
        {
          const NamedIds::Nodes *const set = mesh.boundary_names.nodes_of(name);
          if (set == nullptr || set->off_sides.empty())
            continue;
          for (std::uint32_t n = 0; n < mesh.file_node_ids.size() && node_of.size() < mesh.nodes.size(); ++n)
            node_of.emplace(mesh.file_node_ids[n], n);
          std::vector<std::uint32_t> free;
          for (const std::int64_t id : set->off_sides)
            if (const auto found = node_of.find(id); found != node_of.end() && is_free(found->second))
              free.push_back(found->second);
          if (!free.empty())
            warnings.push_back({"blade/set_partly_held", describe_partly_held(entry, name, set->n, free, mesh)});
        }
    };
    look_at("Clamped", parameters.clamped);
    look_at("Hub", parameters.hub);
    for (const auto &[key, components] : parse_pairs(parameters.held, "Blade/Supports/Held"))
      look_at("Held", key);
    for (const auto &[key, text] : parse_pairs(parameters.driven, "Blade/Supports/Driven"))
      look_at("Driven", key);
  }

  template void Supports::warn_of_whole_rim(const SurfaceMesh &);
  template void Supports::warn_of_whole_rim(const VolumeMesh &);
  template void Supports::warn_of_nodes_off_sides<6>(const BladeParameters::Supports &, const SurfaceMesh &);
  template void Supports::warn_of_nodes_off_sides<3>(const BladeParameters::Supports &, const VolumeMesh &);
} // namespace birdstrike
