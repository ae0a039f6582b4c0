#include "report/study/section_masses.h"
#include "report/comparison/case_run.h"
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace birdstrike
{
  namespace
  {
    constexpr double same_blade = 0.01; ///< facets of curved blades have less mass than this less

    struct Range
    {
      double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
    };

    std::map<unsigned int, Range> read_masses(const std::vector<std::filesystem::path> &folders)
    {
      std::map<unsigned int, Range> masses; // kg
      for (const std::filesystem::path &folder : folders)
        {
          const RunRecord record = read_record(folder);
          const Summary  &of_run = record.summary();
          for (unsigned int k = 0; std::isfinite(of_run.number(fmt::format("blade/sections/{}/mass", k))); ++k)
            {
              const double mass = of_run.number(fmt::format("blade/sections/{}/mass", k));
              Range       &range =
                masses[static_cast<unsigned int>(of_run.number(fmt::format("blade/sections/{}/section", k)))];
              range.smallest = std::min(range.smallest, mass);
              range.largest  = std::max(range.largest, mass);
            }
        }
      return masses;
    }
  } // namespace

  std::string describe_changing_sections(const std::vector<std::filesystem::path> &folders)
  {
    std::string text;
    for (const auto &[section, mass] : read_masses(folders))
      if (mass.largest > (1. + same_blade) * mass.smallest)
        text +=
          (text.empty() ? "" : ", ") + fmt::format("section {} {} to {}", section, format_value(mass.smallest, "kg"),
                                                   format_value(mass.largest, "kg"));
    return text.empty() ? text
                        : "The levels are not of one blade, and no bar is that of the mesh: " + text +
                            ". Blade/Mesh/Material boxes take whole elements by their centres.\n  Action: "
                            "Blade/Mesh/Material patches, on whose borders lines of nodes lie.\n";
  }
} // namespace birdstrike
