#include "core/child_signals.h"
#include "core/program_copy.h"
#include <birdstrike/core/child_process.h>
#include <birdstrike/core/program.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <unistd.h>

extern char **environ;

namespace birdstrike
{
  namespace
  {
    /// Standard output and error of a child, read to their end.
    class Pipe
    {
    public:
      Pipe()
      {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
          throw std::runtime_error(std::string("Cannot make a pipe: ") + std::strerror(errno));
      }
      ~Pipe()
      {
        ::close(ends[0]);
        close_writing_end();
      }
      Pipe(const Pipe &)            = delete;
      Pipe &operator=(const Pipe &) = delete;

      int writing_end() const
      {
        return ends[1];
      }
      void close_writing_end()
      {
        if (ends[1] >= 0)
          ::close(ends[1]);
        ends[1] = -1;
      }
      int reading_end() const
      {
        return ends[0];
      }
      /// Waits for some of it; false at its end.
      bool read_some(std::string &text)
      {
        std::array<char, 4096> buffer;
        const ssize_t          n = ::read(ends[0], buffer.data(), buffer.size());
        if (n > 0)
          text.append(buffer.data(), static_cast<std::size_t>(n));
        return n > 0 || (n < 0 && errno == EINTR);
      }

    private:
      std::array<int, 2> ends{};
    };

    std::vector<std::string> environment_without_launcher()
    {
      std::vector<std::string> kept;
      for (char **entry = environ; *entry; ++entry)
        {
          bool is_launcher = false;
          for (const std::string variable : launcher_variables)
            is_launcher = is_launcher || std::strncmp(*entry, (variable + "=").c_str(), variable.size() + 1) == 0;
          if (!is_launcher)
            kept.emplace_back(*entry);
        }
      return kept;
    }

    /// Returns the error number of the attempt, 0 if the child runs.
    int spawn(const ChildRequest &request, const Pipe &pipe, pid_t &pid)
    {
      if (can_copy_program(request))
        return copy_program(request, pipe.writing_end(), pid);
      std::vector<std::string>   arguments = request.arguments, variables = environment_without_launcher();
      posix_spawn_file_actions_t actions;
      posix_spawn_file_actions_init(&actions);
      if (!request.directory.empty())
        posix_spawn_file_actions_addchdir_np(&actions, request.directory.c_str());
      if (request.captures_output)
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
          posix_spawn_file_actions_adddup2(&actions, pipe.writing_end(), stream);
      const std::string &file  = request.file.empty() ? arguments.front() : request.file;
      const int          error = ::posix_spawnp(&pid, file.c_str(), &actions, nullptr, pointers_to(arguments).data(),
                                                pointers_to(variables).data());
      posix_spawn_file_actions_destroy(&actions);
      return error;
    }

    /// A child from its start to its end, in a place of its own among those that signals are handed on to.
    class Child
    {
    public:
      Child(const ChildRequest &request, const std::size_t number) : place(children.at(number))
      {
        const int error = spawn(request, pipe, pid);
        is_found        = error != ENOENT;
        if (error != 0 && is_found)
          throw std::runtime_error("Cannot start '" + request.arguments.front() + "': " + std::strerror(error));
        if (error != 0)
          return;
        pipe.close_writing_end();
        place = pid;
        if (received != 0) // between the handler's first moment and the child's
          ::kill(pid, received);
      }

      /// Returns the exit code. No signal is handed on to a child that is no more: its number may be another's by then.
      int wait()
      {
        siginfo_t info{};
        while (::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
          ;
        place      = 0;
        int status = 0;
        while (::waitpid(pid, &status, 0) < 0 && errno == EINTR)
          ;
        return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
      }

      Pipe pipe;
      bool is_found = true;

    private:
      std::atomic<int> &place;
      pid_t             pid = 0;
    };

    struct RunningChild
    {
      std::size_t            request;
      std::unique_ptr<Child> child;
      std::string            output;
    };

    /// Waits until some of them have said something or ended.
    std::vector<bool> find_ready(const std::vector<RunningChild> &running)
    {
      std::vector<pollfd> ends;
      for (const RunningChild &each : running)
        ends.push_back({each.child->pipe.reading_end(), POLLIN, 0});
      while (::poll(ends.data(), ends.size(), -1) < 0 && errno == EINTR)
        ;
      std::vector<bool> are_ready;
      for (const pollfd &end : ends)
        are_ready.push_back(end.revents != 0);
      return are_ready;
    }

    /// Nothing if it cannot be started; then `on_end` has been told.
    std::optional<RunningChild> start(const std::vector<ChildRequest> &requests, const std::size_t k,
                                      const std::size_t place, const EndOfChild &on_end)
    {
      std::string why = "Cannot start '" + requests[k].arguments.front() + "': there is no such program.";
      try
        {
          auto child = std::make_unique<Child>(requests[k], place);
          if (child->is_found)
            return RunningChild{k, std::move(child), ""};
        }
      catch (const std::runtime_error &error)
        {
          why = error.what();
        }
      on_end(k, {127, 0, why}); // as a shell says it
      return {};
    }

    std::size_t find_free_place()
    {
      return static_cast<std::size_t>(std::ranges::find(children, 0, [](const auto &c) { return c.load(); }) -
                                      children.begin());
    }
  } // namespace

  std::optional<ChildResult> run_child_if_found(const ChildRequest &request)
  {
    std::fflush(nullptr); // what was said before stands before what the child says
    ChildResult result;
    {
      const SignalsForChildren signals;
      Child                    child(request, 0);
      if (!child.is_found)
        return {};
      while (request.captures_output && child.pipe.read_some(result.output))
        ;
      result.exit_code = child.wait();
    }
    result.stopped_by = received; // from here on signals act as before
    return result;
  }

  int run_children(const std::vector<ChildRequest> &requests, const std::size_t n_at_once, const EndOfChild &on_end)
  {
    std::fflush(nullptr);
    const SignalsForChildren  signals;
    std::vector<RunningChild> running;
    const std::size_t         n_places = std::clamp(n_at_once, std::size_t(1), most_children);
    std::size_t               next     = 0;
    while (true)
      {
        const bool starts_more = received == 0 && next < requests.size();
        if (starts_more && running.size() < n_places)
          {
            if (auto started = start(requests, next, find_free_place(), on_end))
              running.push_back(*std::move(started));
            ++next;
            continue;
          }
        if (running.empty()) // nothing is left, or a signal came as the last of them ended
          break;
        const std::vector<bool> are_ready = find_ready(running);
        for (std::size_t k = running.size(); k-- > 0;)
          if (are_ready[k] && !running[k].child->pipe.read_some(running[k].output))
            {
              const ChildResult result{running[k].child->wait(), 0, std::move(running[k].output)};
              const std::size_t request = running[k].request;
              running.erase(running.begin() + static_cast<std::ptrdiff_t>(k));
              on_end(request, result);
            }
      }
    return received;
  }

  ChildResult run_child(const ChildRequest &request)
  {
    std::optional<ChildResult> result = run_child_if_found(request);
    if (!result)
      throw std::runtime_error("Cannot start '" + request.arguments.front() + "': there is no such program.");
    return *std::move(result);
  }
} // namespace birdstrike
