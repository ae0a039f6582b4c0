#include "structure/elements/shell/failure.h"
#include "structure/elements/shell/group.h"
#include <birdstrike/core/simd/flatten.h>

#include <cmath>

namespace birdstrike
{
  void ShellGroup::build_erosion()
  {
    erosion           = std::make_unique<Erosion>();
    erosion->n_needed = n_points_to_fail(section.failed_share(), n_in_plane * law.rule.n); // plies: see their share
    erosion->batches.resize(batches.size());
    erosion->damage.resize(points.size());
    has_new_failed.resize(batches.size(), 0);
    for (std::size_t slot = 0; slot < batches.size() * n_lanes; ++slot)
      erosion->set_size(slot, section.material.failure.size_factors, std::sqrt(geometry(element_of(slot)).area));
  }

  // Apart from metals that cannot fail, whose loop stays as small as it is.
  BIRDSTRIKE_FLATTEN [[gnu::noinline]] ShellWork<Lanes>
  ShellGroup::update_failing_points(const std::size_t b, const ShellVector<Lanes> &strain, const Lanes &area,
                                    const double dt)
  {
    AlignedVector<Lanes> &damage = erosion->damage[b];
    damage.resize(law.rule.n, Lanes(0.));
    FailingPoints<Lanes> failing{section.material.failure, section.material.hardening, dt, damage.data(),
                                 erosion->batches[b].ductility};
    ShellWork<Lanes>     work = law.update_plastic(strain, dt, stress[b], points[b].data(), failing);
    if (!failing.has_new)
      return work;
    const LanesMask fails  = count_failed(damage.data(), law.rule.n) >= Lanes(erosion->n_needed);
    Lanes           eroded = release_section(law, fails, strain, stress[b], points[b].data(), damage.data());
    work.hourglass -= release_stabilisation(law, fails, strain, stress[b], eroded);
    erosion->book(b, n_elements_of(b), fails, area * eroded);
    return work;
  }

  BIRDSTRIKE_FLATTEN [[gnu::noinline]] Lanes
  ShellGroup::update_failing_section(const std::size_t k, const SectionVector<Lanes> &strain, const double dt)
  {
    AlignedVector<Lanes> &damage = erosion->damage[k];
    damage.resize(law.rule.n, Lanes(0.));
    FailingPoints<Lanes> failing{section.material.failure, section.material.hardening, dt, damage.data(),
                                 erosion->batches[k / n_in_plane].ductility};
    const Lanes          work = law.update_plastic(strain, dt, sections[k], points[k].data(), failing);
    has_new_failed[k / n_in_plane] |= failing.has_new;
    return work;
  }

  [[gnu::noinline]] void ShellGroup::release_sections(const std::size_t b, const SectionVector<Lanes> *strain,
                                                      const Lanes *area)
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
    has_new_failed[b] = 0;
  }
} // namespace birdstrike
