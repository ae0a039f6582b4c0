#pragma once

#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/run_folder.h>
#include <birdstrike/report/history.h>
#include <birdstrike/report/summary.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

/// The summary of a run that has not begun.
inline birdstrike::Summary make_empty_summary(const std::string &name)
{
  birdstrike::CaseParameters parameters;
  parameters.name = name;
  const birdstrike::Observed observed;
  const birdstrike::Balance  balance(1.);
  return birdstrike::Summary({parameters, observed, balance, balance, nullptr, nullptr, false});
}

/// A run folder as a run leaves it, without the run: a blade that vibrates about `stays` (m) with a period of 10 ms.
struct RecordedRun
{
  double                        stays     = 0.1;
  double                        peak      = 0.15;
  std::string                   reason    = "end time reached";
  bool                          is_rising = false; ///< at the end, the tip
  std::map<std::string, double> more      = {};    ///< further values by their keys
  std::vector<std::string>      overrides;
  std::string                   kind   = "shell";
  std::map<std::string, double> metals = {}; ///< their yield stresses, Pa
  std::vector<std::string>      warnings;    ///< their codes
  std::string                   channel_class = "CFC 1000";
  std::vector<double>           plastic_work; ///< J, at the start and since; empty: the history does not have it

  birdstrike::Summary make_summary(const std::string &name) const
  {
    birdstrike::Summary made = make_empty_summary(name);
    auto               &json = made.json;
    json["end"]["reason"]    = reason;
    json["blade"]["kind"]    = kind;
    if (!metals.empty())
      json["blade"]["materials"].clear();
    for (const auto &[metal, stress] : metals)
      json["blade"]["materials"].push_back({{"name", metal}, {"yield_stress", stress}});
    for (const std::string &code : warnings)
      json["warnings"].push_back({{"code", code}, {"text", "Something is doubtful."}});
    json["contact"]["filtered"]["class"] = channel_class;
    json["tip"]["peak"]                  = peak;
    json["tip"]["peak_reached"]          = !is_rising;
    json["contact"]["impulse"]           = {3., 0., -4.};
    json["energy"]["parts"]              = {{"blade_elastic", 2.}, {"blade_plastic", 40.}, {"bird_kinetic", 1000.}};
    json["root"]["peak_normal_stress"]   = 9e8;
    for (const auto &[key, value] : more)
      json[nlohmann::ordered_json::json_pointer("/" + key)] = value;
    return made;
  }

  void write_history(const std::filesystem::path &folder) const
  {
    double              t = 0.;
    birdstrike::History history(folder, true);
    const auto          phase = [&t] { return 2. * std::numbers::pi * t / 10e-3; };
    history.add_column({"time", "s"}, [&] { return t; });
    history.add_column({"tip_mid_chord", "m"}, [&] { return stays - (peak - stays) * std::cos(phase()); });
    history.add_column({"root_bending_moment", "N m"}, [&] { return 400. * std::sin(phase()); });
    history.add_column({"blade_kinetic", "J"}, [&] { return t == 0. ? 2.5 : 1.; });
    if (!plastic_work.empty())
      {
        history.add_column({"blade_plastic", "J"},
                           [&] { return t == 0. ? plastic_work.front() : plastic_work.back(); });
        history.add_column({"blade_eroded", "J"}, [] { return 0.; });
      }
    for (const std::string axis : {"x", "y", "z"})
      history.add_column({"contact_force_" + axis, "N"}, [] { return 1000.; });
    history.add_column({"contact_force_peak", "N"}, [] { return 1000. * std::sqrt(3.); });
    for (int row = 0; row < 2600; ++row)
      {
        t = row * 10e-6;
        history.append_row();
      }
    history.set_constant({"root_normal_stress_at_peak", "Pa"},
                         {{{"face", "-"}, {-1., 1.}}, {{"chord", "m"}, {-0.01, 0.01}}}, {1e8, 2e8, -1e8, -2e8});
    history.set_constant({"mid_chord_deflection_at_peak", "m"}, {{{"span", "m"}, {0., 0.3}}}, {0., peak});
  }

  /// `prm`: the file that the run is said to have been made of.
  void write(const std::filesystem::path &folder, const std::string &prm) const
  {
    birdstrike::CaseParameters parameters;
    parameters.read(prm, overrides);
    birdstrike::RunFolder run(folder);
    run.write_text("parameters.prm", parameters.file.as_prm());
    write_history(folder);
    birdstrike::Summary made = make_summary(parameters.name);
    made.set_inputs(list_input_files(parameters));
    run.finish(to_text(made));
  }
};
