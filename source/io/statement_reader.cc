#include "io/statement_reader.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    /// Removes the '\\' at the end of a line; false where there is none.
    bool take_mark(std::string &line)
    {
      const std::size_t last = line.find_last_not_of(" \t");
      if (last == std::string::npos || line[last] != '\\')
        return false;
      line.erase(last);
      return true;
    }
  } // namespace

  StatementReader::StatementReader(const std::string &text) : text(text)
  {
  }

  bool StatementReader::next(std::string &statement)
  {
    if (at >= text.size())
      return false;
    line      = n_lines + 1;
    begin     = at;
    statement = read_line();
    while (take_mark(statement) && at < text.size())
      {
        std::string more = read_line();
        while (is_comment_alone && at < text.size())
          more = read_line();
        statement += more.substr(std::min(more.find_first_not_of(" \t"), more.size()));
      }
    return true;
  }

  std::string StatementReader::read_line()
  {
    end                    = std::min(text.find_first_of("\n\r", at), text.size());
    const std::string line = text.substr(at, end - at);
    at                     = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    ++n_lines;
    const std::size_t mark = line.find('#');
    is_comment_alone       = mark != std::string::npos && line.find_first_not_of(" \t") == mark;
    return line.substr(0, mark);
  }
} // namespace birdstrike
