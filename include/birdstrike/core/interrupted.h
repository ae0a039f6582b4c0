#pragma once

#include <stdexcept>

namespace birdstrike
{
  /// SIGINT or SIGTERM ended a run before its end: what it came to until then is written.
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;

    static constexpr int exit_code = 130; ///< of the process: 128 + SIGINT, as a shell says it
  };
} // namespace birdstrike
