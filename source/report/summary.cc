#include <birdstrike/report/summary.h>

#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace birdstrike
{
  namespace
  {
    /// Keys in the order of the members.
    nlohmann::ordered_json make_json(const Summary &s)
    {
      nlohmann::ordered_json json;
      json["case"]    = s.case_name;
      json["program"] = {{"version", s.program.version}, {"build", s.program.build}};
      json["inputs"]  = nlohmann::ordered_json::array();
      for (const InputFile &file : s.inputs)
        json["inputs"].push_back({{"name", file.name}, {"fingerprint", file.fingerprint}});
      json["end"]     = {{"time", s.end.time}, {"reason", s.end.reason}};
      json["blade"]   = {{"kind", s.blade.kind},
                         {"elements", s.blade.elements},
                         {"nodes", s.blade.nodes},
                         {"mass", s.blade.mass},
                         {"added_rotary_inertia", s.blade.added_rotary_inertia}};
      json["bird"]    = {{"particles", s.bird.particles},
                         {"mass", s.bird.mass},
                         {"kinetic_energy", s.bird.kinetic_energy},
                         {"momentum", s.bird.momentum}};
      json["steps"]   = {{"blade", s.steps.blade}, {"bird", s.steps.bird}};
      json["tip"]     = {{"peak", s.tip.peak}, {"peak_time", s.tip.peak_time}, {"final", s.tip.final}};
      json["root"]    = {{"peak_normal_stress", s.root.peak_normal_stress},
                         {"peak_normal_stress_time", s.root.peak_normal_stress_time},
                         {"peak_moment", s.root.peak_moment},
                         {"peak_force", s.root.peak_force}};
      json["contact"] = {{"impulse", s.contact.impulse},
                         {"peak_force", s.contact.peak_force},
                         {"peak_force_time", s.contact.peak_force_time},
                         {"max_penetration", s.contact.max_penetration},
                         {"max_penetration_over_spacing", s.contact.max_penetration_over_spacing}};
      json["plastic"] = {
        {"max_strain", s.plastic.max_strain}, {"position", s.plastic.position}, {"work", s.plastic.work}};
      json["failed"]           = {{"elements", s.failed.elements},   {"collapsed", s.failed.collapsed},
                                  {"at_root", s.failed.at_root},     {"mass", s.failed.mass},
                                  {"free_mass", s.failed.free_mass}, {"energy", s.failed.energy}};
      json["energy"]           = {{"initial", s.energy.initial},
                                  {"final", s.energy.final},
                                  {"max_relative_error", s.energy.max_relative_error},
                                  {"max_hourglass_over_internal", s.energy.max_hourglass_over_internal},
                                  {"bird_internal", s.energy.bird_internal},
                                  {"parts", nlohmann::ordered_json(s.energy.parts)},
                                  {"error_origins", nlohmann::ordered_json(s.energy.error_origins)}};
      json["momentum"]         = {{"max_relative_error", s.momentum.max_relative_error}};
      json["angular_momentum"] = {{"max_relative_error", s.angular_momentum.max_relative_error}};
      json["retired"] = {{"particles", s.retired.particles}, {"mass", s.retired.mass}, {"energy", s.retired.energy}};
      json["skipped"] = nlohmann::ordered_json::object();
      for (const SkippedWork &work : s.skipped)
        json["skipped"][work.what] = {{"count", work.count}, {"unit", work.unit}, {"saved", work.saved}};
      json["cost"] = {{"wall", s.cost.wall},
                      {"threads", s.cost.threads},
                      {"ns_per_particle_step", s.cost.ns_per_particle_step},
                      {"ns_per_element_step", s.cost.ns_per_element_step},
                      {"peak_memory", s.cost.peak_memory}};
      return json;
    }
  } // namespace

  void to_json(nlohmann::json &json, const Summary &summary)
  {
    json = make_json(summary);
  }

  std::string to_text(const Summary &summary)
  {
    return make_json(summary).dump(2) + "\n";
  }

  std::size_t compute_peak_memory()
  {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux reports kibibytes
  }
} // namespace birdstrike
