#include <birdstrike/io/units.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

namespace birdstrike
{
  namespace
  {
    using Dimension = std::array<int, 5>;

    constexpr Dimension number{}, mass{{1}}, length{{0, 1}}, time{{0, 0, 1}}, temperature{{0, 0, 0, 1}},
      angle{{0, 0, 0, 0, 1}}, rate{{0, 0, -1}}, speed{{0, 1, -1}}, spin{{0, 0, -1, 0, 1}}, force{{1, 1, -2}},
      pressure{{1, -1, -2}}, energy{{1, 2, -2}}, power{{1, 2, -3}}, density{{1, -3}}, heat_capacity{{0, 2, -2, -1}};

    constexpr double pi = std::numbers::pi, pound = 0.45359237, gravity = 9.80665, inch = 25.4;

    const std::vector<std::pair<std::string, Unit>> &named_units()
    {
      static const std::vector<std::pair<std::string, Unit>> units{
        {"m", {1., 0, length}},
        {"mm", {1., -3, length}},
        {"cm", {1., -2, length}},
        {"um", {1., -6, length}},
        {"km", {1., 3, length}},
        {"in", {inch, -3, length}},
        {"ft", {12. * inch, -3, length}},
        {"s", {1., 0, time}},
        {"ms", {1., -3, time}},
        {"us", {1., -6, time}},
        {"ns", {1., -9, time}},
        {"min", {60., 0, time}},
        {"h", {3600., 0, time}},
        {"kg", {1., 0, mass}},
        {"g", {1., -3, mass}},
        {"mg", {1., -6, mass}},
        {"t", {1., 3, mass}},
        {"lb", {pound, 0, mass}},
        {"oz", {pound / 16., 0, mass}},
        {"K", {1., 0, temperature}},
        {"degC", {1., 0, temperature, 273.15}},
        {"deg", {pi / 180., 0, angle}},
        {"degree", {pi / 180., 0, angle}},
        {"degrees", {pi / 180., 0, angle}},
        {"rad", {1., 0, angle}},
        {"mrad", {1., -3, angle}},
        {"Hz", {1., 0, rate}},
        {"kHz", {1., 3, rate}},
        {"rpm", {2. * pi / 60., 0, spin}},
        {"knots", {1852. / 3600., 0, speed}},
        {"knot", {1852. / 3600., 0, speed}},
        {"kt", {1852. / 3600., 0, speed}},
        {"kts", {1852. / 3600., 0, speed}},
        {"mph", {1609.344 / 3600., 0, speed}},
        {"N", {1., 0, force}},
        {"kN", {1., 3, force}},
        {"lbf", {pound * gravity, 0, force}},
        {"Pa", {1., 0, pressure}},
        {"kPa", {1., 3, pressure}},
        {"MPa", {1., 6, pressure}},
        {"GPa", {1., 9, pressure}},
        {"bar", {1., 5, pressure}},
        {"psi", {pound * gravity / (inch * inch), 6, pressure}},
        {"ksi", {pound * gravity / (inch * inch), 9, pressure}},
        {"J", {1., 0, energy}},
        {"kJ", {1., 3, energy}},
        {"mJ", {1., -3, energy}},
        {"W", {1., 0, power}},
        {"kW", {1., 3, power}},
        {"%", {1., -2, number}}};
      return units;
    }

    /// Other spellings of these, which messages do not list.
    const std::vector<std::pair<std::string, std::string>> &other_spellings()
    {
      static const std::vector<std::pair<std::string, std::string>> spellings{
        {"inch", "in"},   {"inches", "in"}, {"foot", "ft"},   {"feet", "ft"},    {"µm", "um"},       {"μm", "um"},
        {"micron", "um"}, {"sec", "s"},     {"msec", "ms"},   {"usec", "us"},    {"µs", "us"},       {"μs", "us"},
        {"hr", "h"},      {"lbm", "lb"},    {"lbs", "lb"},    {"tonne", "t"},    {"tonnes", "t"},    {"gram", "g"},
        {"kelvin", "K"},  {"°C", "degC"},   {"°", "deg"},     {"radian", "rad"}, {"radians", "rad"}, {"RPM", "rpm"},
        {"kn", "knots"},  {"KT", "knots"},  {"KTS", "knots"}, {"kph", "kmh"},    {"hz", "Hz"}};
      return spellings;
    }

