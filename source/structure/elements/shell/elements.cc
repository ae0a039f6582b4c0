#include "structure/elements/shell/implementation.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace birdstrike
{
  void ShellElements::Implementation::promote(const std::size_t k)
  {
    points[k].resize(law.rule.n);
    law.promote(n_in_plane == 1 ? stress[k] : sections[k], points[k].data());
  }

  const SectionStress<Lanes> &ShellElements::Implementation::section_of(const std::size_t batch,
                                                                        const std::size_t k) const
  {
    return n_in_plane == 1 ? stress[batch] : sections[n_in_plane * batch + k];
  }

  const AlignedVector<ShellPoint<Lanes>> &ShellElements::Implementation::points_of(const std::size_t batch,
                                                                                   const std::size_t k) const
  {
    return points[n_in_plane * batch + k];
  }

  bool ShellElements::Implementation::has_points(const std::size_t batch) const
  {
    bool has = false;
    for (std::size_t k = 0; k < n_in_plane; ++k)
      has = has || !points_of(batch, k).empty();
    return has;
  }

  double ShellElements::Implementation::largest_thickness(const std::size_t element) const
  {
    double largest = 0.;
    for (std::size_t k = 0; k < n_in_plane; ++k)
      largest = std::max(largest, lane(section_of(element / n_lanes, k).thickness, element % n_lanes));
    return largest;
  }

  double ShellElements::Implementation::sum(Lanes Chunk::*energy) const
  {
    double result = 0.;
    for (const Chunk &chunk : chunks)
      result += stdx::reduce(chunk.*energy);
    return result;
  }

  ShellElements::ShellElements(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 4>> cells,
                               std::vector<double> thickness, const ShellSection &section, ThreadPool &pool)
    : implementation(
        std::make_unique<Implementation>(std::move(nodes), std::move(cells), std::move(thickness), section, pool))
  {
  }
  ShellElements::~ShellElements()                         = default;
  ShellElements::ShellElements(ShellElements &&) noexcept = default;

  void ShellElements::add_symmetry_plane(const std::span<const std::uint32_t> nodes, const Point3 &plane_normal)
  {
    Implementation     &my = *implementation;
    std::vector<double> position;
    for (const auto &record : my.records)
      position.insert(position.end(), record.position, record.position + 3);
    my.symmetry.resize(my.n_nodes);
    for (const auto node : nodes)
      {
        my.symmetry.at(node).push_back(plane_normal.normalized());
        std::find_if(my.entering.begin(), my.entering.end(), [node](const auto &entry) {
          return entry.node == node;
        })->diagonals                        = {node, node, node, node};
        Point3::Map(my.records[node].normal) = my.compute_normal(node, position.data());
      }
    my.list_irregular();
  }

  void ShellElements::compute_internal_forces(const double *position, const double *increment, const double dt,
                                              double *force)
  {
    Implementation &my = *implementation;
    for (const auto &block : my.blocks)
      {
        my.update_nodes(block, position, increment);
        const auto body = [&](const std::size_t begin, const std::size_t end) {
          for (std::size_t c = begin; c < end; ++c)
            my.update_chunk(block.chunk_begin + c, dt);
        };
        my.pool.parallel_for(block.chunk_end - block.chunk_begin, 1, std::cref(body));
        my.gather_forces(block, force);
      }
    if (my.erosion)
      my.erode(position);
  }

  double ShellElements::largest_stable_step() const
  {
    Lanes largest = 0.;
    for (const auto &chunk : implementation->chunks)
      largest = max(largest, chunk.eigenvalue);
    return 2. / std::sqrt(stdx::hmax(largest));
  }

  StepLimit ShellElements::step_limit() const
  {
    const Implementation &my      = *implementation;
    double                largest = 0.;
    std::size_t           worst   = 0;
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      if (const double value = lane(my.batches[e / n_lanes].eigenvalue, e % n_lanes); value > largest)
        {
          largest = value;
          worst   = e;
        }
    return {2. / std::sqrt(largest), "shell element, largest eigenvalue", my.place(worst)};
  }

  void ShellElements::use_nodal_masses(const std::span<const double> mass)
  {
    if (mass.size() != implementation->n_nodes)
      throw InputError("Shell elements: " + std::to_string(mass.size()) + " nodal masses for " +
                       std::to_string(implementation->n_nodes) + " nodes.");
    implementation->set_inverse_masses(mass);
  }

  std::vector<double> ShellElements::compute_nodal_masses() const
  {
    const Implementation &my = *implementation;
    std::vector<double>   mass(my.n_nodes, 0.);
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      for (const auto n : my.cells[e])
        mass[n] += 0.25 * my.mass[e];
    return mass;
  }

  std::vector<double> ShellElements::compute_rotary_inertias() const
  {
    const Implementation &my = *implementation;
    std::vector<double>   inertia(my.n_nodes, 0.);
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      {
        const double t = my.largest_thickness(e);
        const double r = std::max(t * t / 12., my.geometry(e).area / 8.);
        for (const auto n : my.cells[e])
          inertia[n] += 0.25 * r * my.mass[e];
      }
    return inertia;
  }
} // namespace birdstrike
