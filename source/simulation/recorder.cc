#include "simulation/recorder.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    constexpr const char *axis_names[] = {"x", "y", "z"};

    /// A user's name as part of a column's: what separates columns becomes an underscore.
    std::string column_name(std::string name)
    {
      for (char &letter : name)
        if (letter == ' ' || letter == ',' || letter == '/' || letter == '\t')
          letter = '_';
      return name;
    }

    /// Intervals of zero mean "first and last state only".
    Ticks field_ticks_of(const double interval)
    {
      return Ticks(interval > 0. ? interval : 1e300);
    }
  } // namespace

  Recorder::Recorder(const Scene &scene, const CaseParameters &parameters, const std::filesystem::path &folder,
                     const Observed &observed, const Balance &balance)
    : scene(scene)
    , observed(observed)
    , balance(balance)
    , history(folder, parameters.output.hdf5)
    , history_ticks(parameters.output.history_interval)
    , field_ticks(field_ticks_of(parameters.output.field_interval))
    , flush_interval(parameters.output.flush_interval)
  {
    add_clock_and_balance_columns();
    if (scene.bird)
      add_bird_columns();
    if (scene.contact)
      add_contact_columns(parameters.contact);
    if (scene.blade)
      {
        add_blade_columns();
        add_root_profile();
      }
    if (scene.blade && parameters.output.blade_fields)
      blade_fields.emplace(folder, "blade");
    if (scene.bird && parameters.output.bird_fields)
      bird_fields.emplace(folder, "bird");
  }

  void Recorder::add_clock_and_balance_columns()
  {
    history.add_column("time", "s", [this] { return now; });
    history.add_column("step", "-", [this] { return static_cast<double>(steps); });
    history.add_column("bird_step", "s", [this] { return scene.bird ? scene.last_plan().bird_step() : 0.; });
    history.add_column("blade_step", "s", [this] { return scene.last_plan().blade_step(); });
    history.add_column("energy", "J", [this] { return balance.energy(); });
    history.add_column("energy_error", "-", [this] { return balance.energy_error().now; });
    history.add_column("momentum_error", "-", [this] { return balance.momentum_error().now; });
    history.add_column("angular_momentum_error", "-", [this] { return balance.angular_momentum_error().now; });
    history.add_column("staggering", "J",
                       [this] { return balance.state().bird.staggering + balance.state().blade.staggering; });
  }

  void Recorder::add_bird_columns()
  {
    history.add_column("particles", "-",
                       [this] { return scene.bird ? scene.symmetry.factor() * scene.bird->state().size() : 0.; });
    history.add_column("bird_kinetic", "J", [this] { return balance.state().bird.kinetic; });
    history.add_column("bird_elastic", "J", [this] { return balance.state().bird.elastic; });
    history.add_column("bird_dissipated", "J", [this] { return balance.state().bird.dissipated; });
    history.add_column("bird_internal", "J", [this] { return balance.state().bird.internal; });
    history.add_column("bird_retired", "J", [this] { return balance.state().bird.retired; });
    for (unsigned int c = 0; c < 3; ++c)
      history.add_column(std::string("bird_momentum_") + axis_names[c], "N s",
                         [this, c] { return balance.state().bird_momentum.momentum[c]; });
  }

  void Recorder::add_contact_columns(const ContactParameters &parameters)
  {
    for (unsigned int c = 0; c < 3; ++c)
      history.add_column(std::string("contact_force_") + axis_names[c], "N", [this, c] { return observed.force[c]; });
    history.add_column("contact_force_peak", "N", [this] { return observed.contact.peak_since_row(); });
    for (unsigned int c = 0; c < 3; ++c)
      history.add_column(std::string("contact_impulse_") + axis_names[c], "N s",
                         [this, c] { return balance.state().blade_momentum.contact_impulse[c]; });
    history.add_column("contact_stored", "J", [this] { return balance.state().contact.elastic; });
    history.add_column("contact_dissipated", "J", [this] { return balance.state().contact.dissipated; });
    history.add_column("points_in_contact", "-", [this] {
      return scene.contact ? scene.symmetry.factor() * scene.contact->report().n_touching : 0.;
    });
    history.add_column("penetration", "m", [this] { return scene.contact ? scene.contact->report().penetration : 0.; });
    const auto patches = parameters.pressure_patches();
    for (std::size_t p = 0; p < patches.size(); ++p)
      {
        // half of a disc about a point of the symmetry plane carries half of its force
        const double share = patches[p].centre[1] == 0. ? scene.symmetry.factor() : 1.;
        history.add_column("pressure_" + column_name(patches[p].name), "Pa", [this, p, share] {
          return scene.contact && !scene.contact->report().patch_pressures.empty()
                   ? share * scene.contact->report().patch_pressures[p]
                   : 0.;
        });
      }
  }

  void Recorder::add_blade_columns()
  {
    history.add_column("blade_kinetic", "J", [this] { return balance.state().blade.kinetic; });
    history.add_column("blade_elastic", "J", [this] { return balance.state().blade.elastic; });
    history.add_column("blade_plastic", "J", [this] { return balance.state().blade.plastic; });
    history.add_column("blade_hourglass", "J", [this] { return balance.state().blade.hourglass; });
    history.add_column("blade_viscous", "J", [this] { return balance.state().blade.viscous; });
    history.add_column("blade_damped", "J", [this] { return balance.state().blade.damped; });
    history.add_column("blade_external_work", "J", [this] { return balance.state().blade.external_work; });
    if (scene.self_contact)
      {
        history.add_column("self_contact_stored", "J", [this] { return balance.state().self_contact.elastic; });
        history.add_column("self_contact_dissipated", "J", [this] { return balance.state().self_contact.dissipated; });
      }
    for (unsigned int c = 0; c < 3; ++c)
      history.add_column(std::string("blade_momentum_") + axis_names[c], "N s",
                         [this, c] { return balance.state().blade_momentum.momentum[c]; });
    for (unsigned int c = 0; c < 3; ++c)
      history.add_column(std::string("support_impulse_") + axis_names[c], "N s",
                         [this, c] { return balance.state().blade_momentum.support_impulse[c]; });
    history.add_column("tip_mid_chord", "m", [this] { return observed.tip.mid_chord; });
    history.add_column("tip_leading", "m", [this] { return observed.tip.leading; });
    history.add_column("tip_trailing", "m", [this] { return observed.tip.trailing; });
    history.add_column("root_normal_force", "N", [this] { return observed.root.normal_force; });
    history.add_column("root_transverse_force", "N", [this] { return observed.root.transverse_force; });
    history.add_column("root_bending_moment", "N m", [this] { return observed.root.bending_moment; });
    history.add_column("root_peak_normal_stress", "Pa", [this] { return observed.root.peak_stress(); });
    history.add_column("max_plastic_strain", "-", [this] { return observed.plastic.value; });
    if (scene.blade->failure().can_fail)
      {
        history.add_column("blade_eroded", "J", [this] { return balance.state().blade.eroded; });
        history.add_column("failed_elements", "-", [this] { return double(observed.failure.n_elements); });
      }
    const auto probes = scene.blade->probes();
    for (std::size_t p = 0; p < probes.size(); ++p)
      for (unsigned int c = 0; c < 3; ++c)
        history.add_column("probe_" + column_name(probes[p].name) + "_u" + axis_names[c], "m",
                           [this, p, c] { return observed.probes[p].displacement[c]; });
  }

  void Recorder::add_root_profile()
  {
    const RootSectionReport root = scene.blade->root_section();
    if (root.chord_position.empty())
      return;
    const std::size_t n = root.chord_position.size();
    history.add_profile("root_normal_stress", "Pa", {{"face", "-", {-1., 1.}}, {"chord", "m", root.chord_position}},
                        [this, n](const std::span<double> values) {
                          std::copy_n(observed.root.stress_struck.begin(), n, values.begin());
                          std::copy_n(observed.root.stress_rear.begin(), n, values.begin() + n);
                        });
  }

  void Recorder::write_fields(const double time)
  {
    if (blade_fields)
      writer.write(*blade_fields, scene.blade->snapshot(), time);
    if (bird_fields && scene.bird)
      writer.write(*bird_fields, scene.bird->snapshot(), time);
    last_field = time;
  }

  bool Recorder::is_due(const double time) const
  {
    return history_ticks.would_be_due(time) || field_ticks.would_be_due(time);
  }

  bool Recorder::record(const double time, const unsigned long n_steps)
  {
    now               = time;
    steps             = n_steps;
    const bool is_row = history_ticks.is_due(time);
    if (is_row)
      {
        history.append_row();
        last_row = time;
      }
    if (field_ticks.is_due(time))
      write_fields(time);
    return is_row;
  }

  void Recorder::finish(const double time, const unsigned long n_steps)
  {
    now   = time;
    steps = n_steps;
    if (last_row < time)
      history.append_row();
    if (last_field < time)
      write_fields(time);
    const RootSectionReport &root = observed.root_at_peak_stress;
    if (!root.chord_position.empty())
      {
        std::vector<double> values = root.stress_struck;
        values.insert(values.end(), root.stress_rear.begin(), root.stress_rear.end());
        history.set_constant("root_normal_stress_at_peak", "Pa",
                             {{"face", "-", {-1., 1.}}, {"chord", "m", root.chord_position}}, std::move(values));
      }
    set_mid_chord_lines();
    history.flush();
    writer.flush();
  }

  void Recorder::set_mid_chord_lines()
  {
    if (!observed.mid_chord)
      return;
    const std::vector<History::Axis> span{{"span", "m", observed.mid_chord->span_position()}};
    if (!observed.mid_chord_at_peak.empty())
      history.set_constant("mid_chord_deflection_at_peak", "m", span, observed.mid_chord_at_peak);
    std::vector<double> now_deflected;
    observed.mid_chord->compute_deflection(now_deflected);
    history.set_constant("mid_chord_deflection_at_end", "m", span, std::move(now_deflected));
  }

  void Recorder::flush_when_due(const double wall)
  {
    if (wall - last_flush < flush_interval)
      return;
    history.flush_table();
    last_flush = wall;
  }

  void Recorder::flush()
  {
    history.flush();
  }
} // namespace birdstrike
