#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/varied_entry.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/numbers/bracketed_lists.h"
#include "io/parameter_messages.h"
#include "io/parameter_scan.h"
#include "io/typed_numbers.h"

namespace birdstrike
{
  namespace
  {
    constexpr auto option = "--vary";
    constexpr auto allowed =
      "  Allowed: \"Section/Entry=v1, v2, ...\", \"Section/Entry=a:b:n\" (n numbers from a to b), "
      "\"Section/Entry=v1 | v2\" where values hold commas";

    [[noreturn]] void refuse(const std::string &text, const std::string &what)
    {
      throw InputError(message({std::string(option) + " " + quote(text) + ": " + what, allowed}));
    }

    std::optional<double> as_number(const std::string &text)
    {
      double value            = 0.;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      return error == std::errc() && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value)
                                                                                              : std::nullopt;
    }

    /// Values of one entry, in what the parameter file reads.
    class Reader
    {
    public:
      explicit Reader(const std::string &text)
        : text(text), where{std::string(option) + " " + quote(text), 0}, known(CaseParameters().file.tree())
      {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
          refuse(text, "no entry or no values.");
        path = dealii::Utilities::trim(text.substr(0, equals));
        list = dealii::Utilities::trim(text.substr(equals + 1));
        if (list.empty())
          refuse(text, "no values.");
      }

      VariedEntry read(const bool may_repeat)
      {
        const std::vector<std::string> bounds    = split_outside_brackets(list, ':');
        const char                     separator = list.find('|') != std::string::npos ? '|' : ',';
        VariedEntry                    varied    = {"", "-", {}, {}};
        if (bounds.size() == 3 && split_outside_brackets(list, ',').size() == 1 &&
            list.find_first_of("|;") == std::string::npos)
          varied.values = range(bounds);
        else
          for (const std::string &typed : with_units(items(separator), false))
            {
              if (typed.empty())
                refuse(text, "an empty value.");
              varied.values.push_back(plain(typed));
            }
        describe(varied);
        if (varied.values.size() > most_points)
          refuse(text, fmt::format("{} values; at most {} points make a study.", varied.values.size(), most_points));
        if (!may_repeat)
          require_different(varied);
        return varied;
      }

    private:
      const std::string   text;
      const SourceLine    where;
      const ParameterTree known;
      std::string         path, list;

      /// The entry, by any value that it has as default.
      const KnownEntry &entry() const
      {
        const ScannedValue found = scan_value(path + "=default", where, known);
        return *known.find(found.section, found.name);
      }

      /// A vector is one value, whose numbers commas part; a number that may be empty is a list of at most one.
      std::vector<std::string> items(const char separator) const
      {
        const std::string &pattern   = entry().pattern;
        const bool         is_vector = pattern.starts_with("[List") && !pattern.ends_with("0...1 (inclusive)]");
        return separator == ',' && is_vector ? std::vector{list} : split_outside_brackets(list, separator);
      }

      std::vector<std::string> with_units(const std::vector<std::string> &typed, const bool is_range) const
      {
        return share_unit(typed, is_range, entry(), where.text());
      }

      std::string plain(const std::string &typed) const
      {
        return scan_value(path + "=" + typed, where, known).value;
      }

      std::vector<std::string> range(const std::vector<std::string> &bounds) const
      {
        const auto count = evaluate_arithmetic(bounds[2]);
        if (!count || *count != std::floor(*count) || *count < 2.)
          refuse(text, "the number of values must be a whole number of at least 2, not " + quote(bounds[2]) + ".");
        if (*count > static_cast<double>(most_points))
          refuse(text, fmt::format("{:.0f} values; at most {} points make a study.", *count, most_points));
        const std::vector<std::string> ends  = with_units({bounds[0], bounds[1]}, true);
        const auto                     first = as_number(plain(ends[0])), last = as_number(plain(ends[1]));
        if (!first || !last)
          refuse(text, "a range needs two numbers.");
        std::vector<std::string> values;
        for (double k = 0.; k < *count; ++k) // twelve digits: 0.3, not 0.30000000000000004
          values.push_back(plain(fmt::format("{:.12g}", *first + (*last - *first) * k / (*count - 1.))));
        return values;
      }

      void describe(VariedEntry &varied) const
      {
        const KnownEntry &known_entry = entry();
        varied.entry = (known_entry.section.empty() ? "" : to_string(known_entry.section) + "/") + known_entry.name;
        if (!known_entry.unit.empty())
          varied.unit = known_entry.unit;
        for (const std::string &value : varied.values)
          if (const auto number = as_number(value))
            varied.numbers.push_back(*number);
        if (varied.numbers.size() != varied.values.size())
          varied.numbers.clear();
      }

      void require_different(const VariedEntry &varied) const
      {
        const auto is_same = [&](const std::size_t a, const std::size_t b) {
          return varied.numbers.empty() ? varied.values[a] == varied.values[b] : varied.numbers[a] == varied.numbers[b];
        };
        for (std::size_t b = 1; b < varied.values.size(); ++b)
          for (std::size_t a = 0; a < b; ++a)
            if (is_same(a, b))
              refuse(text, "the value " + quote(varied.values[b]) + " occurs twice: points of a study must differ.");
      }
    };
  } // namespace

  VariedEntry read_varied_entry(const std::string &text, const bool may_repeat)
  {
    return Reader(text).read(may_repeat);
  }
} // namespace birdstrike
