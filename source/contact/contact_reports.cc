#include <birdstrike/contact/contact.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>

namespace birdstrike
{
  void Contact::sum_report(const SymmetryPlane &plane)
  {
    last.force         = {};
    last.stored_energy = last.dissipation_power = last.penetration = 0.;
    last.n_touching                                                = 0;
    std::fill(last.patch_pressures.begin(), last.patch_pressures.end(), 0.);
    for (const BlockReport &block : block_reports)
      {
        for (unsigned int d = 0; d < 3; ++d)
          last.force[d] += block.force[d];
        last.stored_energy += block.stored_energy;
        last.dissipation_power += block.dissipation_power;
        if (exceeds(block.penetration, last.penetration))
          {
            last.penetration   = block.penetration;
            last.deepest_point = block.deepest_point;
            last.deepest_facet = block.deepest_facet;
          }
        last.n_touching += block.n_touching;
        last.pairs_tested += block.n_tested;
        last.points_active += block.n_active;
        for (std::size_t k = 0; k < patches.size(); ++k)
          last.patch_pressures[k] += block.patch_pressures[k];
      }
    last.force             = plane.whole(last.force);
    last.stored_energy     = plane.whole(last.stored_energy);
    last.dissipation_power = plane.whole(last.dissipation_power);
    last.dissipated_energy = plane.whole(dissipation.energy());
    last.released_energy   = plane.whole(dissipation.released());
    last.staggering        = plane.whole(dissipation.to_be_given_back());
    last.dissipation_fall  = plane.whole(dissipation.fall());
    last.n_touching        = plane.whole(last.n_touching);
    for (std::size_t k = 0; k < patches.size(); ++k)
      if (patches[k].centre[1] == 0.) // half of the disc is computed
        last.patch_pressures[k] = plane.whole(last.patch_pressures[k]);
    last.touches += last.n_touching;
    last.points_near += search.n_near();
    last.pairs_listed += search.n_pairs();
  }

  void Contact::update_peaks(const double spacing)
  {
    const double norm = Point3(last.force[0], last.force[1], last.force[2]).norm();
    if (exceeds(norm, last.peak_force))
      {
        last.peak_force      = norm;
        last.peak_force_time = clock;
      }
    last.max_penetration              = larger(last.max_penetration, last.penetration);
    last.max_penetration_over_spacing = spacing > 0. ? last.max_penetration / spacing : 0.;
  }
} // namespace birdstrike
