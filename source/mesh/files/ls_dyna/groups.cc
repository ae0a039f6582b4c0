#include "mesh/files/ls_dyna/groups.h"

namespace birdstrike
{
  std::size_t LsDynaGroups::operator()(const std::string &kind, const Id number)
  {
    const auto [found, is_new] = places.try_emplace({kind, number}, mesh.groups.size());
    if (is_new)
      {
        if (number < 0 || number > ImportedMesh::largest_number)
          cards.lines.refuse("a " + kind + " has the id " + std::to_string(number),
                             "Allowed: up to " + std::to_string(ImportedMesh::largest_number) + ".");
        ImportedMesh::Group &group = mesh.groups.emplace_back();
        group.name                 = kind + "_" + std::to_string(number);
        if (kind == "part")
          group.material_number = static_cast<unsigned int>(number);
        if (kind == "node_set")
          group.boundary_number = static_cast<unsigned int>(number);
      }
    return found->second;
  }

  std::optional<std::size_t> LsDynaGroups::find(const std::string &kind, const Id number) const
  {
    const auto found = places.find({kind, number});
    return found != places.end() ? std::optional(found->second) : std::nullopt;
  }

  std::vector<ImportedMesh::Id> LsDynaGroups::numbers(const std::string &kind) const
  {
    std::vector<Id> all;
    for (auto place = places.lower_bound({kind, 0}); place != places.end() && place->first.first == kind; ++place)
      all.push_back(place->first.second);
    return all;
  }

  void LsDynaGroups::give_title(const std::size_t group, const std::string &title)
  {
    ImportedMesh::Group &titled = mesh.groups[group];
    if (title.empty() || !titled.other_names.empty())
      return;
    titled.other_names = {titled.name};
    titled.name        = title;
  }
} // namespace birdstrike
