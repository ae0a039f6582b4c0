#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/program.h>
#include <birdstrike/report/failure_record.h>

#include <nlohmann/json.hpp>

namespace birdstrike
{
  std::string make_failure_record(const FailureFacts &facts)
  {
    using Json         = nlohmann::ordered_json; // writes numbers that are none as null
    const auto or_null = [](const auto &value) { return value ? Json(*value) : Json(); };
    const auto text    = [](const std::string &value) { return value.empty() ? Json() : Json(value); };
    Json       json;
    json["schema"]   = 1;
    json["program"]  = {{"version", program_identity().version}, {"build", program_identity().build}};
    json["what"]     = facts.what;
    json["quantity"] = text(facts.quantity);
    json["value"]    = facts.quantity.empty() ? Json() : Json(facts.value);
    json["unit"]     = text(facts.unit);
    json["limit"]    = facts.limit;
    json["time"]     = or_null(facts.time);
    json["step"]     = or_null(facts.step);
    json["entity"]   = nullptr;
    if (facts.where.kind)
      json["entity"] = {{"kind", facts.where.kind}, {"id", facts.where.id}, {"position", facts.where.position}};
    json["checkpoint"] = text(facts.checkpoint);
    json["message"]    = facts.text();
    return json.dump(2) + "\n";
  }
} // namespace birdstrike
