#include "mesh/files/keyword_families.h"

#include "mesh/files/file_lines.h"

#include <algorithm>

namespace birdstrike
{
  KeywordFamilies::KeywordFamilies(const char gap, const std::initializer_list<Beginnings> table) : gap(gap)
  {
    for (const auto &[use, words] : table)
      for (std::string_view rest = words; !rest.empty();)
        {
          const std::size_t comma = std::min(rest.find(','), rest.size());
          std::string       name(trim(rest.substr(0, comma)));
          uses.emplace(name, use);
          std::erase(name, ' '); // CalculiX takes both
          uses.emplace(name, use);
          rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
  }

  KeywordUse KeywordFamilies::use_of(std::string keyword) const
  {
    while (!keyword.empty())
      {
        if (const auto found = uses.find(keyword); found != uses.end())
          return found->second;
        const std::size_t end = keyword.rfind(gap);
        keyword.erase(end == keyword.npos ? 0 : end);
      }
    return KeywordUse::refused;
  }

  void NotedKeywords::add(const std::string &keyword, const std::size_t line)
  {
    Places &found = places[keyword];
    if (found.n++ == 0)
      found.first = line;
  }

  std::vector<std::string> NotedKeywords::sentences() const
  {
    std::vector<std::string> all;
    for (const auto &[keyword, where] : places)
      all.push_back("*" + keyword + " in line " + std::to_string(where.first) +
                    (where.n > 1 ? " (" + std::to_string(where.n) + " in all)" : std::string()) +
                    " is not read. Is the blade tied, stressed, loaded or cut by it? Then give that in Blade/Supports "
                    "or Blade/Loads.");
    return all;
  }
} // namespace birdstrike
