#include "structure/elements/shell/failure.h"
#include "structure/elements/shell/group.h"

#include <algorithm>
#include <cmath>

// Elements that collapse, with Failure::smallest_step: rare, so after the loop over the batches of a chunk.
namespace birdstrike
{
  namespace
  {
    LanesMask mask_of(const std::uint32_t bits)
    {
      return Lanes([bits](const auto k) { return double(bits >> std::size_t(k) & 1u); }) > Lanes(0.);
    }

    std::uint32_t bits_of(const LanesMask &mask)
    {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < n_lanes; ++k)
        bits |= std::uint32_t(mask[k]) << k;
      return bits;
    }
  } // namespace

  bool ShellGroup::can_collapse() const
  {
    return erosion && section.smallest_step() > 0.;
  }

  /// Whether neither stresses nor what they have dissipated has become infinite or NaN.
  bool ShellGroup::has_finite_state(const std::size_t element) const
  {
    const std::size_t   b = element / n_lanes, k = element % n_lanes;
    const ElementChunk &chunk = chunks[b / ElementBlocks::batches_per_chunk];
    double              sum   = lane(chunk.plastic, k) + lane(chunk.hourglass, k);
    for (std::size_t i = 0; i < n_in_plane; ++i)
      {
        const SectionStress<Lanes> &s = section_of(b, i);
        sum += lane(s.thickness, k);
        for (int c = 0; c < 3; ++c)
          sum += lane(s.mean[c], k) + lane(s.outer[c], k);
      }
    return std::isfinite(sum);
  }

  /// Half the work of the corner forces of lane k on the displacements of the step (J), which they do no more; 0 where
  /// they are not finite.
  double ShellGroup::drop_forces(const std::size_t b, const std::size_t k)
  {
    double work = 0.;
    for (int i = 0; i < 4; ++i)
      {
        ForceOnCorner     &row    = place.corner_force[batches[b].corner[i][k]];
        const ShellRecord &record = place.records[place.cells[b * n_lanes + k][i]];
        for (int c = 0; c < 3; ++c)
          work += 0.5 * (row.value[c] * record.increment[c] + row.value[3 + c] * record.rotation[c]);
        row = ForceOnCorner{};
      }
    return std::isfinite(work) ? work : 0.;
  }

  void ShellGroup::collapse(const std::size_t b, ElementChunk &chunk)
  {
    const LanesMask fails = mask_of(erosion->batches[b].collapsed);
    const Lanes zero = 0., volume([&](const auto k) { return mass[element_of(b * n_lanes + k)] / section.density(); });
    ShellVector<Lanes> none; // the forces' work is taken as a whole
    for (int c = 0; c < 3; ++c)
      none.membrane[c] = none.curvature[c] = zero;
    for (int c = 0; c < 2; ++c)
      none.shear[c] = none.linear_membrane[c] = none.linear_curvature[c] = none.linear_shear[c] = zero;
    Lanes energy = 0.;
    if (laminate)
      release_collapsed_laminate(b, fails, energy);
    for (std::size_t i = n_in_plane * b; i < n_in_plane * (b + 1) && !laminate; ++i)
      {
        SectionStress<Lanes> &s          = n_in_plane == 1 ? stress[b] : sections[i];
        const bool            has_points = !points[i].empty();
        energy += release_section(law, fails, none, s, has_points ? points[i].data() : nullptr,
                                  has_points ? erosion->damage[i].data() : nullptr) /
                  s.thickness;
      }
    energy *= volume / double(n_in_plane);
    if (n_in_plane == 1 && !laminate)
      {
        Lanes       eroded    = 0.;
        const Lanes hourglass = release_stabilisation(law, fails, none, stress[b], eroded);
        const Lanes area      = volume / stress[b].thickness;
        energy += area * eroded;
        for (std::size_t k = 0; k < n_lanes; ++k)
          if (batches[b].owned[k] > 0.)
            chunk.hourglass[k] -= area[k] * hourglass[k];
      }
    for (std::size_t k = 0; k < n_elements_of(b); ++k)
      if (fails[k])
        energy[k] -= drop_forces(b, k);
    erosion->book(b, n_elements_of(b), fails, select(fails, energy, zero));
    batches[b].bound = select(fails, zero, batches[b].bound);
  }

  void ShellGroup::take_collapsed(const std::size_t c)
  {
    ElementChunk     &chunk = chunks[c];
    const std::size_t end   = std::min(batches.size(), (c + 1) * ElementBlocks::batches_per_chunk);
    bool              has   = false;
    for (std::size_t b = c * ElementBlocks::batches_per_chunk; b < end; ++b)
      {
        Erosion::OfBatch &of_batch = erosion->batches[b];
        of_batch.collapsed |= bits_of(of_batch.alive > Lanes(0.) && batches[b].bound > of_batch.allowed);
        if (of_batch.collapsed == 0)
          continue;
        has = true;
        collapse(b, chunk);
      }
    if (!has)
      return;
    chunk.bound = Lanes(0.);
    for (std::size_t b = c * ElementBlocks::batches_per_chunk; b < end; ++b)
      chunk.bound = max(chunk.bound, Lanes(batches[b].owned * batches[b].bound));
  }
} // namespace birdstrike
