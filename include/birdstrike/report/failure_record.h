#pragma once

#include <string>

namespace birdstrike
{
  struct FailureFacts;

  /// failure.json of a run that was lost: the facts of its message by name, in SI units (schema:
  /// tests/data/failure.schema.json). What is not known, and a value that is no number, is null.
  std::string make_failure_record(const FailureFacts &facts);
} // namespace birdstrike
