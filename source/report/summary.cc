#include "report/quantities.h"
#include "report/run_warnings.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/material/metal_constants.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/structure/blade.h>

#include <sys/resource.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    using Json    = nlohmann::ordered_json;
    using Pointer = Json::json_pointer;

    Json value_of(const Quantity &quantity, const RunView &run)
    {
      return std::visit(
        [&](const auto &source) -> Json {
          if constexpr (std::is_same_v<std::decay_t<decltype(source)>, const LedgerEntry *>)
            return source->value(run.shown.state());
          else if constexpr (std::is_same_v<std::decay_t<decltype(source(run))>, std::optional<bool>>)
            {
              const std::optional<bool> truth = source(run);
              return truth ? Json(*truth) : Json();
            }
          else
            return source(run);
        },
        quantity.value);
    }

    Json describe_laminate(const std::size_t section, const LaminateParameters &laminate)
    {
      Json json{{"section", section}, {"plies", laminate.plies}, {"n_plies", laminate.layers().size()}};
      if (laminate.can_fail())
        json["degradation_time"] = laminate.degradation_time;
      for (const PlyMaterial &material : laminate.stack().materials)
        for (const MetalConstant &constant : constants_in_use(material.ply))
          (material.name.empty() ? json["ply"] : json["materials"][material.name])[constant.key] = constant.value;
      return json;
    }

    /// A value by its path, or nullptr.
    const Json *find(const Json &json, const std::string &key)
    {
      const Pointer pointer("/" + key);
      return json.contains(pointer) ? &json.at(pointer) : nullptr;
    }
  } // namespace

  namespace
  {
    using AimValue = std::tuple<const char *, const char *, Json>; // key, unit, value

    std::vector<AimValue> values_of(const StrikeAim &aim)
    {
      std::vector<AimValue> values{{"point", "m", aim.point},
                                   {"span", "share", aim.span},
                                   {"chord", "share", aim.chord},
                                   {"velocity", "m/s", aim.velocity},
                                   {"speed", "m/s", aim.speed},
                                   {"angle", "degree", aim.angle},
                                   {"normal_speed", "m/s", aim.normal_speed},
                                   {"hugoniot_pressure", "Pa", aim.hugoniot_pressure},
                                   {"stagnation_pressure", "Pa", aim.stagnation_pressure},
                                   {"duration", "s", aim.duration}};
      if (!std::isnan(aim.arrival))
        {
          values.push_back({"position", "m", aim.position});
          values.push_back({"arrival_time", "s", aim.arrival});
        }
      return values;
    }

    /// Each bird of several, in SI units as "bird", "aim" and "contact" have them for all.
    Json values_of(const std::vector<BirdOfRun> &birds)
    {
      Json all = Json::array();
      for (const BirdOfRun &each : birds)
        {
          Json aim = Json::object();
          for (const auto &[key, unit, value] : values_of(each.aim))
            aim[key] = value;
          all.push_back({{"number", each.number},
                         {"particles", each.at_start.particles},
                         {"mass", each.at_start.mass},
                         {"kinetic_energy", each.at_start.kinetic_energy},
                         {"momentum", each.at_start.momentum},
                         {"arrival_time", each.arrival},
                         {"impulse", each.impulse},
                         {"aim", aim}});
        }
      return all;
    }

    /// Each blade of a row, in SI units.
    Json values_of_row(const Blade &blade, const std::vector<BladePeaks> &peaks)
    {
      Json all = Json::array();
      for (const BladeBalance &of : blade.balance_of_row())
        {
          Json member = {{"place", of.place}, {"rigid", of.is_rigid}, {"impulse", of.impulse}};
          for (const BladePeaks &peak : peaks)
            if (peak.place == of.place)
              member.update({{"tip_peak", peak.tip.value()},
                             {"root_peak_moment", peak.root_moment.value()},
                             {"root_peak_stress", peak.root_stress.value()},
                             {"plastic_work", of.energies.plastic}});
          all.push_back(member);
        }
      return all;
    }
  } // namespace

  void Summary::add_aim(const StrikeAim &aim)
  {
    for (const auto &[key, unit, value] : values_of(aim))
      {
        json["aim"][key]                         = value;
        json["units"]["aim/" + std::string(key)] = unit;
      }
  }

  Summary::Summary(const RunView &run)
  {
    json["schema"] = schema;
    json["case"]   = nullptr;
    for (const char *object :
         {"units", "program", "inputs", "end", "blade", "bird", "aim", "steps", "tip", "root", "contact", "plastic",
          "failed", "energy", "momentum", "angular_momentum", "retired", "skipped", "cost"})
      json[object] = Json::object();
    json["inputs"] = Json::array();

    add_aim(run.aim);
    if (run.birds.size() > 1)
      json["birds"] = values_of(run.birds);
    std::map<std::string, Json> parts; // by name
    const std::string           of_part = "energy/parts/";
    for (const Quantity &each : quantities())
      if (!each.key.empty() && !each.unit.empty())
        json["units"][each.key] = each.unit;
    for (const Quantity &each : quantities())
      if (each.key.starts_with(of_part))
        parts[each.key.substr(of_part.size())] = value_of(each, run);
      else if (!each.key.empty())
        json[Pointer("/" + each.key)] = value_of(each, run);
    json["energy"]["parts"]         = parts;
    const Balance::Origins from     = run.balance.origins();
    json["energy"]["error_origins"] = {
      {"bird", from.bird}, {"blade", from.blade}, {"contact", from.contact}, {"steps", from.steps}};
    for (const auto &[origin, energy] : json["energy"]["error_origins"].items())
      json["units"]["energy/error_origins/" + origin] = "J";
    if (!run.observed.row.empty())
      json["blade"]["row"] = values_of_row(*run.blade, run.observed.row);
    if (run.blade)
      for (const SectionCensus &section : run.blade->census().sections)
        json["blade"]["sections"].push_back({{"section", section.number},
                                             {"elements", section.n_elements},
                                             {"mass", section.mass},
                                             {"plastic_work", section.plastic_work}});
    if (run.parameters.blade.is_deformable())
      for (const auto &[number, of_section] : run.parameters.blade.by_section())
        {
          if (of_section.is_laminate())
            {
              json["blade"]["laminates"].push_back(describe_laminate(number, of_section.laminate));
              continue;
            }
          const Metal metal     = of_section.material.metal();
          Json        constants = {{"section", number}, {"name", metal.name}, {"hardening", hardening_name(metal)}};
          for (const MetalConstant &constant : constants_in_use(metal))
            constants[constant.key] = constant.value;
          json["blade"]["materials"].push_back(constants);
        }
    json["warnings"] = Json::array();
    for (const Warnings &each : {run.case_warnings, find_run_warnings(run)})
      for (const Warning &warning : each)
        json["warnings"].push_back({{"code", warning.code}, {"text", warning.text}});
    json["steps"]["limited_by"] = Json::array();
    for (const StepLimiters::Limiter &limiter : run.limiters)
      {
        json["steps"]["limited_by"].push_back({{"reason", limiter.reason},
                                               {"steps", limiter.n_steps},
                                               {"smallest_step", limiter.step},
                                               {"time", limiter.time}});
        if (!limiter.kind.empty())
          json["steps"]["limited_by"].back().update(
            {{"entity", limiter.kind}, {"id", limiter.id}, {"position", limiter.position}});
      }
    for (const SkippedWork &work : run.skipped)
      json["skipped"][work.what] = {{"count", work.count}, {"unit", work.unit}, {"saved", work.saved}};
  }

  Warnings Summary::warnings() const
  {
    Warnings all;
    for (std::size_t k = 0;; ++k)
      {
        const std::string key  = "warnings/" + std::to_string(k);
        const std::string code = text(key + "/code");
        if (code.empty())
          return all;
        all.push_back({code, text(key + "/text")});
      }
  }

  void Summary::set_inputs(const std::vector<InputFile> &files)
  {
    for (const InputFile &file : files)
      {
        json["inputs"].push_back(
          {{"name", file.name}, {"fingerprint", file.fingerprint}, {"role", file.is_included ? "include" : "entry"}});
        if (!file.copy.empty())
          json["inputs"].back()["copy"] = file.copy;
      }
  }

  double Summary::number(const std::string &key) const
  {
    const Json *value = find(json, key);
    return value && value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
  }

  std::string Summary::text(const std::string &key) const
  {
    const Json *value = find(json, key);
    return value && value->is_string() ? value->get<std::string>() : "";
  }

  bool Summary::is_false(const std::string &key) const
  {
    const Json *value = find(json, key);
    return value && value->is_boolean() && !value->get<bool>();
  }

  std::string to_text(const Summary &summary)
  {
    return summary.json.dump(2) + "\n";
  }

  std::size_t compute_peak_memory()
  {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux reports kibibytes
  }
} // namespace birdstrike
