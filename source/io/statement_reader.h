#pragma once

#include <cstddef>
#include <string>

namespace birdstrike
{
  /// The statements of a parameter file: its lines without comments, joined where one ends in '\\'. A comment ends with
  /// its line, whatever its last letter is; a line that is nothing but a comment does not end a statement that goes on.
  /// Ends of lines are those of Unix, of Windows (a CR before it) and of old Macs (the CR alone).
  class StatementReader
  {
  public:
    explicit StatementReader(const std::string &text);

    unsigned int line  = 0;          ///< in which the statement begins
    std::size_t  begin = 0, end = 0; ///< of its lines in the text, without the last line's end

    bool next(std::string &statement); ///< false after the last one

  private:
    const std::string &text;
    std::size_t        at               = 0;
    unsigned int       n_lines          = 0;
    bool               is_comment_alone = false;

    std::string read_line();
  };
} // namespace birdstrike
