#include "simulation/observed.h"
#include "simulation/scene.h"
#include <birdstrike/report/balance.h>
#include <birdstrike/structure/blade.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  void Observed::start(const Scene &scene)
  {
    if (!scene.blade)
      return;
    if (const std::optional<SpanLine> line = scene.blade->span_line())
      mid_chord.emplace(scene.blade->facets(), *line);
  }

  void Observed::update_peaks(const Scene &scene, const double time)
  {
    if (!scene.blade)
      return;
    tip = scene.blade->tip_deflection();
    if (tip_peak.update(time, tip.mid_chord) && mid_chord)
      mid_chord->compute_deflection(mid_chord_at_peak);
    first_tip_peak.update(time, tip.mid_chord, scene.contact ? contact.force() : 0.);

    root                = scene.symmetry.whole(scene.blade->root_section());
    const double stress = root.peak_stress();
    if (stress > root_stress.value())
      root_at_peak_stress = root;
    root_stress.update(time, stress);
    root_moment.update(time, std::abs(root.bending_moment));
    root_force.update(time, std::hypot(root.normal_force, root.transverse_force));
  }

  void Observed::update_shares(const Balance &balance, const double time)
  {
    // Until a hundredth of all energy has reached the blade, a ratio of two small numbers says nothing.
    const EnergyReport &energy   = balance.state().blade;
    const double        internal = energy.elastic + energy.plastic + energy.hourglass + energy.viscous;
    if (internal > 1e-2 * balance.initial_energy())
      hourglass_share.update(time, energy.hourglass / internal);
  }

  void Observed::update_present(const Scene &scene)
  {
    if (!scene.blade)
      return;
    plastic = scene.blade->peak_plastic_strain();
    failure = scene.symmetry.whole(scene.blade->failure());
    probes  = scene.blade->probes();
    force   = scene.symmetry.whole(scene.blade->contact_force());
  }
} // namespace birdstrike
