#include <birdstrike/core/step_limit.h>

#include <fmt/format.h>

namespace birdstrike
{
  std::string EntityPlace::text() const
  {
    return kind ? fmt::format("{} {} at ({:.4g}, {:.4g}, {:.4g})", kind, id, position[0], position[1], position[2])
                : "";
  }
} // namespace birdstrike
