#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// How a program ended that was started from here.
  struct ChildResult
  {
    bool        was_found  = true; ///< false: there is no such program, nothing ran
    int         exit_code  = 0;    ///< 128 + signal, as a shell says it, where a signal ended it
    int         stopped_by = 0;    ///< the signal that this process received meanwhile and handed on; 0: none
    std::string output;            ///< standard output and error together, if captured
  };

  struct ChildRequest
  {
    std::vector<std::string> arguments;               ///< the program, looked up in PATH, and what follows it
    std::string              directory;               ///< working directory; empty: this process's
    bool                     captures_output = false; ///< else it goes where this process's goes
  };

  /// Starts a program and waits for its end. An interrupt or a request to terminate that reaches this process in the
  /// meantime is handed on, so that the child ends in its own orderly way. The child does not take itself for the rank
  /// of an MPI job that this process may be. One child at a time. Throws std::runtime_error if it cannot be started
  /// for another reason than that it does not exist.
  ChildResult run_child(const ChildRequest &request);

  /// The path of the running program.
  std::string path_of_this_program();
} // namespace birdstrike
