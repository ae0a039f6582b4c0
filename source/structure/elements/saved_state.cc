#include "structure/elements/shell/group.h"
#include "structure/elements/solid/group.h"

#include <optional>
#include <tuple>

// What an attempt of the static solve takes back.
namespace birdstrike
{
  template <class... T>
  std::tuple<T...> copy(const std::tuple<T &...> &references)
  {
    return references;
  }

  template <class Group>
  struct Elements<Group>::Saved
  {
    struct OfGroup
    {
      decltype(copy(std::declval<Group &>().changing()))             changing;
      std::optional<typename decltype(Group::erosion)::element_type> erosion;
    };
    std::vector<OfGroup>                         groups;
    AlignedVector<typename Group::Record>        records;
    AlignedVector<typename Group::ForceOnCorner> force, work;
  };

  template <class Group>
  auto Elements<Group>::save() -> std::shared_ptr<const Saved>
  {
    auto saved = std::make_shared<Saved>();
    for (Group &group : groups)
      {
        saved->groups.push_back({copy(group.changing()), {}});
        if (group.erosion)
          saved->groups.back().erosion = *group.erosion;
      }
    saved->records = nodes.records;
    saved->force   = node_force;
    saved->work    = node_work;
    return saved;
  }

  template <class Group>
  void Elements<Group>::suspend_flow(const bool is_suspended)
  {
    for (Group &group : groups)
      group.suspend_flow(is_suspended);
  }

  template <class Group>
  void Elements<Group>::restore(const Saved &saved)
  {
    for (std::size_t k = 0; k < groups.size(); ++k)
      {
        groups[k].changing() = saved.groups[k].changing;
        if (groups[k].erosion)
          *groups[k].erosion = *saved.groups[k].erosion;
      }
    nodes.records = saved.records;
    node_force    = saved.force;
    node_work     = saved.work;
  }

  template class Elements<ShellGroup>;
  template class Elements<SolidGroup>;
} // namespace birdstrike
