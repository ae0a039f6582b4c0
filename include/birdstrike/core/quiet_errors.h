#pragma once

#include <iostream>

namespace birdstrike
{
  /// deal.II prints complaints of muparser and of its mesh readers to std::cerr before it throws; the user gets our
  /// sentence instead.
  class QuietErrors
  {
  public:
    QuietErrors() : kept(std::cerr.rdbuf(nullptr))
    {
    }
    ~QuietErrors()
    {
      std::cerr.rdbuf(kept);
      std::cerr.clear();
    }
    QuietErrors(const QuietErrors &)            = delete;
    QuietErrors &operator=(const QuietErrors &) = delete;

  private:
    std::streambuf *kept;
  };
} // namespace birdstrike
