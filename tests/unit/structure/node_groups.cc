#include "node_groups.h"

namespace birdstrike::test
{
  NodeGroups find_groups(const NodeSets &neighbors)
  {
    NodeGroups               groups;
    std::vector<std::size_t> group_of(neighbors.size(), neighbors.size());
    for (std::size_t n = 0; n < neighbors.size(); ++n)
      {
        std::set<std::size_t> taken;
        for (const std::size_t near : neighbors[n])
          for (const std::size_t other : neighbors[near])
            taken.insert(group_of[other]);
        std::size_t group = 0;
        while (taken.contains(group))
          ++group;
        if (group == groups.size())
          groups.emplace_back();
        groups[group].push_back(n);
        group_of[n] = group;
      }
    return groups;
  }
} // namespace birdstrike::test
