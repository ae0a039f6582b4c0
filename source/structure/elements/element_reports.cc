#include "structure/elements/price.h"
#include "structure/elements/shell/group.h"
#include "structure/elements/solid/group.h"

#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/simd/larger.h>

namespace birdstrike
{
  namespace
  {
    // of an element's energy at failure: what it stored, and, negative, what forces have not paid for of its last flow,
    // which in the step of failure was larger than what was stored
    constexpr auto stored_at_failure = [](const Lanes &energy) { return max(energy, Lanes(0.)); };
    constexpr auto unpaid_flow       = [](const Lanes &energy) { return min(energy, Lanes(0.)); };
  } // namespace

  template <class Group>
  double Elements<Group>::largest_stable_step() const
  {
    Lanes largest = 0.;
    for (const Group &group : groups)
      for (const ElementChunk &chunk : group.chunks)
        largest = larger(largest, chunk.bound);
    return Group::step_of(largest_lane(largest));
  }

  template <class Group>
  StepLimit Elements<Group>::step_limit() const
  {
    double      largest = 0.;
    std::size_t worst   = 0;
    for (std::size_t e = 0; e < n_elements(); ++e)
      {
        const auto [group, k] = find(e);
        if (const double value = lane(group.batches[k / n_lanes].bound, k % n_lanes);
            exceeds(value, largest) && group.is_owned(k))
          {
            largest = value;
            worst   = e;
          }
      }
    const auto [group, k] = find(worst);
    return {Group::step_of(largest), Group::reason, group.where(k)};
  }

  template <class Group>
  StoredEnergy::Sums Elements<Group>::stored_energy() const
  {
    StoredEnergy::Sums sums{};
    for (const Group &group : groups)
      {
        const auto of_group =
          StoredEnergy::compute(pool, group.points.size(), [&group](const std::size_t k) { return group.stored(k); });
        for (std::size_t kind = 0; kind < sums.size(); ++kind)
          sums[kind] += of_group[kind];
      }
    return sums;
  }

  template <class Group>
  double Elements<Group>::sum(Lanes ElementChunk::*energy) const
  {
    double result = 0.;
    for (const Group &group : groups)
      result += group.sum(energy);
    return result;
  }

  template <class Group>
  double Elements<Group>::plastic_work() const
  {
    return sum(&ElementChunk::plastic) + sum_erosion(unpaid_flow);
  }

  template <class Group>
  double Elements<Group>::viscous_energy() const
  {
    return sum(&ElementChunk::viscous);
  }

  template <class Group>
  double Elements<Group>::work() const
  {
    double total = 0.;
    for (const Row &row : node_work)
      for (const double part : row.value)
        total += part;
    return total;
  }

  template <class Group>
  template <class Part>
  double Elements<Group>::sum_erosion(const Part &part) const
  {
    double energy = 0.;
    for (const Group &group : groups)
      energy += sum_erosion(group, part);
    return energy;
  }

  template <class Group>
  template <class Part>
  double Elements<Group>::sum_erosion(const Group &group, const Part &part) const
  {
    double of_group = 0.;
    for (std::size_t b = 0; group.erosion && b < group.batches.size(); ++b)
      of_group += stdx::reduce(group.batches[b].owned * part(group.erosion->batches[b].energy));
    return of_group;
  }

  template <class Group>
  void Elements<Group>::add_energies_of(const std::size_t section, EnergyReport &report) const
  {
    const Group &group = groups.at(section);
    const auto   stored =
      StoredEnergy::compute(pool, group.points.size(), [&group](const std::size_t k) { return group.stored(k); });
    report.elastic += stored[0] + stored[1];
    report.plastic += group.sum(&ElementChunk::plastic) + sum_erosion(group, unpaid_flow);
    report.hourglass += group.sum(&ElementChunk::hourglass);
    report.viscous += group.sum(&ElementChunk::viscous);
    report.eroded += sum_erosion(group, stored_at_failure);
  }

  template <class Group>
  double Elements<Group>::eroded_energy() const
  {
    return sum_erosion(stored_at_failure);
  }

  template <class Group>
  void Elements<Group>::add_energies(EnergyReport &report) const
  {
    // What stabilises a brick of one point is the strain of bending and torsion, exact for a plate of one layer:
    // nothing in it is artificial, and counted as hourglass it would be most of what such a plate stores.
    const auto stored = stored_energy();
    report.elastic    = stored[0] + stored[1];
    report.plastic    = plastic_work();
    report.hourglass  = sum(&ElementChunk::hourglass);
    report.viscous    = viscous_energy();
    report.eroded     = eroded_energy();
    report.internal   = work();
  }

  template <class Group>
  std::size_t Elements<Group>::n_elements() const
  {
    return place.size();
  }

  template <class Group>
  ElementPrices Elements<Group>::prices() const
  {
    ElementPrices sum;
    for (std::size_t k = 0; k < groups.size(); ++k)
      {
        if (is_rigid[k])
          continue;
        const Group &group = groups[k];
        std::size_t  n = 0, n_with_points = 0, n_yielded = 0;
        for (std::size_t b = 0; b < group.batches.size(); ++b)
          {
            n += group.n_elements_of(b);
            if (!group.has_points(b))
              continue;
            n_with_points += group.n_elements_of(b);
            n_yielded += group.count_yielded(b);
          }
        const auto [elastic, yielding] = price_of(group.section);
        sum.add(n, n_with_points, n_yielded, elastic, yielding);
      }
    return sum;
  }

  template <class Group>
  std::size_t Elements<Group>::n_promoted() const
  {
    return prices().n_with_points;
  }

  template <class Group>
  std::size_t Elements<Group>::bytes() const
  {
    std::size_t sum = bytes_of(place) + bytes_of(chunks) + blocks.bytes() + bytes_of(corner_force) +
                      bytes_of(node_force) + bytes_of(node_work) + bytes_of(n_left) + nodes.bytes();
    for (const Group &group : groups)
      sum += group.bytes();
    return sum;
  }

  template <class Group>
  std::vector<typename Elements<Group>::MaxPlasticStrain> Elements<Group>::max_plastic_strains() const
  {
    std::vector<MaxPlasticStrain> result(groups.size());
    for (std::size_t e = 0; e < n_elements(); ++e)
      {
        const auto [group, k]    = find(e);
        MaxPlasticStrain &so_far = result[static_cast<std::size_t>(&group - groups.data())];
        if (const double strain = group.largest_plastic_strain(k); strain > so_far.value && group.is_owned(k))
          so_far = {strain, e};
      }
    return result;
  }

  template <class Group>
  std::size_t Elements<Group>::n_sections() const
  {
    return groups.size();
  }

  template <class Group>
  const typename Group::Section &Elements<Group>::section(const std::size_t element) const
  {
    return find(element).first.section;
  }

  template <class Group>
  typename Elements<Group>::SectionSums Elements<Group>::section_sums(const std::size_t section) const
  {
    const Group &group = groups.at(section);
    SectionSums  sums{0, 0., group.sum(&ElementChunk::plastic)};
    for (std::size_t e = 0; e < group.n_elements(); ++e)
      if (group.is_owned(e) || is_rigid[section]) // which books nothing, but is there
        {
          ++sums.n_elements;
          sums.mass += group.mass[e];
        }
    return sums;
  }

  template class Elements<ShellGroup>;
  template class Elements<SolidGroup>;
} // namespace birdstrike
