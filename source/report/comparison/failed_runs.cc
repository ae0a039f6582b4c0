#include "report/comparison/failed_runs.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/interrupted.h>
#include <birdstrike/core/numerical_failure.h>

#include <stdexcept>

namespace birdstrike
{
  void FailedRuns::add(const std::string &name, const int exit_code)
  {
    constexpr unsigned int most_named = 8;
    if (exit_code == 0)
      return;
    if (++n <= most_named)
      names += (names.empty() ? "'" : ", '") + name + "' (exit code " + std::to_string(exit_code) + ")";
    has_refused    = has_refused || exit_code == static_cast<int>(ExitCode::bad_input);
    has_lost       = has_lost || exit_code == static_cast<int>(ExitCode::numerical_failure);
    are_all_lawful = are_all_lawful && (exit_code == static_cast<int>(ExitCode::bad_input) ||
                                        exit_code == static_cast<int>(ExitCode::numerical_failure) ||
                                        exit_code == Interrupted::exit_code);
    if (n == most_named + 1)
      names += " and others";
  }

  void FailedRuns::raise(const std::string &others) const
  {
    if (names.empty())
      return;
    const std::string rest = ". The table has the results of the other " + others + ".";
    if (!are_all_lawful)
      throw std::runtime_error("a case ended as none should: " + names + ".");
    if (has_refused)
      throw InputError("Refused or lost: " + names + rest);
    if (has_lost)
      throw NumericalFailure("Lost: " + names + rest);
    throw Interrupted("Interrupted: " + names + ". The table has their results until then.");
  }
} // namespace birdstrike
