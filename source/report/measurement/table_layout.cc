#include "report/measurement/table_layout.h"
#include "report/measurement/data_table.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Fields = std::vector<std::string>;

    bool is_separator(const char letter, const char separator)
    {
      return letter == separator || (separator == ' ' && letter == '\t');
    }

    /// Also with a decimal comma, which is refused later, in words.
    bool looks_like_number(std::string text)
    {
      if (const auto comma = text.find(','); comma != std::string::npos)
        text[comma] = '.';
      return parse_cell(text).has_value();
    }

    bool has_number(const Fields &fields)
    {
      return std::ranges::any_of(fields, looks_like_number);
    }

    /// How many fields more than half of the rows have; 1 where no number is so usual.
    std::size_t usual_size(const std::vector<Fields> &rows)
    {
      std::map<std::size_t, std::size_t> n_of;
      for (const Fields &row : rows)
        if (2 * ++n_of[row.size()] > rows.size())
          return row.size();
      return 1;
    }

    /// What the rows of a table have in common.
    struct Pattern
    {
      char              separator = ',';
      std::size_t       n_fields  = 1;
      std::vector<bool> is_number = {}; ///< of a field: in at least half of those that are not empty

      void look_at(const std::vector<Fields> &rows)
      {
        for (std::size_t k = 0; k < n_fields; ++k)
          {
            std::size_t n_numbers = 0, n_filled = 0;
            for (const Fields &row : rows)
              if (row.size() == n_fields && !row[k].empty())
                {
                  ++n_filled;
                  n_numbers += looks_like_number(row[k]) ? 1 : 0;
                }
            is_number.push_back(n_numbers > 0 && 2 * n_numbers >= n_filled);
          }
      }

      bool fits(const Fields &row) const
      {
        bool has_some = false;
        for (std::size_t k = 0; k < row.size() && row.size() == n_fields; ++k)
          if (is_number[k] && !row[k].empty())
            {
              if (!looks_like_number(row[k]))
                return false;
              has_some = true;
            }
        return has_some;
      }

      /// Rows may end with a separator where the names do not.
      bool could_be_names(const Fields &row) const
      {
        return (row.size() == n_fields || row.size() + 1 == n_fields) && !has_number(row);
      }
    };

    std::vector<Fields> split_end(const std::vector<TableLine> &lines, const char separator)
    {
      constexpr std::size_t most = 100;
      const std::size_t     n    = std::clamp<std::size_t>(lines.size() / 2, 1, most);
      std::vector<Fields>   rows;
      for (std::size_t k = lines.size() - n; k < lines.size(); ++k)
        rows.push_back(split_fields(lines[k].text, separator));
      return rows;
    }

    /// Where the end of the lines shows no separator, their beginning does, so that a row that is cut off is found.
    Pattern find_pattern(const std::vector<TableLine> &lines, const std::optional<char> given)
    {
      Pattern pattern;
      for (const char separator : given ? std::string(1, *given) : std::string(";\t, "))
        if (const std::size_t n = usual_size(split_end(lines, separator)); n > 1 && pattern.n_fields == 1)
          pattern = {separator, n};
      for (const char separator : given ? std::string(1, *given) : std::string(";\t,"))
        if (const std::size_t n = split_fields(lines[0].text, separator).size(); n > 1 && pattern.n_fields == 1)
          pattern = {separator, n};
      pattern.look_at(split_end(lines, pattern.separator));
      return pattern;
    }

    bool is_time(std::string name)
    {
      std::string unit;
      take_unit(name, unit);
      std::ranges::transform(name, name.begin(), [](const unsigned char c) { return std::tolower(c); });
      static const std::set<std::string> times{"time", "t"};
      return times.contains(name) || !unit.empty();
    }

    std::string without_brackets(const std::string &field)
    {
      const bool is_in = field.size() > 1 && ((field.front() == '[' && field.back() == ']') ||
                                              (field.front() == '(' && field.back() == ')'));
      return is_in ? trim_field(field.substr(1, field.size() - 2)) : field;
    }

    /// Whether this line below one that could have the names is of units; `is_second`: of the file, where they are
    /// expected even if no unit in it is known.
    bool is_of_units(const Fields &fields, const bool is_second)
    {
      const bool has_known = std::ranges::any_of(fields, [](const std::string &field) {
        const std::string unit = without_brackets(field);
        return unit != field || (!unit.empty() && parse_column_unit(unit).has_value());
      });
      return has_known || (is_second && std::ranges::none_of(fields, is_time));
    }
  } // namespace

  std::string trim_field(const std::string &text)
  {
    const auto begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
  }

  std::vector<std::string> split_fields(const std::string &line, const char separator)
  {
    Fields fields(1);
    bool   is_quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k)
      {
        std::string &field = fields.back();
        if (line[k] == '"' && is_quoted && k + 1 < line.size() && line[k + 1] == '"')
          field += line[++k];
        else if (line[k] == '"' && (is_quoted || trim_field(field).empty()))
          is_quoted = !is_quoted;
        else if (is_separator(line[k], separator) && !is_quoted)
          {
            if (separator != ' ' || !field.empty())
              fields.emplace_back();
          }
        else
          field += line[k];
      }
    if (is_quoted)
      return {};
    if (separator == ' ' && fields.back().empty())
      fields.pop_back();
    std::ranges::transform(fields, fields.begin(), trim_field);
    return fields;
  }

  std::optional<double> parse_cell(const std::string &text)
  {
    double      value       = 0.;
    const char *begin       = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      return {};
    return value;
  }

  void take_unit(std::string &name, std::string &unit)
  {
    const auto take = [&](const std::size_t open, const std::size_t width, const std::size_t end) {
      unit = trim_field(name.substr(open + width, end - open - width));
      name = trim_field(name.substr(0, open));
    };
    const auto is_known = [&](const std::size_t open, const std::size_t width, const std::size_t end) {
      const std::string inside = trim_field(name.substr(open + width, end - open - width));
      return open > 0 && !inside.empty() && parse_column_unit(inside).has_value();
    };
    const std::size_t square = name.rfind('['), round = name.rfind('('), stroke = name.rfind(" / ");
    if (name.empty())
      return;
    if (square != std::string::npos && name.back() == ']')
      take(square, 1, name.size() - 1);
    else if (round != std::string::npos && name.back() == ')' && is_known(round, 1, name.size() - 1))
      take(round, 1, name.size() - 1);
    else if (stroke != std::string::npos && is_known(stroke, 3, name.size()))
      take(stroke, 3, name.size());
  }

  TableLayout find_layout(const std::vector<TableLine> &lines, const std::optional<char> separator)
  {
    const Pattern pattern   = find_pattern(lines, separator);
    const auto    fields_of = [&](const std::size_t k) { return split_fields(lines[k].text, pattern.separator); };
    TableLayout   layout{pattern.separator};
    std::size_t   row = 0;
    while (row < lines.size() && !pattern.fits(fields_of(row)))
      ++row;
    std::size_t names = row;
    while (names > 0 && !pattern.could_be_names(fields_of(names - 1)))
      --names;
    if (row < lines.size() && names > 0)
      layout.names = names - 1;
    layout.first_row = layout.names + 1;
    if (layout.names > 0 && pattern.could_be_names(fields_of(layout.names - 1)) &&
        is_of_units(fields_of(layout.names), layout.names == 1))
      {
        layout.units = layout.names;
        --layout.names;
      }
    return layout;
  }
} // namespace birdstrike
