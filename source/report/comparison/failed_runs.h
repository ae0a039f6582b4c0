#pragma once

#include <string>

namespace birdstrike
{
  /// What the runs that came to no result ended with, by the exit codes of their processes.
  class FailedRuns
  {
  public:
    void add(const std::string &name, int exit_code);

    /// Throws what gives the whole the exit code that says most: of a crash (std::runtime_error) before a refusal
    /// (InputError) before a lost state (NumericalFailure) before a signal (Interrupted). `others`: "cases", "points".
    void raise(const std::string &others) const;

  private:
    std::string  names;
    unsigned int n           = 0;
    bool         has_refused = false, has_lost = false, are_all_lawful = true;
  };
} // namespace birdstrike
