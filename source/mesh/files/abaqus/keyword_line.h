#pragma once

#include "mesh/files/file_lines.h"

#include <map>

namespace birdstrike
{
  /// A keyword line of an Abaqus file with its options, those of the lines that continue it too.
  struct AbaqusKeyword
  {
    std::string                        name;    ///< upper case, single blanks
    std::map<std::string, std::string> options; ///< names in upper case, values as given without quotes

    bool has(const std::string &option) const
    {
      return options.count(option) > 0;
    }
    std::string value(const std::string &option) const
    {
      const auto found = options.find(option);
      return found != options.end() ? found->second : "";
    }
  };

  /// The present line begins it; takes the lines that follow a comma at the end.
  AbaqusKeyword parse_abaqus_keyword(FileLines &lines);
} // namespace birdstrike