    const Unit *find_exactly(const std::string &name)
    {
      static const std::vector<std::pair<std::string, Unit>> unlisted{
        {"mil", {inch, -6, length}}, {"kmh", {1. / 3.6, 0, speed}}, {"cc", {1., -6, {{0, 3}}}}};
      for (const auto *units : {&named_units(), &unlisted})
        for (const auto &[known, unit] : *units)
          if (known == name)
            return &unit;
      return nullptr;
    }

    const Unit *find_named(const std::string &name)
    {
      for (const auto &[spelling, meant] : other_spellings())
        if (spelling == name)
          return find_exactly(meant);
      return find_exactly(name);
    }

    /// Bytes from 0x80 on are those of letters like the Greek one for a millionth.
    bool is_letter_of_unit(const char letter)
    {
      const auto byte = static_cast<unsigned char>(letter);
      return std::isalpha(byte) || letter == '%' || byte >= 0x80;
    }

    /// a times b^n.
    void multiply(Unit &a, const Unit &b, const int n)
    {
      a.factor *= std::pow(b.factor, n);
      a.exponent += n * b.exponent;
      for (std::size_t d = 0; d < a.dimension.size(); ++d)
        a.dimension[d] += n * b.dimension[d];
    }

    /// Recursive descent over the text.
    class UnitParser
    {
    public:
      explicit UnitParser(const std::string &text) : text(text)
      {
      }

      std::optional<Unit> parse()
      {
        const Unit unit = product();
        skip_blanks();
        return is_good && at == text.size() ? std::optional(unit) : std::nullopt;
      }

    private:
      const std::string &text;
      std::size_t        at      = 0;
      bool               is_good = true;

      void skip_blanks()
      {
        while (at < text.size() && text[at] == ' ')
          ++at;
      }

      bool take(const char c)
      {
        skip_blanks();
        const bool is_there = at < text.size() && text[at] == c;
        at += is_there;
        return is_there;
      }

      Unit product()
      {
        Unit unit;
        factor(unit, 1);
        for (skip_blanks(); is_good && at < text.size() && text[at] != ')'; skip_blanks())
          if (take('/'))
            factor(unit, -1);
          else
            {
              take('*');
              factor(unit, 1);
            }
        return unit;
      }

      void factor(Unit &unit, const int sign)
      {
        Unit one;
        bool has_power = false; // as in mm2
        if (take('('))
          {
            one     = product();
            is_good = is_good && take(')');
          }
        else if (!take('1'))
          {
            const std::size_t begin = at;
            while (at < text.size() && is_letter_of_unit(text[at]))
              ++at;
            const Unit *named = find_named(text.substr(begin, at - begin));
            is_good           = is_good && named != nullptr;
            if (!is_good)
              return;
            one       = *named;
            has_power = at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
          }
        int power = 1;
        if (has_power || take('^'))
          {
            char *end = nullptr;
            power     = static_cast<int>(std::strtol(text.c_str() + at, &end, 10));
            is_good   = is_good && end != text.c_str() + at && std::abs(power) < 10;
            at        = static_cast<std::size_t>(end - text.c_str());
          }
        multiply(unit, one, sign * power);
      }
    };
  } // namespace

  double Unit::to_si(const double value) const
  {
    const double scaled =
      exponent < 0 ? factor * value / std::pow(10., -exponent) : factor * value * std::pow(10., exponent);
    return scaled + offset;
  }

  std::optional<Unit> parse_unit(const std::string &text)
  {
    if (const Unit *named = find_named(text)) // an offset holds for a unit that stands alone
      return *named;
    return UnitParser(text).parse();
  }

  std::string list_units_like(const Unit &unit)
  {
    std::string text;
    for (const auto &[name, named] : named_units())
      if (named.dimension == unit.dimension)
        text += (text.empty() ? "" : ", ") + name;
    for (const auto &[name, dimension] :
         {std::pair("m/s, km/h, ft/s", speed), std::pair("rad/s", spin), std::pair("1/s", rate),
          std::pair("kg/m^3, g/cm^3, t/mm^3", density), std::pair("J/(kg K)", heat_capacity),
          std::pair("N/mm^2", pressure), std::pair("N m", energy)})
      if (dimension == unit.dimension)
        text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
  }
} // namespace birdstrike
