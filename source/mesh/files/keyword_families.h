#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace birdstrike
{
  /// What becomes of a keyword of a deck that is not read. Only what leaves nodes, elements and thicknesses as they are
  /// written may be passed over.
  enum class KeywordUse
  {
    passed_over,
    noted, ///< passed over with a word: it ties or loads nodes, or adds mass or stress
    refused
  };

  /// What becomes of keywords, by the words with which they begin.
  class KeywordFamilies
  {
  public:
    struct Beginnings
    {
      KeywordUse  use;
      const char *words; ///< separated by commas
    };
    /// `gap` stands between the words of a keyword.
    KeywordFamilies(char gap, std::initializer_list<Beginnings> table);

    /// That of the longest beginning, up to the end of a word; refused where there is none.
    KeywordUse use_of(std::string keyword) const;

  private:
    char                              gap;
    std::map<std::string, KeywordUse> uses;
  };

  /// Keywords that are noted: a sentence each, however often it stands in the file.
  class NotedKeywords
  {
  public:
    void                     add(const std::string &keyword, std::size_t line);
    std::vector<std::string> sentences() const;

  private:
    struct Places
    {
      std::size_t first = 0, n = 0;
    };
    std::map<std::string, Places> places;
  };
} // namespace birdstrike
