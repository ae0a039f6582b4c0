#pragma once

#include "mesh/files/file_lines.h"

#include <cstdlib>

namespace birdstrike
{
  /// Lines of a section of Gmsh's format.
  class GmshLines : public FileLines
  {
  public:
    using Fields = std::vector<std::string_view>;

    static constexpr std::size_t any = -1;

    using FileLines::FileLines;

    /// The fields of the next line, of which there must be so many.
    Fields take(const std::size_t at_least, const std::string &what, const std::size_t at_most = any)
    {
      if (!next())
        refuse("the file ends in " + what, "Save the mesh again.");
      Fields fields = split_at_blanks();
      if (fields.size() < at_least || fields.size() > at_most || fields[0].starts_with('$'))
        refuse("'" + std::string(text()).substr(0, 80) + "' stands where " + what + " must go on",
               "A line too few or too many, or a wrong number of them? Save the mesh again.");
      return fields;
    }

    std::int64_t count(const std::string_view field) const
    {
      const std::int64_t n = integer(field);
      if (n < 0)
        refuse("the number " + std::to_string(n) + " of things is negative", "Save the mesh again.");
      return n;
    }

    /// Of a physical group, without its sign: a negative one runs against its entity.
    std::int64_t group_number(const std::string_view field) const
    {
      constexpr std::int64_t beyond_all = -2'000'000'001;
      return std::abs(std::max(integer(field), beyond_all));
    }
  };
} // namespace birdstrike
