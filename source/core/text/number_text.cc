#include <birdstrike/core/text/number_text.h>

#include <fmt/format.h>

namespace birdstrike
{
  std::string number_text(const double value)
  {
    return fmt::format("{:.6g}", value);
  }

  std::string point_text(const double *const position)
  {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", position[0], position[1], position[2]);
  }
} // namespace birdstrike
