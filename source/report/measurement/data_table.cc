#include "report/measurement/data_table.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    std::string trim(std::string text)
    {
      const auto begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
      return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
    }

    /// Fields of a line, without what stands around them. One that begins with a quotation mark ends with one, and
    /// holds separators and doubled marks as letters. Empty where a mark is not closed.
    std::vector<std::string> split(const std::string &line, const char separator)
    {
      std::vector<std::string> fields(1);
      bool                     is_quoted = false;
      for (std::size_t k = 0; k < line.size(); ++k)
        {
          std::string &field = fields.back();
          if (line[k] == '"' && is_quoted && k + 1 < line.size() && line[k + 1] == '"')
            field += line[++k];
          else if (line[k] == '"' && (is_quoted || trim(field).empty()))
            is_quoted = !is_quoted;
          else if (line[k] == separator && !is_quoted)
            fields.emplace_back();
          else
            field += line[k];
        }
      if (is_quoted)
        return {};
      std::ranges::transform(fields, fields.begin(), trim);
      return fields;
    }

    /// Of a line of names: semicolons before tabulators before commas.
    char find_separator(const std::string &names)
    {
      for (const char separator : {';', '\t'})
        if (split(names, separator).size() > 1)
          return separator;
      return ',';
    }

    bool parse(const std::string &text, double &value)
    {
      const char *begin       = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
      const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
      return error == std::errc() && end == text.data() + text.size() && value - value == 0.;
    }

    /// "force [kN]" -> "force" and "kN".
    void take_unit(TableColumn &column)
    {
      const auto open = column.name.rfind('[');
      if (open == std::string::npos || column.name.back() != ']')
        return;
      column.unit = trim(column.name.substr(open + 1, column.name.size() - open - 2));
      column.name = trim(column.name.substr(0, open));
    }

    struct Line
    {
      std::size_t number;
      std::string text;
    };

    struct UnitAt
    {
      std::string unit;
      std::size_t line;
    };

    /// Units by names from comments "# 3: force [kN]".
    void read_comment(const Line &line, std::map<std::string, UnitAt> &units)
    {
      const auto colon = line.text.find(": ");
      if (colon == std::string::npos || line.text.find_first_not_of("# 0123456789") != colon)
        return;
      TableColumn column{trim(line.text.substr(colon + 2)), "", {}};
      take_unit(column);
      units[column.name] = {column.unit, line.number};
    }

    constexpr const char *nothing = " \t\r,;\"";

    class Reader
    {
    public:
      explicit Reader(const std::filesystem::path &file) : path(file)
      {
        std::ifstream in(file);
        if (!in || std::filesystem::is_directory(file))
          throw InputError("Cannot read the table " + file.string() + ": there is no such file.");
        std::size_t number = 0;
        for (std::string line; std::getline(in, line);)
          {
            ++number;
            if (number == 1 && line.starts_with("\xEF\xBB\xBF")) // as spreadsheets begin UTF-8
              line.erase(0, 3);
            if (const auto first = line.find_first_not_of(" \t\r\""); first != std::string::npos && line[first] == '#')
              read_comment({number, line}, units);
            else if (line.find_first_not_of(nothing) != std::string::npos) // spreadsheets end with rows of separators
              lines.push_back({number, line});
          }
        if (lines.size() < 2)
          throw InputError(file.string() + " holds no table: a line of names and rows of numbers are needed.");
      }

      std::vector<TableColumn> read()
      {
        separator = find_separator(lines[0].text);
        std::vector<TableColumn> columns;
        for (const std::string &name : fields_of(lines[0]))
          add(columns, name);
        std::size_t row = 1;
        double      number;
        auto        fields = fields_of(lines[1]);
        if (std::ranges::none_of(fields, [&](const std::string &field) { return parse(field, number); }) &&
            fields.size() == columns.size())
          {
            for (std::size_t k = 0; k < columns.size(); ++k)
              if (!fields[k].empty())
                {
                  columns[k].unit         = fields[k].starts_with('[') && fields[k].ends_with(']')
                                              ? trim(fields[k].substr(1, fields[k].size() - 2))
                                              : fields[k];
                  columns[k].line_of_unit = lines[1].number;
                }
            ++row;
          }
        for (; row < lines.size(); ++row)
          read_row(lines[row], columns);
        for (TableColumn &column : columns)
          if (column.fault.empty())
            convert(column);
        return columns;
      }

    private:
      std::filesystem::path         path;
      std::map<std::string, UnitAt> units;
      std::vector<Line>             lines;
      char                          separator = ',';

      std::string at(const std::size_t line, const std::string &why) const
      {
        return path.string() + ", line " + std::to_string(line) + ": " + why;
      }

      [[noreturn]] void refuse(const std::size_t line, const std::string &why) const
      {
        throw InputError(at(line, why));
      }

      std::vector<std::string> fields_of(const Line &line) const
      {
        auto fields = split(line.text, separator);
        if (fields.empty())
          refuse(line.number, "a quotation mark is not closed.");
        return fields;
      }

      void add(std::vector<TableColumn> &columns, const std::string &name)
      {
        TableColumn column{name, "", {}};
        double      number;
        if (name.empty())
          refuse(lines[0].number, "column " + std::to_string(columns.size() + 1) + " has no name.");
        if (parse(name, number))
          refuse(lines[0].number, "'" + name + "' is no name: the first line that is no comment holds the names.");
        take_unit(column);
        column.line_of_unit = lines[0].number;
        if (const auto found = units.find(column.name); column.unit.empty() && found != units.end())
          {
            column.unit         = found->second.unit;
            column.line_of_unit = found->second.line;
          }
        for (TableColumn &other : columns)
          if (other.name == column.name)
            other.fault = at(lines[0].number, "two columns are called '" + column.name + "'.");
        columns.push_back(std::move(column));
      }

      void read_row(const Line &line, std::vector<TableColumn> &columns) const
      {
        const auto fields = fields_of(line);
        if (fields.size() != columns.size())
          refuse(line.number, std::to_string(fields.size()) + " fields, where there are " +
                                std::to_string(columns.size()) + " names." +
                                (separator == ',' ? " Numbers have a decimal point, no comma." : ""));
        for (std::size_t k = 0; k < fields.size(); ++k)
          {
            double value = std::numeric_limits<double>::quiet_NaN();
            if (!fields[k].empty() && !parse(fields[k], value) && columns[k].fault.empty())
              columns[k].fault = at(
                line.number, "'" + fields[k] + "' in column '" + columns[k].name + "' is no number" +
                               (fields[k].find(',') != std::string::npos ? ": write a decimal point, no comma." : "."));
            columns[k].values.push_back(value);
          }
      }

      void convert(TableColumn &column) const
      {
        static const std::set<std::string> none{"", "-", "count", "share"};
        if (none.contains(column.unit))
          return;
        const auto unit = parse_column_unit(column.unit);
        if (!unit)
          column.fault = at(column.line_of_unit,
                            "'" + column.unit + "' of column '" + column.name +
                              "' is no unit that is known here. prm/README.md lists those that are: mm, us, kN, MPa.");
        for (double &value : column.values)
          value = unit ? unit->to_si(value) : value;
      }
    };
  } // namespace

  std::optional<Unit> parse_column_unit(const std::string &text)
  {
    static const std::pair<const char *, const char *> plain[] = {
      {"\xC2\xB5", "u"}, {"\xCE\xBC", "u"}, {"\xCE\xB5", "e"}, {"\xCF\xB5", "e"}, {"\xB5", "u"}}; // the last: Latin-1
    static const std::set<std::string> microstrains{"ue", "ustrain", "microstrain", "microstrains"};
    std::string                        name = text;
    for (const auto &[letter, latin] : plain)
      for (std::size_t at = 0; (at = name.find(letter, at)) != std::string::npos;)
        name.replace(at, std::string(letter).size(), latin);
    return microstrains.contains(name) ? parse_unit("um/m") : parse_unit(name);
  }

  DataTable::DataTable(const std::filesystem::path &file) : path(file), all(Reader(file).read())
  {
  }

  const TableColumn &DataTable::column(const std::string &name) const
  {
    std::string names;
    for (const TableColumn &column : all)
      {
        if (column.name == name)
          {
            if (!column.fault.empty())
              throw InputError(column.fault);
            return column;
          }
        names += (names.empty() ? "" : ", ") + column.name;
      }
    constexpr std::size_t most = 400;
    throw InputError("There is no column '" + name + "' in " + path.string() +
                     ".\nIt has: " + (names.size() > most ? names.substr(0, most) + " ..." : names) + ".");
  }

  bool DataTable::has(const std::string &name) const
  {
    return std::ranges::any_of(all, [&](const TableColumn &column) { return column.name == name; });
  }

  std::vector<std::string> DataTable::names() const
  {
    std::vector<std::string> names;
    for (const TableColumn &column : all)
      names.push_back(column.name);
    return names;
  }

  const std::filesystem::path &DataTable::file() const
  {
    return path;
  }
} // namespace birdstrike
