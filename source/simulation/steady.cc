#include "simulation/read_case.h"
#include "simulation/warnings/equilibrium_warning.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/fields.h>
#include <birdstrike/io/report_folder.h>
#include <birdstrike/io/varied_entry.h>
#include <birdstrike/report/text.h>
#include <birdstrike/report/vibration.h>
#include <birdstrike/structure/make_blade.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>

/// Verbs that compute the blade at rest on its hub: static equilibrium and modes.
namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    fs::path folder_of(const CaseRequest &request, const char *verb)
    {
      return request.output.empty() ? fs::path("runs") / verb / fs::path(request.prm_file).stem()
                                    : fs::path(request.output);
    }

    /// The case's blade, with the folder's entry left alone and no bird.
    struct SteadyBlade
    {
      CaseParameters            parameters;
      std::string               why_side_unknown; ///< that the bird strikes
      std::optional<ThreadPool> pool;
      std::unique_ptr<Blade>    blade;

      explicit SteadyBlade(const CaseRequest &request)
      {
        why_side_unknown = read_blade(parameters, request);
        pool.emplace(parameters.time.n_threads());
        blade = make_blade(parameters.blade, *pool);
        if (!blade)
          throw InputError("Blade/Kind is none: there is no blade to analyse.\nSet it to shell or solid.");
      }
    };

    std::string to_text(const StaticReport &report, const Blade &blade, const double speed)
    {
      const RootSectionReport root   = blade.root_section();
      const TipDeflection     tip    = blade.tip_deflection();
      const EnergyReport      energy = blade.energies();
      TextTable               table("Static equilibrium");
      table.add("speed of the hub", fmt::format("{:.6g} rad/s", speed));
      table.add("unknowns", format_count(report.n_unknowns));
      table.add("load steps, iterations", fmt::format("{}, {}", report.n_load_steps, report.n_iterations));
      if (report.n_linear_iterations > 0)
        table.add("  of multigrid, in all", format_count(report.n_linear_iterations));
      std::string falling;
      for (const double r : report.residuals)
        falling += fmt::format("{}{:.2g}", falling.empty() ? "" : ", ", r);
      table.add("forces left over, last step", falling + " of loads and spin");
      table.add("stability", describe_stability(report));
      table.add("tip deflection, mid-chord", tip.mid_chord, "m");
      table.add("  leading, trailing edge",
                format_quantity(tip.leading, "m") + ", " + format_quantity(tip.trailing, "m"));
      table.add("root: normal force", root.normal_force, "N");
      table.add("root: transverse force", root.transverse_force, "N");
      table.add("root: bending moment", root.bending_moment, "N m");
      table.add("root: largest normal stress", root.peak_stress(), "Pa");
      table.add("largest plastic strain", find_largest(blade.peak_plastic_strains()).value, "-");
      table.add("stored energy", energy.elastic, "J");
      return table.text();
    }

    std::string to_json(const StaticReport &report, const Blade &blade, const double speed)
    {
      const RootSectionReport root = blade.root_section();
      const TipDeflection     tip  = blade.tip_deflection();
      nlohmann::ordered_json  json;
      json["speed"]     = {{"value", speed}, {"unit", "rad/s"}};
      json["solve"]     = {{"unknowns", report.n_unknowns},
                           {"load_steps", report.n_load_steps},
                           {"iterations", report.n_iterations},
                           {"linear_iterations", report.n_linear_iterations},
                           {"residuals", report.residuals}};
      json["stability"] = {{"is_stable", nullptr}, {"unstable_directions", nullptr}};
      if (report.n_unstable)
        json["stability"] = {{"is_stable", *report.n_unstable == 0}, {"unstable_directions", *report.n_unstable}};
      json["tip"] = {{"mid_chord", tip.mid_chord}, {"leading", tip.leading}, {"trailing", tip.trailing}, {"unit", "m"}};
      json["root"]               = {{"normal_force", root.normal_force},
                                    {"transverse_force", root.transverse_force},
                                    {"bending_moment", root.bending_moment},
                                    {"peak_normal_stress", root.peak_stress()},
                                    {"units", "N, N, N m, Pa"}};
      json["max_plastic_strain"] = find_largest(blade.peak_plastic_strains()).value;
      json["elastic_energy"]     = {{"value", blade.energies().elastic}, {"unit", "J"}};
      for (const ProbeValues &probe : blade.probes())
        json["probes"][probe.name] = {
          {"position", probe.position}, {"displacement", probe.displacement}, {"unit", "m"}};
      return json.dump(2) + "\n";
    }

    /// Of an earlier analysis in the same folder, which may have had more speeds.
    void remove_shapes(const fs::path &folder)
    {
      for (const fs::path &where : {folder, folder / "fields"})
        if (std::error_code none; fs::is_directory(where, none))
          for (const auto &entry : fs::directory_iterator(where))
            if (const std::string name = entry.path().filename().string();
                name.starts_with("modes") && (name.ends_with(".pvd") || name.ends_with(".vtu")))
              fs::remove(entry.path(), none);
    }

    /// The deformed blade with the shapes as further fields.
    FieldSnapshot show_shapes(const Blade &blade, const VibrationModes &modes, const std::size_t n)
    {
      FieldSnapshot snapshot = blade.snapshot();
      for (std::size_t k = 0; k < std::min(n, modes.modes.size()); ++k)
        snapshot.fields.push_back({fmt::format("mode_{}", k + 1), "-", false, 3, modes.modes[k].shape});
      return snapshot;
    }
  } // namespace

  void run_static(const CaseRequest &request)
  {
    const ReportKind kind{"static solve", {"static"}};
    const fs::path   output = folder_of(request, "static");
    ReportFolder::require_usable(output, kind);
    SteadyBlade        steady(request);
    const double       speed  = Rotor(steady.parameters.blade.spin).speed(0.);
    const StaticReport report = steady.blade->find_equilibrium();
    if (report.n_unknowns == 0)
      throw InputError("Nothing loads the blade at t = 0: it does not deform.\nSet Blade/Spin/Speed or Blade/Loads to "
                       "a value that is not zero then.");
    if (!steady.why_side_unknown.empty())
      log().warn("Warning: The bird does not tell which side is struck. Deflection and root moment have the signs of a "
                 "blade without a bird. Reason: {}",
                 steady.why_side_unknown.substr(0, steady.why_side_unknown.find('\n')));
    const ReportFolder folder(output, kind);
    folder.write_text("static.json", to_json(report, *steady.blade, speed));
    FieldSeries(folder.path(), "blade").write(steady.blade->snapshot(), 0.);
    log().info("{}", to_text(report, *steady.blade, speed));
    Warnings warnings;
    check_equilibrium(report, steady.blade->rotor() != nullptr, warnings);
    for (const Warning &warning : warnings)
      log().warn("Warning: {} [{}]", warning.text, warning.code);
    log().info("Static equilibrium in {}", folder.path().string());
  }

  void run_modes(const ModesRequest &request)
  {
    const ReportKind kind{"modal analysis", {"modes", "campbell"}};
    const fs::path   output = folder_of(request.of_case, "modes");
    ReportFolder::require_usable(output, kind);
    remove_shapes(output);
    std::vector<std::string> speeds{""};
    if (!request.speeds.empty())
      speeds = read_varied_entry("Blade/Spin/Speed=" + request.speeds).values;
    std::optional<ReportFolder> folder;
    std::vector<ModesAtSpeed>   all;
    for (const std::string &speed : speeds)
      {
        CaseRequest of_speed = request.of_case;
        if (!speed.empty())
          of_speed.overrides.push_back("Blade/Spin/Speed=" + speed);
        SteadyBlade steady(of_speed);
        if (steady.parameters.blade.is_halved)
          throw InputError(
            "Case/Symmetry plane: half a blade has half of its modes, those that mirror into themselves.\n"
            "Set it to none.");
        steady.blade->find_equilibrium();
        all.push_back({Rotor(steady.parameters.blade.spin).speed(0.),
                       steady.blade->compute_modes(request.n_modes, n_spare_modes(request.n_modes, speeds.size()))});
        if (!folder)
          folder.emplace(output, kind);
        FieldSeries(folder->path(), speeds.size() == 1 ? "modes" : fmt::format("modes_{}", all.size()))
          .write(show_shapes(*steady.blade, all.back().modes, request.n_modes), 0.);
        log().info("{}", describe_modes(all.back(), request.n_modes));
      }
    for (const std::string &sentence : write_modes(*folder, all, request.n_modes))
      log().warn("Warning: {}", sentence);
    log().info("Modes in {}", folder->path().string());
  }
} // namespace birdstrike
