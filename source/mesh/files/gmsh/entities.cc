#include "mesh/files/gmsh/entities.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    /// Numbers of a box; of points in format 4.1 of a place.
    std::size_t n_places(const unsigned int dim, const bool is_4_1)
    {
      return dim == 0 && is_4_1 ? 3 : 6;
    }
  } // namespace

  std::array<Id, 4> GmshEntities::take_counts(const std::string &section)
  {
    const auto        head = lines.take(4, section, 4);
    std::array<Id, 4> n{};
    std::transform(head.begin(), head.end(), n.begin(), [this](const auto field) { return lines.count(field); });
    return n;
  }

  std::vector<Id> GmshEntities::groups_from(const std::vector<std::string_view> &fields, const std::size_t at) const
  {
    const Id n = at < fields.size() ? lines.count(fields[at]) : 0;
    if (at >= fields.size() || n > static_cast<Id>(fields.size() - at - 1))
      lines.refuse("an entity has fewer physical groups than its " + std::to_string(n), "Save the mesh again.");
    std::vector<Id> groups;
    for (Id g = 1; g <= n; ++g)
      groups.push_back(lines.group_number(fields[at + static_cast<std::size_t>(g)]));
    return groups;
  }

  /// Tag, box, number of groups, groups.
  void GmshEntities::read(const bool is_4_1)
  {
    const auto n = take_counts("$Entities");
    for (unsigned int dim = 0; dim < 4; ++dim)
      for (Id k = 0; k < n[dim]; ++k)
        {
          const std::size_t before = 1 + n_places(dim, is_4_1);
          const auto        fields = lines.take(before + 1, "$Entities");
          const Id          tag    = lines.integer(fields[0]);
          all[{dim, tag}]          = {groups_from(fields, before), tag};
        }
  }

  /// Tag, dimension and tag of the parent, number of parts, parts, box, number of groups, groups.
  void GmshEntities::read_partitioned(const bool is_4_1)
  {
    n_parts = static_cast<std::size_t>(lines.count(lines.take(1, "$PartitionedEntities", 1)[0]));
    for (Id n_ghosts = lines.count(lines.take(1, "$PartitionedEntities", 1)[0]); n_ghosts > 0; --n_ghosts)
      lines.take(2, "$PartitionedEntities", 2);
    const auto n = take_counts("$PartitionedEntities");
    for (unsigned int dim = 0; dim < 4; ++dim)
      for (Id k = 0; k < n[dim]; ++k)
        {
          const auto fields = lines.take(4, "$PartitionedEntities");
          const Id   own    = lines.count(fields[3]);
          if (own > static_cast<Id>(fields.size()) - 4)
            lines.refuse("an entity lies in fewer parts than its " + std::to_string(own), "Save the mesh again.");
          const auto n_own     = static_cast<std::size_t>(own);
          const bool is_of_dim = lines.integer(fields[1]) == static_cast<Id>(dim);
          const auto groups    = groups_from(fields, 4 + n_own + n_places(dim, is_4_1));
          Entity    &entity    = all[{dim, lines.integer(fields[0])}];
          entity               = is_of_dim ? Entity{groups, lines.integer(fields[2])} : Entity{};
          for (std::size_t p = 0; p < n_own; ++p)
            entity.partitions.insert(lines.integer(fields[4 + p]));
        }
  }

  GmshEntities::Entity GmshEntities::find(const unsigned int dim, const Id tag) const
  {
    const auto found = all.find({dim, tag});
    return found != all.end() ? found->second : Entity{{}, tag};
  }
} // namespace birdstrike
