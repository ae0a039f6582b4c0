#pragma once

#include <stdexcept>
#include <string>

namespace birdstrike
{
  /// What the process returns to the shell.
  enum class ExitCode : int
  {
    done              = 0,
    internal_error    = 1,
    bad_input         = 2,
    numerical_failure = 3
  };

  /// The user's input cannot be run: says what was read, where, what is allowed, and one action (at most six lines).
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace birdstrike
