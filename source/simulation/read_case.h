#pragma once

#include <birdstrike/core/warning.h>
#include <birdstrike/simulation/commands.h>

namespace birdstrike
{
  struct CaseParameters;

  /// On the screen and in the log.
  void show(const Warnings &warnings);

  /// With --strict: shows those of units, of entries without effect and of misses, and throws InputError, if any.
  void refuse_if_strict(const Warnings &warnings, const CaseRequest &request);

  /// The override that sets the folder of a run, whatever its name.
  std::string set_directory(const std::string &directory);

  /// Reads and checks a case; the command line's folder wins over the file's. Warnings of the entries are shown at
  /// once, for what is built of a wrong unit may take long, and returned.
  Warnings read_case(CaseParameters &parameters, const CaseRequest &request);

  /// The same of a case whose blade alone is used (CaseParameters::read_blade). Returns why the struck side is unknown.
  std::string read_blade(CaseParameters &parameters, const CaseRequest &request);
} // namespace birdstrike
