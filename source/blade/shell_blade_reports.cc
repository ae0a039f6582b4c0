#include "shell_blade_state.h"

#include <birdstrike/blade/census.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    constexpr std::array<ShellLayer, 3> layers{{ShellLayer::bottom, ShellLayer::middle, ShellLayer::top}};
    const std::array<std::string, 3>    layer_names{{"bottom", "middle", "top"}};

    double von_mises(const std::array<double, 6> &s)
    {
      const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
      return std::sqrt(0.5 * (a * a + b * b + c * c) + 3. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
    }

    Field node_vector(const std::string &name, const std::string &unit, const double *values, const std::size_t n_nodes)
    {
      Field field{name, unit, false, 3, {}};
      field.values.reserve(3 * n_nodes);
      for (std::size_t n = 0; n < n_nodes; ++n)
        field.values.insert(field.values.end(), values + 6 * n, values + 6 * n + 3);
      return field;
    }

    template <class Value>
    Field cell_scalar(const std::string &name, const std::string &unit, const std::size_t n_cells, const Value &value)
    {
      Field field{name, unit, true, 1, {}};
      field.values.reserve(n_cells);
      for (std::size_t cell = 0; cell < n_cells; ++cell)
        field.values.push_back(value(cell));
      return field;
    }

    void add_layer_fields(const ShellElements &elements, const unsigned int layer, std::vector<Field> &fields)
    {
      static const std::array<std::string, 6> components{{"xx", "yy", "zz", "xy", "yz", "zx"}};
      const std::size_t                       n = elements.n_elements();
      fields.push_back(cell_scalar("equivalent_plastic_strain_" + layer_names[layer], "-", n, [&](const std::size_t e) {
        return elements.layer_plastic_strain(e, layers[layer]);
      }));
      fields.push_back(cell_scalar("von_mises_stress_" + layer_names[layer], "Pa", n, [&](const std::size_t e) {
        return von_mises(elements.global_layer_stress(e, layers[layer]));
      }));
      if (layer == 1)
        return; // the mid-surface stress follows from both faces
      for (unsigned int c = 0; c < 6; ++c)
        fields.push_back(
          cell_scalar("stress_" + components[c] + "_" + layer_names[layer], "Pa", n,
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
    const double *f    = state->contact.data();
    const auto    sums = state->sum_components<1>([=](const std::size_t i, Eight *sum) {
      Eight force;
      read(f + i, force);
      sum[0] += force;
    });
    return {{sums[0][0], sums[0][1], sums[0][2]}};
  }

  EnergyReport ShellBlade::energies() const
  {
    const State  &s     = *state;
    const double  decay = std::exp(-s.damping * s.internal_half);
    const double *v = s.velocity.data(), *f = s.force.data(), *m = s.mass.data();
    const double  h = s.internal_half, h_c = s.contact_half;
    const double *f_contact = s.contact.data(), *f_external = s.external.data(), *inverse = s.inverse_mass.data();
    const double  back   = 1. - 1. / decay;
    const auto    sums   = s.sum_components<1>([=](const std::size_t i, Eight *sum) {
      Eight speed, force, contact, external, mass, mobility;
      read(v + i, speed);
      read(f + i, force);
      read(m + i, mass);
      read(f_contact + i, contact);
      read(f_external + i, external);
      read(inverse + i, mobility);
      const Eight internal = h * (force + external) * mobility + back * speed, outer = h_c * contact * mobility;
      sum[0] += 0.5 * mass * (speed * speed - internal * internal - outer * outer);
    });
    EnergyReport  report = s.booked;
    report.kinetic       = std::accumulate(sums[0].begin(), sums[0].end(), 0.);
    report.elastic       = s.elements.elastic_energy();
    report.plastic       = s.elements.plastic_work();
    report.hourglass     = s.elements.hourglass_energy();
    return report;
  }

  MomentumReport ShellBlade::momenta() const
  {
    const State   &s = *state;
    const double  *v = s.velocity.data(), *m = s.mass.data(), *x = s.position.data();
    const auto     sums   = s.sum_nodes([=](const std::size_t n, State::Sums &sum) {
      const double *p = x + 3 * n, *w = v + 6 * n;
      const double  mass = m[6 * n], inertia = m[6 * n + 3];
      for (unsigned int d = 0; d < 3; ++d)
        {
          const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
          sum[d] += mass * w[d];
          sum[3 + d] += mass * (p[e] * w[f] - p[f] * w[e]) + inertia * w[3 + d];
        }
    });
    MomentumReport report = s.impulses;
    for (unsigned int d = 0; d < 3; ++d)
      {
        report.momentum[d]         = sums[d];
        report.angular_momentum[d] = sums[3 + d];
      }
    return report;
  }

  std::size_t ShellBlade::n_elements() const
  {
    return state->elements.n_elements();
  }

  std::size_t ShellBlade::n_nodes() const
  {
    return state->n_nodes;
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
    // 8 vectors of six and 2 of three numbers a node; what elements hold; about 600 bytes a cell of deal.II's mesh
    census.bytes              = 54. * 8. * census.n_nodes + state->elements.bytes() + 600. * census.n_elements;
    census.bytes_per_snapshot = 8. * (9. * census.n_nodes + 19. * census.n_elements) + 16. * census.n_elements;
    return census;
  }

  FieldSnapshot ShellBlade::snapshot() const
  {
    const State       &s    = *state;
    const SurfaceMesh &mesh = s.mesh.surface();
    FieldSnapshot      snapshot;
    snapshot.dim = 2;
    snapshot.points.assign(s.reference.begin(), s.reference.end());
    for (const auto &c : mesh.cells)
      snapshot.cells.insert(snapshot.cells.end(), {c[0], c[1], c[3], c[2]});
    snapshot.fields.push_back(node_vector("displacement", "m", s.displacement.data(), s.n_nodes));
    snapshot.fields.push_back(node_vector("velocity", "m/s", s.velocity.data(), s.n_nodes));
    for (unsigned int layer = 0; layer < 3; ++layer)
      add_layer_fields(s.elements, layer, snapshot.fields);
    snapshot.fields.push_back(cell_scalar("thickness", "m", mesh.cells.size(),
                                          [&](const std::size_t e) { return s.elements.state(e).thickness; }));
    return snapshot;
  }

  std::vector<ProbeValues> ShellBlade::probes() const
  {
    const State             &s = *state;
    std::vector<ProbeValues> values;
    for (const auto &[name, n] : s.watched)
      {
        ProbeValues value;
        value.name = name;
        for (unsigned int d = 0; d < 3; ++d)
          {
            value.position[d]     = s.reference[3 * n + d];
            value.displacement[d] = s.displacement[6 * n + d];
            value.velocity[d]     = s.velocity[6 * n + d];
          }
        values.push_back(value);
      }
    return values;
  }

  RootSectionReport ShellBlade::root_section() const
  {
    return state->root.compute_report(state->force.data(), state->position.data(), state->elements);
  }

  TipDeflection ShellBlade::tip_deflection() const
  {
    return state->tip.compute_deflection(state->displacement.data());
  }

  PeakPlasticStrain ShellBlade::peak_plastic_strain() const
  {
    const auto   peak = state->elements.max_plastic_strain();
    const Point3 c    = state->mesh.surface().centroid(peak.element);
    return {peak.value, peak.element, {{c[0], c[1], c[2]}}};
  }
} // namespace birdstrike
