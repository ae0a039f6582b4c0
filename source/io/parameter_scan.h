#pragma once

#include "io/parameter_tree.h"

#include <string>
#include <vector>

namespace birdstrike
{
  /// Where a value was read: a line of a file, or an override of the command line (line 0).
  struct SourceLine
  {
    std::string  file;
    unsigned int line = 0;

    /// "frontal.prm, line 17" or "--set Bird/Mass=2".
    std::string text() const;
  };

  /// One `set Entry = value`.
  struct Assignment
  {
    SectionPath section;
    std::string name;
    std::string value;
    SourceLine  where;
  };

  /// Reads deal.II's prm language (subsection, end, set, include, comments, lines continued with a backslash) and
  /// checks every name and value against the known tree. It exists because deal.II 9.4 answers a misspelt entry with a
  /// dump of its internals. Files named by `include` are looked for beside the file that includes them. An entry set
  /// twice in one file is refused; a file may set again what it included. Raises InputError, at most six lines.
  std::vector<Assignment> scan_parameter_file(const std::string &path, const ParameterTree &known);

  /// One override "Section/Sub section/Entry=value"; blanks around '/' and '=' do not count.
  Assignment scan_override(const std::string &text, const ParameterTree &known);
} // namespace birdstrike
