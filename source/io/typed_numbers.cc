#include "io/typed_numbers.h"
#include "io/numbers/bracketed_lists.h"
#include "io/parameter_messages.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/io/units.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using dealii::Utilities::trim;

    enum class Kind
    {
      number,
      integer,
      list,
      text,
      other
    };

    Kind kind_of(const KnownEntry &entry)
    {
      for (const auto &[begin, kind] : {std::pair("[Double", Kind::number), std::pair("[Integer", Kind::integer),
                                        std::pair("[List of <[Double", Kind::list), std::pair("[Anything", Kind::text)})
        if (entry.pattern.rfind(begin, 0) == 0)
          return kind;
      return Kind::other;
    }

    bool is_plain(const std::string &text)
    {
      return dealii::Patterns::Double().match(text);
    }

    std::string text_of(const double value)
    {
      std::array<char, 32> text;
      return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
    }

    /// A number or formula and the text of the unit after it.
    struct Quantity
    {
      std::string formula, unit;
    };

    /// Where a unit may begin: at a letter, '%' or "1/" that follows what ends a number or formula.
    bool may_begin_unit(const std::string &text, const std::size_t at)
    {
      const auto byte = [&](const std::size_t k) { return static_cast<unsigned char>(text[k]); };
      if (at == 0 || (!std::isdigit(byte(at - 1)) && std::string(" .)").find(text[at - 1]) == std::string::npos))
        return false;
      const bool is_beyond_ascii = byte(at) >= 0xC0; // the first byte of a letter
      return std::isalpha(byte(at)) || is_beyond_ascii || text[at] == '%' ||
             (text[at - 1] == ' ' && text.compare(at, 2, "1/") == 0);
    }

    /// The split with the longest first part that can be evaluated; `is_known`: and the second be read as a unit.
    Quantity split(const std::string &text, const bool is_known)
    {
      for (std::size_t at = text.size(); at-- > 0;)
        if (may_begin_unit(text, at))
          {
            const std::string formula = trim(text.substr(0, at)), unit = text.substr(at);
            if ((!is_known || parse_unit(unit)) && (is_plain(formula) || evaluate_arithmetic(formula)))
              return {formula, unit};
          }
      return {};
    }

    /// Of a number or vector, in its first number that has one; empty if none has.
    std::string first_unit(const std::string &value)
    {
      for (const std::string &number : split_outside_brackets(value, ','))
        if (const std::string unit = split(number, true).unit; !unit.empty())
          return unit;
      return "";
    }

    /// Whether a text may be meant as a unit: it begins with a letter, is no exponent and no part of a formula.
    bool is_like_unit(const std::string &text)
    {
      const auto is_digit = [&](const std::size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
      };
      return !text.empty() && !is_digit(0) &&
             !((text[0] == 'e' || text[0] == 'E') && (is_digit(1) || text.find_first_of("+-") == 1)) &&
             text.find_first_of("(),<>=+-:;") == std::string::npos;
    }

    /// A unit behind a number in an argument of a function; empty where there is none.
    std::string find_unit_in_brackets(const std::string &text)
    {
      const std::size_t open = text.find('('), close = text.rfind(')');
      if (open == std::string::npos || close == std::string::npos || close < open)
        return "";
      for (const std::string &argument : split_outside_brackets(text.substr(open + 1, close - open - 1), ','))
        if (const std::string unit = split(argument, true).unit; !unit.empty())
          return unit;
      return "";
    }

    bool has_number_other_than_0(const std::string &value)
    {
      const std::vector<std::string> numbers = split_outside_brackets(value, ',');
      return std::ranges::any_of(
        numbers, [](const std::string &number) { return evaluate_arithmetic(number).value_or(0.) != 0.; });
    }

    /// The last one of a vector, or all of a number.
    std::string last_number(const std::string &value)
    {
      return split_outside_brackets(value, ',').back();
    }

    class Reader
    {
    public:
      Reader(const KnownEntry &entry, const std::string &where)
        : entry(entry), where(where), own(parse_unit(entry.unit))
      {
      }

      /// Of one number; any other text as it is.
      std::string number(const std::string &text) const
      {
        if (is_plain(text))
          return text;
        if (const Quantity given = split(text, true); !given.unit.empty())
          return convert(text, given);
        if (const auto value = evaluate_arithmetic(text))
          return text_of(*value);
        require_no_unknown_unit(text);
        if (const std::string unit = find_unit_in_brackets(text); !unit.empty())
          refuse(text,
                 "the unit '" + unit + "' stands inside a formula; it belongs behind, as in 'max(1, 2) " + unit + "'");
        return text;
      }

      /// `values` with the unit that one of them has for all: the last, or `either`. Throws InputError where others
      /// have units, too, and a number has none.
      std::vector<std::string> share_unit(std::vector<std::string> values, const bool either) const
      {
        std::vector<std::string> units;
        for (const std::string &value : values)
          units.push_back(first_unit(value));
        const auto        has_unit = [](const std::string &unit) { return !unit.empty(); };
        const auto        given    = std::ranges::find_if(units, has_unit);
        const auto        k_given  = static_cast<std::size_t>(given - units.begin());
        const bool        is_alone = std::ranges::count_if(units, has_unit) == 1;
        const std::string unit     = given == units.end() ? "" : split(last_number(values[k_given]), true).unit;
        const bool        for_all  = is_alone && !unit.empty() && (either || k_given + 1 == values.size());
        for (std::size_t k = 0; k < values.size(); ++k)
          if (given == units.end() || has_unit(units[k]))
            continue;
          else if (for_all && evaluate_arithmetic(last_number(values[k])))
            values[k] += " " + unit;
          else if (has_number_other_than_0(values[k]) ||
                   (evaluate_arithmetic(values[k]) && parse_unit(*given)->offset != 0.))
            refuse(values[k], "'" + values[k] + "' has no unit, others have one");
        return values;
      }

      std::string list(const std::string &text) const
      {
        std::string result;
        for (const std::string &item : share_unit(split_list(text), false))
          result += (result.empty() ? "" : ", ") + number(item);
        return result;
      }

      std::string pieces(const std::string &text) const
      {
        std::string result;
        for (std::size_t begin = 0; begin <= text.size();)
          {
            const std::size_t end      = std::min(text.find(';', begin), text.size());
            std::string       piece    = text.substr(begin, end - begin);
            std::size_t       mark     = piece.find_last_of(":=");
            const std::string tail     = take_name(piece, mark);
            const std::string key      = mark == std::string::npos ? "" : piece.substr(0, mark + 1) + " ";
            const std::string given    = trim(key.empty() ? piece : piece.substr(mark + 1));
            const Quantity    quantity = split(given, true);
            std::string       read     = given;
            if (entry.default_value == "table")
              read = number(given);
            else if (!quantity.unit.empty() && (key.empty() || is_mine(quantity.unit)))
              read = convert(given, quantity);
            else if (own && quantity.unit.empty() && mark == std::string::npos &&
                     is_like_unit(split(given, false).unit))
              require_no_unknown_unit(given);
            result += (begin > 0 ? ";" : "") +
                      (read == given ? piece : (begin > 0 && key.empty() ? " " : "") + key + read) + tail;
            begin = end + 1;
          }
        return result;
      }

    private:
      /// Takes the name off "0: 0.125 mm: carbon": what stands behind a second mark and begins as no number does.
      static std::string take_name(std::string &piece, std::size_t &mark)
      {
        if (mark == std::string::npos || mark == 0)
          return "";
        const std::size_t before = piece.find_last_of(":=", mark - 1);
        const std::string name   = trim(piece.substr(mark + 1));
        if (before == std::string::npos || name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])))
          return "";
        std::string tail = piece.substr(mark);
        piece.resize(mark);
        mark = before;
        return tail;
      }

      const KnownEntry   &entry;
      const std::string  &where;
      std::optional<Unit> own;

      [[noreturn]] void refuse(const std::string &text, const std::string &found) const
      {
        throw InputError(
          message({where + ": '" + entry.name + "' = " + quote(text) + ": " + found + ".",
                   own ? "  Unit of this entry: " + entry.unit + "; units that it takes: " + list_units_like(*own) + "."
                       : "  This entry is a plain number.",
                   "  A number without a unit is in " + (own ? entry.unit : std::string("no unit")) + "."}));
      }

      void require_no_unknown_unit(const std::string &text) const
      {
        if (const Quantity given = split(text, false); !given.unit.empty())
          refuse(text, "the unit '" + given.unit + "' is not known");
      }

      bool is_mine(const std::string &unit) const
      {
        return parse_unit(unit)->dimension == own.value_or(Unit()).dimension;
      }

      std::string convert(const std::string &text, const Quantity &given) const
      {
        if (!is_mine(given.unit))
          refuse(text, "'" + given.unit + "' is a unit of something else");
        const Unit unit = *parse_unit(given.unit), mine = own.value_or(Unit());
        const int  exponent = unit.exponent - mine.exponent;
        // A decimal number in decimal units is the decimal number that it means, to the last bit.
        if (unit.factor == mine.factor && unit.offset == 0. && is_plain(given.formula) &&
            given.formula.find_first_of("eE") == std::string::npos)
          return text_of(dealii::Utilities::string_to_double(given.formula + "e" + std::to_string(exponent)));
        const double value = is_plain(given.formula) ? dealii::Utilities::string_to_double(given.formula)
                                                     : *evaluate_arithmetic(given.formula);
        return text_of(unit.to_si(value) / mine.to_si(1.));
      }
    };
  } // namespace

  std::string read_typed_numbers(const std::string &text, const KnownEntry &entry, const std::string &where)
  {
    const Kind   kind = kind_of(entry);
    const Reader reader(entry, where);
    switch (kind)
      {
      case Kind::number:
      case Kind::integer:
        if (const std::size_t comma = text.find(',');
            comma != std::string::npos && is_plain(std::string(text).replace(comma, 1, ".")))
          throw InputError(
            message({where + ": '" + entry.name + "' = " + quote(text) + ": a decimal comma.",
                     "  Decimals are written with a point: " + std::string(text).replace(comma, 1, ".") + "."}));
        return reader.number(text);
      case Kind::list:
        return reader.list(text);
      case Kind::text:
        return parse_unit(entry.unit) || entry.default_value == "table" ? reader.pieces(text) : text;
      case Kind::other:
        return text;
      }
    return text;
  }

  std::vector<std::string> share_unit(const std::vector<std::string> &values, const bool either,
                                      const KnownEntry &entry, const std::string &where)
  {
    const Kind kind = kind_of(entry);
    return kind == Kind::other || (kind == Kind::text && !parse_unit(entry.unit))
             ? values
             : Reader(entry, where).share_unit(values, either);
  }
} // namespace birdstrike
