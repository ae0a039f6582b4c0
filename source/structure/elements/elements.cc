#include "structure/elements/shell/group.h"
#include "structure/elements/solid/group.h"
#include <birdstrike/core/simd/registers.h>

#include <birdstrike/core/errors.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <type_traits>

namespace birdstrike
{
  std::string text_of(const double value)
  {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
  }

  namespace
  {
    template <class Section>
    bool has_failure(const Sections<Section> &sections)
    {
      return std::any_of(sections.all.begin(), sections.all.end(),
                         [](const Section &section) { return section.can_fail(); });
    }
  } // namespace

  template <class Group>
  const std::vector<typename Group::Cell> &Elements<Group>::checked(const std::vector<Cell> &cells,
                                                                    const std::size_t        n_nodes)
  {
    if (cells.empty())
      throw InputError(std::string(Group::names) + ": no elements; at least one is needed.");
    for (const auto &cell : cells)
      for (const auto node : cell)
        if (node >= n_nodes)
          throw InputError(std::string(Group::names) + ": a cell names node " + std::to_string(node) + " of " +
                           std::to_string(n_nodes) + ".");
    return cells;
  }

  /// Fills `place` and `chunks`, a section after the other; returns the chunk of every element.
  template <class Group>
  std::vector<std::uint32_t> Elements<Group>::order(const Sections<Section> &sections, const std::size_t n_elements)
  {
    constexpr std::size_t      per_chunk = ElementBlocks::batches_per_chunk * n_lanes;
    std::vector<std::uint32_t> chunk_of(n_elements), first(sections.all.size(), 0), n(sections.all.size(), 0);
    place.resize(n_elements);
    for (std::size_t e = 0; e < n_elements; ++e)
      {
        const std::uint32_t group = sections.of_element.empty() ? 0 : sections.of_element[e];
        place[e]                  = {group, n.at(group)++};
      }
    for (std::uint32_t group = 0; group < n.size(); ++group)
      {
        if (n[group] == 0)
          throw InputError(std::string(Group::names) + ": section " + std::to_string(group) + " has no element.");
        first[group] = chunks.size();
        for (std::uint32_t c = 0; c < (n[group] + per_chunk - 1) / per_chunk; ++c)
          chunks.push_back({group, c});
      }
    for (std::size_t e = 0; e < n_elements; ++e)
      chunk_of[e] = first[place[e].group] + place[e].number / per_chunk;
    return chunk_of;
  }

  template <class Group>
  Elements<Group>::Elements(const std::vector<Point3> &points, const std::vector<Cell> &cells,
                            const std::vector<Extra> &extra, const Sections<Section> &sections, ThreadPool &pool)
    : pool(pool)
    , n_nodes(points.size())
    , n_owned_nodes(n_nodes)
    , blocks({checked(cells, n_nodes)[0].data(), Group::n_corners * cells.size()}, order(sections, cells.size()),
             n_nodes)
    , corner_force(blocks.n_rows + sections.all.size())
    , node_force(n_nodes)
    , node_work(blocks.n_sums, Row{})
    , n_left(has_failure(sections) ? n_nodes : 0, 0)
    , is_rigid(sections.is_rigid)
    , nodes(points, cells, blocks, pool)
  {
    groups.reserve(sections.all.size());
    is_rigid.resize(sections.all.size(), false);
    for (std::uint32_t group = 0; group < sections.all.size(); ++group)
      {
        typename Group::Place of_group{{},
                                       {},
                                       {},
                                       {},
                                       nodes.records.data(),
                                       corner_force.data(),
                                       n_nodes,
                                       static_cast<std::uint32_t>(blocks.n_rows + group)};
        std::vector<Extra>    of_elements;
        for (std::uint32_t e = 0; e < cells.size(); ++e)
          if (place[e].group == group)
            {
              of_group.number.push_back(e);
              of_group.label.push_back(sections.labels.empty() ? e : sections.labels[e]);
              of_group.cells.push_back(cells[e]);
              if constexpr (requires { nodes.sheets; })
                if (!nodes.sheets.records_of_corners.empty())
                  of_group.record_cells.push_back(nodes.sheets.records_of_corners[e]);
              of_elements.push_back(extra[e]);
            }
        groups.emplace_back(sections.all[group], std::move(of_group), of_elements, blocks);
      }
    for (std::size_t e = 0; e < cells.size() && can_fail(); ++e)
      for (const auto n : cells[e])
        ++n_left[n];
    set_inverse_masses({});
  }

  template <class Group>
  bool Elements<Group>::try_internal_forces(const double *position, const double *increment, const double dt,
                                            double *force)
  {
    for (const auto &block : blocks.blocks)
      {
        nodes.update(block, position, increment);
        const auto body = [&](const std::size_t begin, const std::size_t end) {
          for (std::size_t c = block.chunk_begin + begin; c < block.chunk_begin + end; ++c)
            if (Group &group = groups[chunks[c].group]; !is_rigid[chunks[c].group])
              group.update_chunk(chunks[c].number, dt);
            else
              group.clear_forces(chunks[c].number); // whose rows are those of others in between
        };
        pool.parallel_for(block.chunk_end - block.chunk_begin, 1, std::cref(body));
        gather_forces(block, force);
      }
    return std::none_of(groups.begin(), groups.end(), [](const Group &group) {
      return group.erosion && std::any_of(group.erosion->batches.begin(), group.erosion->batches.end(),
                                          [](const Erosion::OfBatch &batch) { return batch.dying != 0; });
    });
  }

