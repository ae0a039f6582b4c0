#include <birdstrike/core/step_limit.h>

#include <fmt/format.h>

namespace birdstrike
{
  std::string EntityPlace::text() const
  {
    return kind ? fmt::format("{} {} at ({:.4g}, {:.4g}, {:.4g})", kind, id, position[0], position[1], position[2])
                : "";
  }

  std::string StepLimit::text() const
  {
    return reason + (where.kind ? ", " + where.text() : "");
  }

  std::string StepLimit::brief() const
  {
    const std::string words = reason, part = words.substr(0, words.find(','));
    return !where.kind                  ? part
           : part.ends_with(where.kind) ? fmt::format("{} {}", part, where.id)
                                        : fmt::format("{}, {} {}", part, where.kind, where.id);
  }
} // namespace birdstrike
