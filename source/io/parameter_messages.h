#pragma once

#include "io/parameter_scan.h"

#include <filesystem>
#include <initializer_list>
#include <string>

/// The sentences about bad input; each at most six lines.
namespace birdstrike
{
  std::string message(std::initializer_list<std::string> lines); ///< empty lines are left out
  std::string quote(const std::string &text);                    ///< in quotes, long texts cut

  std::string describe_section(const SectionPath &section); ///< "section 'Bird'" or "top level"

  std::string describe_unknown_entry(const SourceLine &where, const SectionPath &section, const std::string &name,
                                     const ParameterTree &known);
  /// `opened_at`: the line that opened `section`, 0 at the top level.
  std::string describe_unknown_section(const SourceLine &where, const SectionPath &section, unsigned int opened_at,
                                       const std::string &name, const ParameterTree &known);
  std::string describe_bad_value(const SourceLine &where, const KnownEntry &entry, const std::string &value);
  std::string describe_bad_statement(const SourceLine &where, const std::string &statement);
  std::string describe_missing_file(const std::filesystem::path &path, const SourceLine &includer);
} // namespace birdstrike
