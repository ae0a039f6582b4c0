#include "core/program_copy.h"
#include "core/child_signals.h"
#include <birdstrike/core/log.h>
#include <birdstrike/core/program.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    ProgramEntry program_entry = nullptr;

    bool is_single_threaded()
    {
      const std::filesystem::directory_iterator threads("/proc/self/task");
      return std::distance(begin(threads), end(threads)) == 1;
    }

    /// What a process has whose program has just been loaded.
    void begin_anew(const ChildRequest &request, const int output)
    {
      forget_children();
      if (request.captures_output)
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
          ::dup2(output, stream);
      if (!request.directory.empty())
        std::filesystem::current_path(request.directory);
      reset_log(); // no file, and colours for a terminal alone
    }

    [[noreturn]] void run_as_child(const ChildRequest &request, const int output, const sigset_t &unblocked)
    {
      int code = 127;
      try
        {
          begin_anew(request, output);
          ::sigprocmask(SIG_SETMASK, &unblocked, nullptr);
          std::vector<std::string> arguments = request.arguments;
          code = program_entry(static_cast<int>(arguments.size()), pointers_to(arguments).data());
        }
      catch (const std::exception &error)
        {
          std::fprintf(stderr, "%s\n", error.what());
        }
      std::cout.flush();
      std::fflush(nullptr);
      ::_exit(code); // what is the parent's is not destroyed here
    }
  } // namespace

  void begin_children_at(const ProgramEntry entry)
  {
    program_entry = entry;
  }

  std::vector<char *> pointers_to(std::vector<std::string> &texts)
  {
    std::vector<char *> pointers;
    for (std::string &text : texts)
      pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
  }

  bool can_copy_program(const ChildRequest &request)
  {
    return program_entry != nullptr && request.file == this_program && !is_started_by_launcher() &&
           is_single_threaded();
  }

  int copy_program(const ChildRequest &request, const int output, pid_t &pid)
  {
    std::fflush(nullptr);     // what waits to be written would be written twice
    sigset_t blocked, before; // a signal before begin_anew would be handed on by both
    ::sigemptyset(&blocked);
    for (const int signal : handed_on)
      ::sigaddset(&blocked, signal);
    ::sigprocmask(SIG_BLOCK, &blocked, &before);
    pid = ::fork();
    if (pid == 0)
      run_as_child(request, output, before);
    const int error = pid < 0 ? errno : 0;
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    return error;
  }
} // namespace birdstrike
