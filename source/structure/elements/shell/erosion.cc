#include "structure/elements/shell/failure.h"
#include "structure/elements/shell/implementation.h"

#include <algorithm>

namespace birdstrike
{
  void ShellElements::Implementation::build_erosion()
  {
    erosion           = std::make_unique<ShellErosion>();
    erosion->n_needed = n_points_to_fail(section.material.failure, n_in_plane * law.rule.n);
    erosion->batches.resize(batches.size());
    erosion->has_new.resize(batches.size(), 0);
    erosion->damage.resize(points.size());
    const double share = section.material.failure.smallest_step;
    for (std::size_t b = 0; b < batches.size(); ++b)
      erosion->batches[b].allowed = batches[b].eigenvalue / (share * share);
    erosion->entering_of.resize(n_nodes);
    for (std::uint32_t k = 0; k < entering.size(); ++k)
      erosion->entering_of[entering[k].node] = k;
    for (std::size_t n = 0; n < n_nodes; ++n)
      erosion->n_left.push_back(corner_begin[n + 1] - corner_begin[n]);
    // a square of 1 m, at rest
    for (std::size_t i = 0; i < n_resting_records; ++i)
      {
        NodeRecord &record = records[n_nodes + i];
        record             = NodeRecord{};
        record.position[0] = i == 1 || i == 2 ? 1. : 0.;
        record.position[1] = i >= 2 ? 1. : 0.;
        record.normal[2] = record.midpoint_normal[2] = 1.;
      }
  }

  bool ShellElements::Implementation::is_failed(const std::size_t element) const
  {
    return erosion && erosion->is_failed(element);
  }

  // Apart from metals that cannot fail, whose loop stays as small as it is.
  [[gnu::noinline, gnu::flatten]] ShellWork<Lanes>
  ShellElements::Implementation::update_failing_points(const std::size_t b, const ShellVector<Lanes> &strain,
                                                       const Lanes &area, const double dt)
  {
    AlignedVector<Lanes> &damage = erosion->damage[b];
    damage.resize(law.rule.n, Lanes(0.));
    FailingPoints<Lanes> failing{section.material.failure, section.material.hardening, dt, damage.data()};
    ShellWork<Lanes>     work = law.update_plastic(strain, dt, stress[b], points[b].data(), failing);
    if (!failing.has_new)
      return work;
    const LanesMask fails  = count_failed(damage.data(), law.rule.n) >= Lanes(erosion->n_needed);
    Lanes           eroded = release_section(law, fails, strain, stress[b], points[b].data(), damage.data());
    work.hourglass -= release_stabilisation(law, fails, strain, stress[b], eroded);
    erosion->book(b, n_elements_of(b), fails, area * eroded);
    return work;
  }

  [[gnu::noinline, gnu::flatten]] Lanes
  ShellElements::Implementation::update_failing_section(const std::size_t k, const SectionVector<Lanes> &strain,
                                                        const double dt)
  {
    AlignedVector<Lanes> &damage = erosion->damage[k];
    damage.resize(law.rule.n, Lanes(0.));
    FailingPoints<Lanes> failing{section.material.failure, section.material.hardening, dt, damage.data()};
    const Lanes          work = law.update_plastic(strain, dt, sections[k], points[k].data(), failing);
    erosion->has_new[k / n_in_plane] |= failing.has_new;
    return work;
  }

  [[gnu::noinline]] void ShellElements::Implementation::release_sections(const std::size_t           b,
                                                                         const SectionVector<Lanes> *strain,
                                                                         const Lanes                *area)
  {
    const auto of       = [&](const std::size_t i) { return n_in_plane * b + i; };
    Lanes      n_failed = 0., energy = 0.;
    for (std::size_t i = 0; i < n_in_plane; ++i)
      n_failed += count_failed(erosion->damage[of(i)].data(), erosion->damage[of(i)].size());
    const LanesMask fails = n_failed >= Lanes(erosion->n_needed);
    for (std::size_t i = 0; i < n_in_plane; ++i)
      {
        const bool has_points = !points[of(i)].empty();
        energy +=
          area[i] * release_section(law, fails, strain[i], sections[of(i)], has_points ? points[of(i)].data() : nullptr,
                                    has_points ? erosion->damage[of(i)].data() : nullptr);
      }
    erosion->book(b, n_elements_of(b), fails, energy);
    erosion->has_new[b] = 0;
  }

  void ShellElements::Implementation::take_out(const std::size_t b, const std::size_t k,
                                               std::vector<std::uint32_t> &nodes)
  {
    Batch &batch                 = batches[b];
    erosion->batches[b].alive[k] = 0.;
    batch.inverse_mass[k]        = 0.; // no vote
    for (std::uint32_t i = 0; i < 4; ++i)
      batch.record[i][k] = static_cast<std::uint32_t>((n_nodes + i) * (sizeof(NodeRecord) / sizeof(double)));
    if (k >= n_elements_of(b))
      return;
    const auto &cell = cells[b * n_lanes + k];
    erosion->count_out(cell, mass[b * n_lanes + k], (erosion->batches[b].collapsed >> k & 1u) != 0);
    for (std::uint32_t i = 0; i < 4; ++i)
      {
        const std::uint32_t n = cell[i];
        const auto          corner =
          std::find_if(corners.begin() + corner_begin[n], corners.begin() + corner_begin[n + 1],
                       [&](const Corner &c) { return c.next == cell[(i + 1) % 4] && c.previous == cell[(i + 3) % 4]; });
        *corner = {n, n}; // spans no area, so adds nothing to the normal
        nodes.push_back(n);
      }
  }

  // Serial and in the order of the elements, so that it does not depend on the number of threads.
  void ShellElements::Implementation::erode(const double *position)
  {
    std::vector<std::uint32_t> nodes;
    for (std::size_t b = 0; b < batches.size(); ++b)
      if (const std::uint32_t dying = erosion->batches[b].dying; dying != 0)
        {
          for (std::size_t k = 0; k < n_lanes; ++k)
            if ((dying >> k & 1u) != 0)
              take_out(b, k, nodes);
          erosion->batches[b].dying = erosion->batches[b].collapsed = 0;
        }
    if (nodes.empty())
      return;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const std::uint32_t n : nodes)
      {
        const bool is_summed                        = !symmetry.empty() && !symmetry[n].empty();
        entering[erosion->entering_of[n]].diagonals = is_summed ? Diagonals{n, n, n, n} : find_diagonals(n);
        // the next step's mean is then of two normals of the same elements
        Point3::Map(records[n].normal) = compute_normal(n, position);
      }
    list_irregular();
  }

  double ShellElements::eroded_energy() const
  {
    return implementation->erosion ? implementation->erosion->energy() : 0.;
  }

  std::size_t ShellElements::n_failed() const
  {
    return implementation->erosion ? implementation->erosion->n_failed : 0;
  }

  std::size_t ShellElements::n_collapsed() const
  {
    return implementation->erosion ? implementation->erosion->n_collapsed : 0;
  }

  bool ShellElements::is_failed(const std::size_t element) const
  {
    return implementation->is_failed(element);
  }

  double ShellElements::failed_mass() const
  {
    return implementation->erosion ? implementation->erosion->mass : 0.;
  }

  bool ShellElements::is_free(const std::size_t node) const
  {
    return implementation->erosion && implementation->erosion->n_left[node] == 0;
  }

  double ShellElements::damage(const std::size_t element) const
  {
    const Implementation &my = *implementation;
    return my.erosion ? my.erosion->largest_damage(element, my.n_in_plane) : 0.;
  }
} // namespace birdstrike
