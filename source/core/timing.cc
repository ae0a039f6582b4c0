#include <birdstrike/core/timing.h>

#include <fmt/format.h>

namespace birdstrike
{
  namespace
  {
    double seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  } // namespace

  Timings::Scope::Scope(Timings &timings, const std::size_t section)
    : timings(timings), section(section), start(std::chrono::steady_clock::now())
  {
  }

  Timings::Scope::~Scope()
  {
    timings.all[section].seconds += seconds_since(start);
    ++timings.all[section].calls;
  }

  Timings::Timings() : start(std::chrono::steady_clock::now())
  {
  }

  std::size_t Timings::section(const std::string &name)
  {
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].name == name)
        return k;
    all.push_back({name, 0., 0});
    return all.size() - 1;
  }

  double Timings::wall() const
  {
    return seconds_since(start);
  }

  double Timings::seconds(const std::string &name) const
  {
    for (const Section &section : all)
      if (section.name == name)
        return section.seconds;
    return 0.;
  }

  const std::vector<Timings::Section> &Timings::sections() const
  {
    return all;
  }

  std::string Timings::table() const
  {
    const double total = wall();
    double       named = 0.;
    std::string  text  = fmt::format("{:<28}{:>11}{:>9}{:>12}\n", "section", "seconds", "share", "calls");
    const auto   row   = [&](const std::string &name, const double seconds, const std::string &calls) {
      text += fmt::format("{:<28}{:>11.3f}{:>8.1f}%{:>12}\n", name, seconds, 100. * seconds / total, calls);
    };
    for (const Section &section : all)
      {
        row(section.name, section.seconds, std::to_string(section.calls));
        named += section.seconds;
      }
    row("other", total - named, "");
    row("total", total, "");
    return text;
  }
} // namespace birdstrike
