#include <birdstrike/core/numerical_failure.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace birdstrike
{
  std::string FailureFacts::text() const
  {
    const std::string of_unit = unit.empty() || unit == "-" ? "" : " " + unit;
    std::string       first   = what, second;
    if (!quantity.empty())
      first += fmt::format(": {} = {:.6g}{}", quantity, value, of_unit);
    if (!quantity.empty() && !std::isnan(limit))
      first += fmt::format(" ({} {:.6g}{})", limit_name, limit, of_unit);
    if (time)
      second = fmt::format("At t = {:.6g} s", *time);
    if (step)
      second += fmt::format("{} {}", second.empty() ? "At step" : ", step", *step);
    if (const std::string place = where.text(); !place.empty())
      second += fmt::format("{}{} m{}", second.empty() ? "At " : ", ", place, role.empty() ? "" : " (" + role + ")");
    std::string all = first + (quantity.empty() && !first.empty() && first.back() == '.' ? "" : ".");
    if (!second.empty())
      all += "\n" + second + ".";
    for (const std::string *line : {&details, &advice, &way_on})
      if (!line->empty())
        all += "\n" + *line;
    return all;
  }

  NumericalFailure::NumericalFailure(FailureFacts facts) : known(std::move(facts)), message(known.text())
  {
  }

  NumericalFailure::NumericalFailure(const std::string &what) : NumericalFailure(FailureFacts{what})
  {
  }

  void NumericalFailure::add_instant(const double time, const std::uint64_t step)
  {
    if (!known.time)
      known.time = time;
    if (!known.step && known.time == time)
      known.step = step;
    message = known.text();
  }

  void NumericalFailure::add_entity(const EntityPlace &where, const std::string &role)
  {
    known.where = where;
    known.role  = role;
    message     = known.text();
  }

  void NumericalFailure::add_checkpoint(const std::string &file, const std::string &way_on)
  {
    known.checkpoint = file;
    known.way_on     = way_on;
    message          = known.text();
  }
} // namespace birdstrike
