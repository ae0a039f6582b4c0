#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Wall time by section of the loop, one level deep, with an "other" row. Only the main thread may use it.
  class Timings
  {
  public:
    struct Section
    {
      std::string   name;
      double        seconds = 0.;
      std::uint64_t calls   = 0;
    };

    /// Adds its life time to one section.
    class Scope
    {
    public:
      Scope(Timings &timings, std::size_t section);
      ~Scope();
      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      Timings                              &timings;
      std::size_t                           section;
      std::chrono::steady_clock::time_point start;
    };

    Timings();

    /// Index of a section, made at first use.
    std::size_t section(const std::string &name);

    double                      wall() const;                           ///< s since construction
    double                      seconds(const std::string &name) const; ///< 0 for a section that does not exist
    const std::vector<Section> &sections() const;

    /// A table: seconds, share of the wall time, calls; the last rows are "other" and "total".
    std::string table() const;

  private:
    std::chrono::steady_clock::time_point start;
    std::vector<Section>                  all;
  };
} // namespace birdstrike
