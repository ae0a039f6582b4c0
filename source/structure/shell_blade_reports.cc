#include "structure/elements/von_mises.h"
#include "structure/failure_report.h"
#include "structure/shell_blade_state.h"

#include "structure/census.h"

#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr std::array<ShellLayer, 3> layers{{ShellLayer::bottom, ShellLayer::middle, ShellLayer::top}};
    const std::array<std::string, 3>    layer_names{{"bottom", "middle", "top"}};

    using Cells = std::vector<std::size_t>;

    template <class Value>
    Field cell_scalar(const std::string &name, const std::string &unit, const Cells &cells, const Value &value)
    {
      Field field{name, unit, true, 1, {}};
      field.values.reserve(cells.size());
      for (const std::size_t cell : cells)
        field.values.push_back(value(cell));
      return field;
    }

    void add_layer_fields(const ShellElements &elements, const Cells &cells, const unsigned int layer,
                          std::vector<Field> &fields)
    {
      static const std::array<std::string, 6> components{{"xx", "yy", "zz", "xy", "yz", "zx"}};
      fields.push_back(
        cell_scalar("equivalent_plastic_strain_" + layer_names[layer], "-", cells,
                    [&](const std::size_t e) { return elements.layer_plastic_strain(e, layers[layer]); }));
      fields.push_back(cell_scalar("von_mises_stress_" + layer_names[layer], "Pa", cells, [&](const std::size_t e) {
        return von_mises(elements.global_layer_stress(e, layers[layer]));
      }));
      if (layer == 1)
        return; // the mid-surface stress follows from both faces
      for (unsigned int c = 0; c < 6; ++c)
        fields.push_back(
          cell_scalar("stress_" + components[c] + "_" + layer_names[layer], "Pa", cells,
                      [&](const std::size_t e) { return elements.global_layer_stress(e, layers[layer])[c]; }));
    }
  } // namespace

  std::string ShellBlade::kind() const
  {
    return "shell";
  }

  bool ShellBlade::is_deformable() const
  {
    return true;
  }

  StepLimit ShellBlade::step_limit() const
  {
    return state->elements.step_limit();
  }

  double ShellBlade::largest_stable_step() const
  {
    return state->elements.largest_stable_step();
  }

  std::array<double, 3> ShellBlade::contact_force() const
  {
    return state->nodes.contact_force();
  }

  EnergyReport ShellBlade::energies() const
  {
    EnergyReport report = state->nodes.energies();
    report.elastic      = state->elements.elastic_energy();
    report.plastic      = state->elements.plastic_work();
    report.hourglass    = state->elements.hourglass_energy();
    report.eroded       = state->elements.eroded_energy();
    report.internal     = state->elements.work();
    return report;
  }

  MomentumReport ShellBlade::momenta() const
  {
    return state->nodes.momenta();
  }

  std::size_t ShellBlade::n_elements() const
  {
    return state->elements.n_elements();
  }

  std::size_t ShellBlade::n_nodes() const
  {
    return state->mesh.surface().nodes.size();
  }

  double ShellBlade::mass() const
  {
    return state->lumped.total;
  }

  BladeCensus ShellBlade::census() const
  {
    const SurfaceMesh &mesh       = state->mesh.surface();
    BladeCensus        census     = compute_census(mesh);
    census.mass                   = mass();
    census.n_held_dofs            = state->supports.held_dofs.size();
    census.n_elements_with_points = state->elements.n_promoted();
    // and about 600 bytes a cell of deal.II's mesh
    census.bytes              = state->nodes.bytes() + state->elements.bytes() + 600. * census.n_elements;
    census.bytes_per_snapshot = 8. * (9. * census.n_nodes + 19. * census.n_elements) + 16. * census.n_elements;
    return census;
  }

  FieldSnapshot ShellBlade::snapshot() const
  {
    const State       &s    = *state;
    const SurfaceMesh &mesh = s.mesh.surface();
    FieldSnapshot      snapshot;
    snapshot.dim = 2;
    for (const auto &x : mesh.nodes)
      snapshot.points.insert(snapshot.points.end(), x.begin(), x.end());
    Cells left; // failed elements are not shown
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      if (const auto &c = mesh.cells[e]; !s.elements.is_failed(e))
        {
          left.push_back(e);
          snapshot.cells.insert(snapshot.cells.end(), {c[0], c[1], c[3], c[2]});
        }
    s.nodes.add_fields(snapshot.fields);
    for (unsigned int layer = 0; layer < 3; ++layer)
      add_layer_fields(s.elements, left, layer, snapshot.fields);
    snapshot.fields.push_back(
      cell_scalar("thickness", "m", left, [&](const std::size_t e) { return s.elements.state(e).thickness; }));
    if (s.can_fail)
      {
        snapshot.fields.push_back(
          cell_scalar("damage", "-", left, [&](const std::size_t e) { return s.elements.damage(e); }));
        snapshot.fields.push_back(
          cell_scalar("element", "-", left, [](const std::size_t e) { return static_cast<double>(e); }));
      }
    return snapshot;
  }

  std::vector<ProbeValues> ShellBlade::probes() const
  {
    return state->nodes.probes();
  }

  RootSectionReport ShellBlade::root_section() const
  {
    return state->root.compute_report(state->nodes.element_forces(), state->nodes.positions(), state->elements);
  }

  TipDeflection ShellBlade::tip_deflection() const
  {
    return state->tip.compute_deflection(state->nodes.displacements(), 6);
  }

  std::optional<SpanLine> ShellBlade::span_line() const
  {
    return make_span_line(state->root.section(), state->tip, state->nodes.reference_positions());
  }

  PeakPlasticStrain ShellBlade::peak_plastic_strain() const
  {
    const auto   peak = state->elements.max_plastic_strain();
    const Point3 c    = state->mesh.surface().centroid(peak.element);
    return {peak.value, peak.element, {{c[0], c[1], c[2]}}};
  }

  FailureReport ShellBlade::failure() const
  {
    const State &s = *state;
    return make_failure_report(s.elements, s.root, s.tip, s.lumped.node, s.can_fail);
  }
} // namespace birdstrike
