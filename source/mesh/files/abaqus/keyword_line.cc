#include "mesh/files/abaqus/keyword_line.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::string with_single_blanks(std::string text)
    {
      std::replace(text.begin(), text.end(), '\t', ' ');
      text.erase(std::unique(text.begin(), text.end(), [](const char a, const char b) { return a == ' ' && b == ' '; }),
                 text.end());
      return text;
    }
  } // namespace

  AbaqusKeyword parse_abaqus_keyword(FileLines &lines)
  {
    std::string text(trim(lines.text()));
    while (text.ends_with(',') && lines.next())
      text += trim(lines.text());
    AbaqusKeyword keyword;
    for (std::string_view rest = std::string_view(text).substr(1); !rest.empty();)
      {
        const std::size_t      comma  = std::min(rest.find(','), rest.size());
        const std::string_view piece  = rest.substr(0, comma);
        const std::size_t      equals = std::min(piece.find('='), piece.size());
        const std::string      key    = with_single_blanks(upper(trim(piece.substr(0, equals))));
        std::string_view       value  = trim(piece.substr(std::min(equals + 1, piece.size())));
        if (value.size() > 1 && value.front() == '"' && value.back() == '"')
          value = value.substr(1, value.size() - 2);
        if (keyword.name.empty())
          keyword.name = key;
        else
          keyword.options[key] = value;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
      }
    return keyword;
  }
} // namespace birdstrike