  template <class Group>
  void Elements<Group>::compute_internal_forces(const double *position, const double *increment, const double dt,
                                                double *force)
  {
    if (!try_internal_forces(position, increment, dt, force))
      erode();
  }

  template <class Group>
  void Elements<Group>::gather_forces(const ElementBlocks::Block &block, double *force)
  {
    using Register                  = std::conditional_t<n_unknowns == 6, Eight, Four>;
    constexpr std::size_t per_chunk = ElementBlocks::nodes_per_chunk;
    const std::size_t     n         = block.leaving_end - block.leaving_begin;
    const auto            body      = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
        {
          Register sum;
          read(node_work[block.sum_begin + chunk].value, sum);
          for (std::size_t i = chunk * per_chunk; i < std::min(n, (chunk + 1) * per_chunk); ++i)
            {
              const auto [node, first, n_corners] = blocks.leaving[block.leaving_begin + i];
              Register f{}, part, old, u;
              for (std::size_t k = first; k < first + n_corners; ++k)
                {
                  read(corner_force[k].value, part);
                  f += part;
                }
              read(node_force[node].value, old);
              read(nodes.records[node].increment, u); // and rotation; what follows meets zeros
              if (node < n_owned_nodes)
                sum += 0.5 * (old + f) * u;
              write(f, node_force[node].value);
              f = -f;
              std::memcpy(force + n_unknowns * node, &f, n_unknowns * sizeof(double));
            }
          write(sum, node_work[block.sum_begin + chunk].value);
        }
    };
    pool.parallel_for((n + per_chunk - 1) / per_chunk, 1, std::cref(body));
  }

  // Serial and in the order of the elements, so that it does not depend on the number of threads.
  template <class Group>
  void Elements<Group>::erode()
  {
    for (Group &group : groups)
      for (std::size_t b = 0; group.erosion && b < group.batches.size(); ++b)
        if (Erosion::OfBatch &of_batch = group.erosion->batches[b]; of_batch.dying != 0)
          {
            for (std::size_t k = 0; k < n_lanes; ++k)
              if ((of_batch.dying >> k & 1u) != 0)
                {
                  group.take_out(b, k);
                  if (k >= group.n_elements_of(b))
                    continue;
                  group.erosion->count_out(group.is_owned(b * n_lanes + k), group.mass[b * n_lanes + k],
                                           (of_batch.collapsed >> k & 1u) != 0);
                  for (const auto n : group.place.cells[b * n_lanes + k])
                    --n_left[n];
                }
            of_batch.dying = of_batch.collapsed = 0;
          }
  }

  template <class Group>
  void Elements<Group>::set_owned(const std::size_t n_nodes, const std::vector<bool> &elements)
  {
    n_owned_nodes = n_nodes;
    for (std::size_t e = 0; e < n_elements(); ++e)
      groups[place[e].group].batches[place[e].number / n_lanes].owned[place[e].number % n_lanes] =
        elements[e] && !is_rigid[place[e].group] ? 1. : 0.;
  }

  template <class Group>
  void Elements<Group>::use_nodal_masses(const std::span<const double> mass)
  {
    if (mass.size() != n_nodes)
      throw InputError(std::string(Group::names) + ": " + std::to_string(mass.size()) + " nodal masses for " +
                       std::to_string(n_nodes) + " nodes.");
    set_inverse_masses(mass);
  }

  template <class Group>
  std::vector<double> Elements<Group>::compute_nodal_masses() const
  {
    std::vector<double> mass(n_nodes, 0.);
    for (std::size_t e = 0; e < n_elements(); ++e)
      {
        const auto [group, k] = find(e);
        for (const auto n : group.place.cells[k])
          mass[n] += (1. / Group::n_corners) * group.mass[k];
      }
    return mass;
  }

  template <class Group>
  void Elements<Group>::set_inverse_masses(const std::span<const double> nodal_masses)
  {
    const std::vector<double> equal = compute_nodal_masses();
    for (Group &group : groups)
      {
        for (std::size_t slot = 0; slot < group.batches.size() * n_lanes; ++slot)
          {
            const std::size_t e     = group.element_of(slot);
            double            share = nodal_masses.empty() ? 1. : Group::largest_share;
            if (!nodal_masses.empty())
              for (const auto n : group.place.cells[e])
                share = std::min(share, nodal_masses[n] / equal[n]);
            group.batches[slot / n_lanes].inverse_mass[slot % n_lanes] = 1. / (share * group.mass[e]);
          }
        group.update_bounds_at_rest();
      }
  }

  template class Elements<ShellGroup>;
  template class Elements<SolidGroup>;
} // namespace birdstrike
