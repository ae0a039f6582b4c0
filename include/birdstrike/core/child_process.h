#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// How a program ended that was started from here.
  struct ChildResult
  {
    int         exit_code  = 0; ///< 128 + signal, as a shell says it, where a signal ended it
    int         stopped_by = 0; ///< the signal that this process received meanwhile and handed on; 0: none
    std::string output;         ///< standard output and error together, if captured
  };

  struct ChildRequest
  {
    std::vector<std::string> arguments;               ///< the program's name and what follows it
    std::string              directory;               ///< working directory; empty: this process's
    bool                     captures_output = false; ///< else it goes where this process's goes
    std::string              file            = {};    ///< of the program; empty: its name is looked up in PATH
  };

  /// Starts a program and waits for its end. An interrupt or a request to terminate that reaches this process in the
  /// meantime is handed on, so that the child ends in its own orderly way. The child does not take itself for the rank
  /// of an MPI job that this process may be. One child at a time. Throws std::runtime_error if it cannot be started.
  ChildResult run_child(const ChildRequest &request);

  /// The same; nothing if there is no such program.
  std::optional<ChildResult> run_child_if_found(const ChildRequest &request);

  inline constexpr std::size_t most_children = 1024; ///< side by side

  using EndOfChild = std::function<void(std::size_t request, const ChildResult &result)>;

  /// Starts programs in this order, at most `n_at_once` side by side, and tells `on_end`, which must not throw, of each
  /// as it ends, with all that it has said (every request must capture); one that cannot be started ends with exit code
  /// 127. A signal is handed on to all of them, and no further one is started. Returns that signal, 0 if there was
  /// none.
  int run_children(const std::vector<ChildRequest> &requests, std::size_t n_at_once, const EndOfChild &on_end);

  /// The file by which a child of the running program starts the same program, that very build, even when a new one has
  /// taken its place on the disk: the kernel resolves it in the child, which still runs its parent's image.
  inline constexpr const char *this_program = "/proc/self/exe";

  using ProgramEntry = int (*)(int n_arguments, char **arguments);

  /// From now on children that are this very program begin here, in a copy of this process, instead of being loaded
  /// again: some two hundred shared libraries take 0.3 s of processor time, as much as a small run. Such a child has a
  /// log of its own, the default answer to signals, and ends without destroying what is its parent's. It is loaded all
  /// the same where this process has several threads, which a copy would lack, or is a rank of an MPI job.
  void begin_children_at(ProgramEntry entry);
} // namespace birdstrike
