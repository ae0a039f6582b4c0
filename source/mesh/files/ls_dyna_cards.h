#pragma once

#include "mesh/files/file_lines.h"

#include <cstdint>

namespace birdstrike
{
  /// Keyword lines and cards of an LS-DYNA file, without comments, until *END.
  class LsDynaCards
  {
  public:
    explicit LsDynaCards(const std::string &path) : lines(path)
    {
    }

  protected:
    using Id = std::int64_t;

    /// Columns of an id of a node or element, of another whole number, and of a real number: 8, 10, 16 in the standard
    /// format, at least 10 with I10=Y or '%' after the keyword, 20 with LONG=Y or '+'.
    struct Widths
    {
      std::size_t id = 8, integer = 10, real = 16;
    };

    FileLines                lines;
    std::string              name;  ///< of the keyword: upper case, without '*'
    std::vector<std::string> words; ///< of the name: SET, NODE, LIST, TITLE
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
      return lines.number(field(k, k * widths.real, widths.real));
    }

  private:
    void parse_keyword();

    Widths standard;
  };
} // namespace birdstrike
