#pragma once

#include "mesh/files/imported_mesh.h"

#include <algorithm>
#include <map>
#include <set>

namespace birdstrike
{
  /// Ids for cells or sides by the groups of a file that they lie in; see make_triangulation.
  class Combinations
  {
  public:
    using Group  = ImportedMesh::Group;
    using Groups = std::vector<std::uint32_t>; ///< sorted places
    using Number = std::optional<unsigned int> ImportedMesh::Group::*;
    Combinations(const std::vector<Group> &groups, const Number number, const std::set<Groups> &occurring)
    {
      std::vector<Groups> order(occurring.begin(), occurring.end());
      std::stable_sort(order.begin(), order.end(),
                       [](const Groups &a, const Groups &b) { return a.size() < b.size(); });
      unsigned int next = 100;
      for (const Group &group : groups)
        next = std::max(next, (group.*number).value_or(0));
      std::set<unsigned int> taken;
      for (const Groups &combination : order)
        {
          unsigned int id = combination.empty() ? 0 : ++next;
          for (const std::uint32_t g : combination)
            if (const auto given = groups[g].*number; given && (*given == 0 || taken.insert(*given).second))
              {
                id = *given;
                break;
              }
          id_of[combination] = id;
        }
    }

    unsigned int operator[](const Groups &combination) const
    {
      return id_of.at(combination);
    }

    /// The names of groups that hold something of this kind, and of those that are not read.
    void name(const std::vector<Group> &groups, const Number number, const std::vector<bool> &is_of_kind,
              NamedIds &names) const
    {
      for (std::uint32_t g = 0; g < groups.size(); ++g)
        if (is_of_kind[g] || !groups[g].not_read.empty())
          {
            NamedIds::Meaning meaning{groups[g].all_names(), {}, groups[g].not_read};
            for (const auto &[combination, id] : id_of)
              if (std::binary_search(combination.begin(), combination.end(), g))
                meaning.ids.push_back(id);
            if (groups[g].*number)
              meaning.names.push_back(std::to_string(*(groups[g].*number)));
            if (!meaning.names.empty())
              names.add(std::move(meaning));
          }
    }

  private:
    std::map<Groups, unsigned int> id_of;
  };

} // namespace birdstrike
