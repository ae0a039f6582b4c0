#include "mesh/files/ls_dyna/sets.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::vector<ImportedMesh::Id> sorted_once(std::vector<ImportedMesh::Id> ids)
    {
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
      return ids;
    }
  } // namespace

  void LsDynaSets::resolve()
  {
    for (unsigned int d = 1; d <= 3; ++d)
      for (const ImportedMesh::Element &element : mesh.elements[d])
        element_of[d].emplace(element.id, &element);
    for (auto &[group, set] : sets)
      {
        members_of(group);
        write(set, mesh.groups[group]);
      }
  }

  const std::vector<LsDynaSets::Id> &LsDynaSets::members_of(const std::size_t group)
  {
    Set &set = sets.at(group);
    if (set.is_done || set.is_begun) // the latter: it is of itself, and adds nothing
      return set.members;
    set.is_begun = true;
    std::vector<Id> members;
    for (const Step &step : set.steps)
      {
        const std::vector<Id> more = members_of(set, step);
        if (step.source != Source::members)
          cards.lines.add_listed(more.size());
        if (!step.removes)
          members.insert(members.end(), more.begin(), more.end());
        else if (set.kind == kind_of("SEGMENT"))
          for (std::size_t k = 0; k + 3 < more.size(); k += 4)
            for (std::size_t j = members.size() / 4; j-- > 0;)
              {
                const auto at = members.begin() + static_cast<std::ptrdiff_t>(4 * j);
                if (std::is_permutation(at, at + 4, more.begin() + static_cast<std::ptrdiff_t>(k)))
                  members.erase(at, at + 4);
              }
        else
          {
            const std::set<Id> gone(more.begin(), more.end());
            std::erase_if(members, [&gone](const Id id) { return gone.count(id) > 0; });
          }
      }
    set.members = std::move(members);
    set.is_done = true;
    return set.members;
  }

  std::vector<LsDynaSets::Id> LsDynaSets::members_of(const Set &set, const Step &step)
  {
    if (step.source == Source::members)
      return step.ids;
    if (step.source == Source::all)
      return all_of(*set.kind);
    if (step.source == Source::parts)
      return as(*set.kind, *kind_of("PART"), step.ids);
    std::vector<Id> numbers; // a negative one: all from the one before
    for (const Id number : step.ids)
      if (number > 0 || numbers.empty())
        numbers.push_back(number);
      else
        for (const Id other : groups.numbers(step.kind->name))
          if (other > numbers.back() && number <= -other)
            numbers.push_back(other);
    std::vector<Id> members;
    std::string    &not_read = mesh.groups[groups(set.kind->name, set.number)].not_read;
    for (std::size_t k = 0; k < numbers.size() && not_read.empty(); ++k)
      {
        const auto found = groups.find(step.kind->name, numbers[k]);
        if (!found || sets.count(*found) == 0)
          {
            not_read = "Line " + std::to_string(set.line) + ": it takes from " + step.kind->name + "_" +
                       std::to_string(numbers[k]) +
                       ", which is not there or not read.\nWrite its members as *SET_..._LIST.";
            continue;
          }
        const auto of = as(*set.kind, *step.kind, members_of(*found));
        if (const std::string &why = mesh.groups[*found].not_read; !why.empty() && &why != &not_read)
          not_read = why;
        if (step.source == Source::sets || k == 0)
          members.insert(members.end(), of.begin(), of.end());
        else
          {
            const std::set<Id> also(of.begin(), of.end());
            std::erase_if(members, [&also](const Id id) { return also.count(id) == 0; });
          }
      }
    return members;
  }

  std::vector<LsDynaSets::Id> LsDynaSets::all_of(const Kind &kind) const
  {
    std::vector<Id> all;
    if (&kind == kind_of("PART"))
      return groups.numbers("part");
    if (kind.dim > 0)
      for (const auto &element : mesh.elements[kind.dim])
        all.push_back(element.id);
    else
      for (const auto &node : mesh.nodes)
        all.push_back(node.first);
    return all;
  }

  /// Members of a set of another kind: nodes of elements, elements and nodes of parts.
  std::vector<LsDynaSets::Id> LsDynaSets::as(const Kind &wanted, const Kind &given, const std::vector<Id> &members)
  {
    if (&wanted == &given)
      return members;
    std::vector<Id> all;
    if (&given == kind_of("PART"))
      {
        for (const Id part : members)
          if (const auto found = groups.find("part", part))
            for (unsigned int d = 1; d <= 3; ++d)
              {
                const auto           &elements = mesh.groups[*found].elements[d];
                const std::vector<Id> more     = d == wanted.dim   ? elements
                                                 : wanted.dim == 0 ? nodes_of(d, elements)
                                                                   : std::vector<Id>();
                all.insert(all.end(), more.begin(), more.end());
              }
        return wanted.dim == 0 ? sorted_once(all) : all;
      }
    if (given.dim > 0)
      return nodes_of(given.dim, members);
    for (const Id node : members) // of segments
      all.push_back(node);
    return sorted_once(all);
  }

  std::vector<LsDynaSets::Id> LsDynaSets::nodes_of(const unsigned int dim, const std::vector<Id> &elements)
  {
    std::vector<Id> nodes;
    for (const Id id : elements)
      if (const auto found = element_of[dim].find(id); found != element_of[dim].end())
        nodes.insert(nodes.end(), found->second->nodes.begin(), found->second->nodes.begin() + (1 << dim));
    return sorted_once(nodes);
  }

  void LsDynaSets::write(const Set &set, ImportedMesh::Group &group) const
  {
    if (!group.not_read.empty())
      return;
    if (set.kind == kind_of("NODE"))
      group.nodes = set.members;
    else if (set.kind == kind_of("SEGMENT"))
      for (std::size_t k = 0; k + 3 < set.members.size(); k += 4)
        group.sides.emplace_back(set.members.begin() + static_cast<std::ptrdiff_t>(k),
                                 set.members.begin() + static_cast<std::ptrdiff_t>(k) + 4);
    else if (set.kind != kind_of("PART"))
      group.elements[set.kind->dim] = set.members;
    else
      for (const Id part : set.members)
        if (const auto found = groups.find("part", part))
          for (unsigned int d = 0; d <= 3; ++d)
            {
              const auto &of_part = mesh.groups[*found].elements[d];
              cards.lines.add_listed(of_part.size());
              group.elements[d].insert(group.elements[d].end(), of_part.begin(), of_part.end());
            }
  }
} // namespace birdstrike
