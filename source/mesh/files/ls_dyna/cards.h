#pragma once

#include "mesh/files/file_lines.h"

#include <cstdint>

namespace birdstrike
{
  /// Keyword lines and cards of an LS-DYNA file, without comments, until *END.
  struct LsDynaCards
  {
    using Id = std::int64_t;

    explicit LsDynaCards(const std::string &path) : lines(path)
    {
    }

    /// Columns of an id of a node or element, of another whole number, and of a real number: 8, 10, 16 in the standard
    /// format, at least 10 with I10=Y or '%' after the keyword, 20 with LONG=Y or '+'.
    struct Widths
    {
      std::size_t id = 8, integer = 10, real = 16;
    };

    FileLines                lines;
    std::string              name;  ///< of the keyword: upper case, without '*'
    std::vector<std::string> words; ///< of the name: SET, NODE, LIST, TITLE
    std::size_t              keyword_line = 0;
    Widths                   widths;

    bool next();
    bool is_keyword() const
    {
      return lines.text().starts_with('*');
    }

    /// A field of the card: that of this number between commas, else `width` columns from `first`.
    std::string_view field(std::size_t number, std::size_t first, std::size_t width) const;
    Id               id(const std::size_t k) const
    {
      return lines.integer(field(k, k * widths.id, widths.id));
    }
    Id integer(const std::size_t k) const
    {
      return lines.integer(field(k, k * widths.integer, widths.integer));
    }
    double real(const std::size_t k) const
    {
      return real_at(k, k * widths.real, widths.real);
    }
    /// A real number, also without the E of its exponent, as Fortran writes it: 1.75-1 is 0.175.
    double real_at(std::size_t number, std::size_t first, std::size_t width) const;

    /// The word in a field of width 10, in upper case.
    std::string word(std::size_t k) const;

    bool has_word(const char *word) const; ///< in the keyword's name

  private:
    void parse_keyword();

    Widths standard;
  };
} // namespace birdstrike
