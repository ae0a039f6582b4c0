#pragma once

#include <birdstrike/core/child_process.h>

#include <string>
#include <sys/types.h>
#include <vector>

namespace birdstrike
{
  /// As main() takes them: with a null at the end. The texts must stay.
  std::vector<char *> pointers_to(std::vector<std::string> &texts);

  /// Whether a child of this request may begin in a copy of this process (begin_children_at).
  bool can_copy_program(const ChildRequest &request);

  /// Makes the copy, which runs the program and ends with its exit code; it says what it says into `output`, a file's
  /// number, if the request captures. Returns the error number of the attempt, 0 if the child runs.
  int copy_program(const ChildRequest &request, int output, pid_t &pid);
} // namespace birdstrike
