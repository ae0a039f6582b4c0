#include <birdstrike/blade/blade.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/simulation/balance.h>
#include <birdstrike/simulation/observed.h>
#include <birdstrike/simulation/scene.h>

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

  void Observed::update(const Scene &scene, const Balance &balance, const double time)
  {
    if (!scene.blade)
      return;
    root    = scene.symmetry.whole(scene.blade->root_section());
    tip     = scene.blade->tip_deflection();
    plastic = scene.blade->peak_plastic_strain();
    failure = scene.symmetry.whole(scene.blade->failure());
    probes  = scene.blade->probes();

    if (mid_chord && tip.mid_chord > tip_peak.value())
      mid_chord->compute_deflection(mid_chord_at_peak);
    tip_peak.update(time, tip.mid_chord);
    const double stress = root.peak_stress();
    if (stress > root_stress.value())
      root_at_peak_stress = root;
    root_stress.update(time, stress);
    root_moment.update(time, std::abs(root.bending_moment));
    root_force.update(time, std::hypot(root.normal_force, root.transverse_force));

    force = scene.symmetry.whole(scene.blade->contact_force());
    contact_force.update(time, std::hypot(force[0], force[1], force[2]));
    first_tip_peak.update(time, tip.mid_chord, std::hypot(force[0], force[1], force[2]));
    if (scene.contact)
      max_penetration = std::max(max_penetration, scene.contact->report().max_penetration);

    // Until a hundredth of all energy has reached the blade, a ratio of two small numbers says nothing.
    const EnergyReport &energy   = balance.state().blade;
    const double        internal = energy.elastic + energy.plastic + energy.hourglass + energy.viscous;
    if (internal > 1e-2 * balance.initial_energy())
      hourglass_share.update(time, energy.hourglass / internal);
  }
} // namespace birdstrike
