#include "structure/elements/von_mises.h"
#include "structure/failure_report.h"
#include "structure/solid_blade_state.h"

#include "structure/census.h"

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Of the elements that have not failed.
    void add_element_fields(const SolidElements &elements, std::vector<Field> &fields)
    {
      static const std::array<std::string, 6> components{{"xx", "yy", "zz", "xy", "yz", "zx"}};
      std::vector<SolidState>                 states;
      for (std::size_t e = 0; e < elements.n_elements(); ++e)
        if (!elements.is_failed(e))
          states.push_back(elements.state(e));
      const auto add = [&](const std::string &name, const std::string &unit, const auto &value) {
        Field field{name, unit, true, 1, {}};
        field.values.reserve(states.size());
        for (const SolidState &state : states)
          field.values.push_back(value(state));
        fields.push_back(std::move(field));
      };
      add("equivalent_plastic_strain", "-", [](const SolidState &s) { return s.plastic_strain; });
      add("largest_equivalent_plastic_strain", "-", [](const SolidState &s) { return s.max_plastic_strain; });
      add("von_mises_stress", "Pa", [](const SolidState &s) { return von_mises(s.stress); });
      for (unsigned int c = 0; c < 6; ++c)
        add("stress_" + components[c], "Pa", [c](const SolidState &s) { return s.stress[c]; });
    }
  } // namespace

  std::string SolidBlade::kind() const
  {
    return "solid";
  }

  bool SolidBlade::is_deformable() const
  {
    return true;
  }

  StepLimit SolidBlade::step_limit() const
  {
    return state->elements.step_limit();
  }

  double SolidBlade::largest_stable_step() const
  {
    return state->elements.largest_stable_step();
  }

  std::array<double, 3> SolidBlade::contact_force() const
  {
    return state->nodes.contact_force();
  }

  EnergyReport SolidBlade::energies() const
  {
    // What stabilises a brick of one point is the strain of bending and torsion, exact for a plate of one layer:
    // nothing in it is artificial, and counted as hourglass it would be most of what such a plate stores.
    EnergyReport report = state->nodes.energies();
    const auto   stored = state->elements.stored_energy();
    report.elastic      = stored[0] + stored[1];
    report.plastic      = state->elements.plastic_work();
    report.viscous      = state->elements.viscous_energy();
    report.eroded       = state->elements.eroded_energy();
    report.internal     = state->elements.work();
    return report;
  }

  MomentumReport SolidBlade::momenta() const
  {
    return state->nodes.momenta();
  }

  std::size_t SolidBlade::n_elements() const
  {
    return state->elements.n_elements();
  }

  std::size_t SolidBlade::n_nodes() const
  {
    return state->mesh.volume().nodes.size();
  }

  double SolidBlade::mass() const
  {
    return state->lumped.total;
  }

  BladeCensus SolidBlade::census() const
  {
    BladeCensus census            = compute_census(state->mesh.volume());
    census.mass                   = mass();
    census.n_held_dofs            = state->supports.held_dofs.size();
    census.n_elements_with_points = state->elements.n_promoted();
    census.mass_scaling           = state->scaling;
    // and about 1200 bytes a cell of deal.II's mesh
    census.bytes              = state->nodes.bytes() + state->elements.bytes() + 1200. * census.n_elements;
    census.bytes_per_snapshot = 8. * (9. * census.n_nodes + 9. * census.n_elements) + 32. * census.n_elements;
    return census;
  }

  FieldSnapshot SolidBlade::snapshot() const
  {
    const VolumeMesh &mesh = state->mesh.volume();
    FieldSnapshot     snapshot;
    snapshot.dim = 3;
    for (const auto &x : mesh.nodes)
      snapshot.points.insert(snapshot.points.end(), x.begin(), x.end());
    Field damage{"damage", "-", true, 1, {}}, number{"element", "-", true, 1, {}};
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      if (!state->elements.is_failed(e)) // failed elements are not shown
        {
          snapshot.cells.insert(snapshot.cells.end(), mesh.cells[e].begin(), mesh.cells[e].end());
          damage.values.push_back(state->elements.damage(e));
          number.values.push_back(static_cast<double>(e));
        }
    state->nodes.add_fields(snapshot.fields);
    add_element_fields(state->elements, snapshot.fields);
    if (state->can_fail)
      snapshot.fields.insert(snapshot.fields.end(), {std::move(damage), std::move(number)});
    return snapshot;
  }

  std::vector<ProbeValues> SolidBlade::probes() const
  {
    return state->nodes.probes();
  }

  RootSectionReport SolidBlade::root_section() const
  {
    return state->root.compute_report(state->nodes.element_forces(), state->nodes.positions(), state->elements);
  }

  TipDeflection SolidBlade::tip_deflection() const
  {
    return state->tip.compute_deflection(state->nodes.displacements(), 3);
  }

  std::optional<SpanLine> SolidBlade::span_line() const
  {
    return make_span_line(state->root.section(), state->tip, state->nodes.reference_positions());
  }

  PeakPlasticStrain SolidBlade::peak_plastic_strain() const
  {
    const auto   peak = state->elements.max_plastic_strain();
    const Point3 c    = state->mesh.volume().centroid(peak.element);
    return {peak.value, peak.element, {{c[0], c[1], c[2]}}};
  }

  FailureReport SolidBlade::failure() const
  {
    const State &s = *state;
    return make_failure_report(s.elements, s.root, s.tip, s.lumped.node, s.can_fail);
  }
} // namespace birdstrike
