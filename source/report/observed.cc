#include <birdstrike/report/balance.h>
#include <birdstrike/report/observed.h>
#include <birdstrike/structure/blade.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace birdstrike
{
  void Observed::start(const Blade &blade)
  {
    if (const std::optional<SpanLine> line = blade.span_line())
      mid_chord.emplace(blade.facets(), *line, blade.blades_of_facets());
    for (const BladeLoads &of : blade.loads_of_row())
      if (!of.is_rigid)
        row.push_back({of.place, {}, {}, {}});
  }

  void Observed::update_peaks(const Blade &blade, const bool has_contact, const double time)
  {
    tip = blade.tip_deflection();
    if (tip_peak.update(time, tip.mid_chord) && mid_chord)
      mid_chord->compute_deflection(mid_chord_at_peak);
    first_tip_peak.update(time, tip.mid_chord, has_contact ? contact.force() : 0.);

    root                = blade.root_section();
    const double stress = root.peak_stress();
    if (stress > root_stress.value())
      root_at_peak_stress = root;
    root_stress.update(time, stress);
    root_moment.update(time, std::abs(root.bending_moment));
    root_force.update(time, std::hypot(root.normal_force, root.transverse_force));
    if (row.empty())
      return;
    auto peaks = row.begin();
    for (const BladeLoads &of : blade.loads_of_row())
      if (!of.is_rigid)
        {
          peaks->tip.update(time, of.tip.mid_chord);
          peaks->root_moment.update(time, std::abs(of.root.bending_moment));
          peaks->root_stress.update(time, of.root.peak_stress());
          ++peaks;
        }
  }

  void Observed::update_shares(const Balance &balance, const double time)
  {
    // Until a hundredth of the strike's energy has reached the blade, a ratio of two small numbers says nothing.
    const EnergyReport &energy   = balance.state().blade;
    const double        internal = energy.elastic + energy.plastic + energy.hourglass + energy.viscous;
    if (internal > 1e-2 * balance.energy_scale())
      hourglass_share.update(time, energy.hourglass / internal);
  }

  void Observed::filter_force(const double channel_class)
  {
    FilteredForce filtered = contact.channel().filter();
    smooth_peak            = filtered.peak;
    if (channel_class > 0.)
      filtered_force = std::move(filtered);
  }

  void Observed::update_present(const Blade &blade)
  {
    plastic = blade.peak_plastic_strains();
    failure = blade.failure();
    probes  = blade.probes();
    force   = blade.contact_force();
  }
} // namespace birdstrike
