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
    constexpr double same_share = 0.01; ///< facets and a coarse profile change all sections nearly alike

    struct Range
    {
      double smallest = std::numeric_limits<double>::infinity(), largest = 0.;

      void hold(const double value)
      {
        smallest = std::min(smallest, value);
        largest  = std::max(largest, value);
      }
    };

    struct SectionRange
    {
      Range mass, share; ///< kg; of the blade's
    };

    /// Of blades of several sections.
    std::map<unsigned int, SectionRange> read_masses(const std::vector<std::filesystem::path> &folders)
    {
      std::map<unsigned int, SectionRange> sections;
      for (const std::filesystem::path &folder : folders)
        {
          const RunRecord record = read_record(folder);
          const auto      number = [&](const unsigned int k, const char *key) {
            return record.summary().number(fmt::format("blade/sections/{}/{}", k, key));
          };
          if (std::isnan(number(1, "mass")))
            continue;
          for (unsigned int k = 0; std::isfinite(number(k, "mass")); ++k)
            {
              SectionRange &range = sections[static_cast<unsigned int>(number(k, "section"))];
              range.mass.hold(number(k, "mass"));
              range.share.hold(number(k, "mass") / record.summary().number("blade/mass"));
            }
        }
      return sections;
    }
  } // namespace

  std::string describe_changing_sections(const std::vector<std::filesystem::path> &folders)
  {
    std::string text;
    for (const auto &[section, range] : read_masses(folders))
      if (range.share.largest > (1. + same_share) * range.share.smallest)
        text += (text.empty() ? "" : ", ") + fmt::format("section {} {} to {}", section,
                                                         format_value(range.mass.smallest, "kg"),
                                                         format_value(range.mass.largest, "kg"));
    return text.empty() ? text
                        : "The levels are not of one blade, and no bar is that of the mesh: " + text +
                            ". Blade/Mesh/Material boxes take whole elements by their centres.\n  Action: "
                            "Blade/Mesh/Material patches, on whose borders lines of nodes lie.\n";
  }
} // namespace birdstrike
