#include "core/child_signals.h"

#include <cerrno>

namespace birdstrike
{
  std::array<std::atomic<int>, most_children> children{};
  std::atomic<int>                            received{0};
  static_assert(std::atomic<int>::is_always_lock_free);

  namespace
  {
    void hand_on(const int signal)
    {
      const int error = errno;
      received        = signal;
      for (const std::atomic<int> &child : children)
        if (const int pid = child; pid > 0)
          ::kill(pid, signal);
      errno = error;
    }
  } // namespace

  SignalsForChildren::SignalsForChildren()
  {
    received                = 0;
    struct sigaction action = {};
    action.sa_handler       = hand_on;
    action.sa_flags         = SA_RESTART;
    for (std::size_t k = 0; k < handed_on.size(); ++k)
      {
        ::sigaction(handed_on[k], nullptr, &before[k]);
        if (before[k].sa_handler != SIG_IGN)
          ::sigaction(handed_on[k], &action, nullptr);
      }
  }

  SignalsForChildren::~SignalsForChildren()
  {
    for (std::size_t k = 0; k < handed_on.size(); ++k)
      ::sigaction(handed_on[k], &before[k], nullptr);
  }

  void forget_children()
  {
    received = 0;
    for (std::atomic<int> &child : children)
      child = 0;
    for (const int signal : handed_on)
      {
        struct sigaction now = {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler != SIG_IGN)
          ::signal(signal, SIG_DFL);
      }
  }
} // namespace birdstrike
