#include <birdstrike/core/child_process.h>
#include <birdstrike/core/program.h>

#include <sys/wait.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <unistd.h>

extern char **environ;

namespace birdstrike
{
  namespace
  {
    // What a signal handler may touch: atomics without locks.
    std::atomic<int> child_pid{0}, received{0};
    static_assert(std::atomic<int>::is_always_lock_free);

    void hand_on(const int signal)
    {
      const int error = errno;
      received        = signal;
      if (const int child = child_pid; child > 0)
        ::kill(child, signal);
      errno = error;
    }

    /// Signals of the terminal and of a batch system go to the child while this lives; those that this process was
    /// told to ignore (a job in the background) stay ignored.
    class SignalsForChild
    {
    public:
      SignalsForChild()
      {
        child_pid = received    = 0;
        struct sigaction action = {};
        action.sa_handler       = hand_on;
        action.sa_flags         = SA_RESTART;
        for (std::size_t k = 0; k < signals.size(); ++k)
          {
            ::sigaction(signals[k], nullptr, &before[k]);
            if (before[k].sa_handler != SIG_IGN)
              ::sigaction(signals[k], &action, nullptr);
          }
      }
      ~SignalsForChild()
      {
        for (std::size_t k = 0; k < signals.size(); ++k)
          ::sigaction(signals[k], &before[k], nullptr);
        child_pid = 0;
      }
      SignalsForChild(const SignalsForChild &)            = delete;
      SignalsForChild &operator=(const SignalsForChild &) = delete;

    private:
      static constexpr std::array<int, 2> signals{{SIGINT, SIGTERM}};
      struct sigaction                    before[2];
    };

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
      std::string read_all()
      {
        close_writing_end();
        std::string            text;
        std::array<char, 4096> buffer;
        for (ssize_t n; (n = ::read(ends[0], buffer.data(), buffer.size())) != 0;)
          if (n > 0)
            text.append(buffer.data(), static_cast<std::size_t>(n));
          else if (errno != EINTR)
            break;
        return text;
      }

    private:
      std::array<int, 2> ends{};
    };

    std::vector<char *> pointers_to(std::vector<std::string> &texts)
    {
      std::vector<char *> pointers;
      for (std::string &text : texts)
        pointers.push_back(text.data());
      pointers.push_back(nullptr);
      return pointers;
    }

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

    /// Returns the exit code. No signal is handed on to a child that is no more: its number may be another's by then.
    int wait_for(const pid_t pid)
    {
      siginfo_t info{};
      while (::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
        ;
      child_pid  = 0;
      int status = 0;
      while (::waitpid(pid, &status, 0) < 0 && errno == EINTR)
        ;
      return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    }

    /// Returns the error number of the attempt, 0 if the child runs.
    int spawn(const ChildRequest &request, const Pipe &pipe, pid_t &pid)
    {
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
  } // namespace

  std::optional<ChildResult> run_child_if_found(const ChildRequest &request)
  {
    std::fflush(nullptr); // what was said before stands before what the child says
    ChildResult result;
    {
      const SignalsForChild signals;
      Pipe                  pipe;
      pid_t                 pid = 0;
      if (const int error = spawn(request, pipe, pid); error == ENOENT)
        return {};
      else if (error != 0)
        throw std::runtime_error("Cannot start '" + request.arguments.front() + "': " + std::strerror(error));
      child_pid = pid;
      if (received != 0) // between the handler's first moment and the child's
        ::kill(pid, received);
      if (request.captures_output)
        result.output = pipe.read_all();
      result.exit_code = wait_for(pid);
    }
    result.stopped_by = received; // from here on signals act as before
    return result;
  }

  ChildResult run_child(const ChildRequest &request)
  {
    std::optional<ChildResult> result = run_child_if_found(request);
    if (!result)
      throw std::runtime_error("Cannot start '" + request.arguments.front() + "': there is no such program.");
    return *std::move(result);
  }
} // namespace birdstrike
