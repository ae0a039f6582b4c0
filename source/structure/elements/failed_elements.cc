#include "structure/elements/shell/group.h"
#include "structure/elements/solid/group.h"
#include <birdstrike/structure/reports.h>

#include <algorithm>

/// What has failed, and what may.
namespace birdstrike
{
  namespace
  {
    template <class Groups, class Part>
    auto sum_of(const Groups &groups, const Part &part)
    {
      decltype(part(*groups[0].erosion)) sum = 0;
      for (const auto &group : groups)
        sum += group.erosion ? part(*group.erosion) : 0;
      return sum;
    }
  } // namespace

  template <class Group>
  bool Elements<Group>::can_fail() const
  {
    return !n_left.empty();
  }

  template <class Group>
  std::size_t Elements<Group>::n_failed() const
  {
    return sum_of(groups, [](const Erosion &erosion) { return erosion.n_failed; });
  }

  template <class Group>
  std::size_t Elements<Group>::n_collapsed() const
  {
    return sum_of(groups, [](const Erosion &erosion) { return erosion.n_collapsed; });
  }

  template <class Group>
  double Elements<Group>::failed_mass() const
  {
    return sum_of(groups, [](const Erosion &erosion) { return erosion.mass; });
  }

  template <class Group>
  void Elements<Group>::add_sizes(const std::size_t section, SizeCensus &sizes) const
  {
    const Group       &group   = groups.at(section);
    const SizeFactors &factors = group.section.material.failure.size_factors;
    for (std::size_t e = 0; group.erosion && factors.n > 0 && e < group.n_elements(); ++e)
      if (group.is_owned(e))
        {
          const Erosion::OfBatch &batch = group.erosion->batches[e / n_lanes];
          const double            size = lane(batch.size, e % n_lanes), factor = lane(batch.ductility, e % n_lanes);
          sizes.smallest = std::min(sizes.smallest, size);
          sizes.largest  = std::max(sizes.largest, size);
          sizes.lowest   = std::min(sizes.lowest, factor);
          sizes.highest  = std::max(sizes.highest, factor);
          sizes.n_beyond += factors.is_within(size) ? 0 : 1;
        }
  }

  template <class Group>
  bool Elements<Group>::is_failed(const std::size_t element) const
  {
    const auto [group, k] = find(element);
    return group.is_failed(k);
  }

  template <class Group>
  bool Elements<Group>::is_free(const std::size_t node) const
  {
    return can_fail() && n_left[node] == 0;
  }

  template <class Group>
  std::size_t Elements<Group>::n_failed_points(const std::size_t element) const
  {
    const auto [group, k] = find(element);
    return group.erosion ? group.erosion->count_failed_points(k, group.erosion->damage.size() / group.batches.size())
                         : 0;
  }

  template <class Group>
  double Elements<Group>::damage(const std::size_t element) const
  {
    const auto [group, k] = find(element);
    return group.erosion ? group.erosion->largest_damage(k, group.erosion->damage.size() / group.batches.size()) : 0.;
  }

  template class Elements<ShellGroup>;
  template class Elements<SolidGroup>;
} // namespace birdstrike
