#pragma once

#include <birdstrike/core/child_process.h>

#include <array>
#include <atomic>
#include <csignal>

/// Which children are there, for a signal handler: atomics without locks.
namespace birdstrike
{
  inline constexpr std::array<int, 3> handed_on{{SIGINT, SIGTERM, SIGHUP}};

  extern std::array<std::atomic<int>, most_children> children; ///< process numbers, 0 where a place is free
  extern std::atomic<int>                            received; ///< the latest signal handed on

  /// Signals of the terminal and of a batch system go to the children while this lives; those that this process was
  /// told to ignore (a job in the background) stay ignored.
  class SignalsForChildren
  {
  public:
    SignalsForChildren();
    ~SignalsForChildren();
    SignalsForChildren(const SignalsForChildren &)            = delete;
    SignalsForChildren &operator=(const SignalsForChildren &) = delete;

  private:
    std::array<struct sigaction, handed_on.size()> before;
  };

  /// In a copy of this process: its children are not the copy's, and signals act by default or are ignored as before.
  void forget_children();
} // namespace birdstrike
