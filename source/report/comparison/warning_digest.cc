#include "report/comparison/warning_digest.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t most_names = 8; ///< in a line

    std::vector<std::string> codes_of(const Warnings &warnings)
    {
      std::vector<std::string> codes;
      for (const Warning &each : warnings)
        if (std::ranges::find(codes, each.code) == codes.end())
          codes.push_back(each.code);
      return codes;
    }

    std::string make_line(const std::string &code, const std::vector<WarnedRun> &runs)
    {
      std::vector<std::string> names;
      std::string              text;
      for (const WarnedRun &run : runs)
        if (const auto found = std::ranges::find(run.warnings, code, &Warning::code); found != run.warnings.end())
          {
            if (names.empty())
              text = found->text;
            names.push_back(run.name);
          }
      if (names.size() == 1)
        return code + " at " + names[0] + ": " + text;
      std::string where = names[0];
      for (std::size_t k = 1; k < std::min(names.size(), most_names); ++k)
        where += "; " + names[k];
      if (names.size() == runs.size())
        where = fmt::format("all {}", runs.size());
      else if (names.size() > most_names)
        where += fmt::format(" and {} more", names.size() - most_names);
      return code + " at " + where + ". At " + names[0] + ": " + text;
    }
  } // namespace

  std::string list_codes(const Warnings &warnings)
  {
    std::string text;
    for (const std::string &code : codes_of(warnings))
      text += (text.empty() ? "" : " ") + code;
    return text;
  }

  std::vector<std::string> digest_warnings(const std::vector<WarnedRun> &runs)
  {
    Warnings all;
    for (const WarnedRun &run : runs)
      all.insert(all.end(), run.warnings.begin(), run.warnings.end());
    std::vector<std::string> lines;
    for (const std::string &code : codes_of(all))
      lines.push_back(make_line(code, runs));
    return lines;
  }
} // namespace birdstrike
