#pragma once

#include "mesh/files/file_lines.h"

#include <string>

namespace birdstrike
{
  /// Words of a VTK legacy file, wherever its lines end; complaints name the line.
  class VtkWords : public FileLines
  {
  public:
    using Id = std::int64_t;
    using FileLines::FileLines;

    /// The next word; empty at the end of the file.
    std::string_view word();

    /// The next word without taking it.
    std::string_view peek();

    /// The rest of the line, without taking it.
    std::string_view rest_of_line() const
    {
      return trim(rest);
    }
    void skip_line(); ///< also where a line is begun: its rest

    std::string_view must_word(); ///< throws InputError at the end of the file
    double           must_number();
    Id               must_id();    ///< a whole number, however it is written: 3, 3.0, 3e0
    std::size_t      must_count(); ///< of things

    void            skip_words(std::size_t n);
    void            skip_lines(std::size_t n); ///< whole ones, from the next on: strings may be empty
    std::vector<Id> must_ids(std::size_t n);

    /// METADATA, which an empty line ends.
    void skip_metadata();

  private:
    std::string_view rest; ///< of the line
  };
} // namespace birdstrike
