#include "report/measurement/data_table.h"
#include "report/measurement/table_layout.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/text/text_file.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace birdstrike
{
  namespace
  {
    struct UnitAt
    {
      std::string unit;
      std::size_t line;
    };

    /// Units by names from comments "# 3: force [kN]".
    void read_comment(const TableLine &line, std::map<std::string, UnitAt> &units)
    {
      const auto colon = line.text.find(": ");
      if (colon == std::string::npos || line.text.find_first_not_of("# 0123456789") != colon)
        return;
      std::string name = trim_field(line.text.substr(colon + 2)), unit;
      take_unit(name, unit);
      units[name] = {unit, line.number};
    }

    constexpr const char *nothing = " \t,;\"";

    class Reader
    {
    public:
      explicit Reader(const std::filesystem::path &file) : path(file)
      {
        const auto text = read_text_file(file);
        if (!text)
          throw InputError("Cannot read the table " + file.string() + ": there is no such file.");
        if (const std::string what = describe_no_text(*text); !what.empty())
          throw InputError(file.string() + " holds no table of text. It holds " + what + ".");
        std::istringstream  in(*text);
        std::optional<char> named;
        std::size_t         number = 0;
        for (std::string line; std::getline(in, line);)
          {
            ++number;
            if (const auto separator = named_separator(line); separator && lines.empty())
              named = separator;
            else if (const auto first = line.find_first_not_of(" \t\"");
                     first != std::string::npos && line[first] == '#')
              read_comment({number, line}, units);
            else if (line.find_first_not_of(nothing) != std::string::npos) // spreadsheets end with rows of separators
              lines.push_back({number, line});
          }
        if (lines.size() < 2)
          throw InputError(file.string() + " holds no table: a line of names and rows of numbers are needed.");
        layout = find_layout(lines, named);
      }

      std::vector<TableColumn> read(std::vector<std::size_t> &lines_of_rows)
      {
        std::vector<TableColumn> columns;
        for (const std::string &name : without_empty_end(fields_of(names())))
          add(columns, name);
        if (layout.units)
          read_units(lines[*layout.units], columns);
        for (std::size_t row = layout.first_row; row < lines.size(); ++row)
          {
            read_row(lines[row], columns);
            lines_of_rows.push_back(lines[row].number);
          }
        for (TableColumn &column : columns)
          if (column.fault.empty())
            convert(column);
        if (layout.names > 0)
          log().info("{}: the names are in line {}; lines of text above it: {}, passed over.", path.string(),
                     names().number, layout.names);
        return columns;
      }

    private:
      std::filesystem::path         path;
      std::map<std::string, UnitAt> units;
      std::vector<TableLine>        lines;
      TableLayout                   layout;

      const TableLine &names() const
      {
        return lines[layout.names];
      }

      /// Some programs end each line with a separator.
      static std::vector<std::string> without_empty_end(std::vector<std::string> fields)
      {
        while (fields.size() > 1 && fields.back().empty())
          fields.pop_back();
        return fields;
      }

      std::string at(const std::size_t line, const std::string &why) const
      {
        return path.string() + ", line " + std::to_string(line) + ": " + why;
      }

      [[noreturn]] void refuse(const std::size_t line, const std::string &why) const
      {
        throw InputError(at(line, why));
      }

      std::vector<std::string> fields_of(const TableLine &line) const
      {
        auto fields = split_fields(line.text, layout.separator);
        if (fields.empty())
          refuse(line.number, "a quotation mark is not closed.");
        return fields;
      }

      void add(std::vector<TableColumn> &columns, const std::string &written)
      {
        TableColumn column{written, "", {}};
        if (written.empty())
          refuse(names().number, "column " + std::to_string(columns.size() + 1) + " has no name.");
        if (parse_cell(written))
          refuse(names().number,
                 "'" + written + "' is no name: the line above the first row of numbers holds the names.");
        column.written = written;
        take_unit(column.name, column.unit);
        column.line_of_unit = names().number;
        if (const auto found = units.find(column.name); column.unit.empty() && found != units.end())
          {
            column.unit         = found->second.unit;
            column.line_of_unit = found->second.line;
          }
        for (TableColumn &other : columns)
          if (other.name == column.name)
            other.twice = column.twice = at(names().number, "two columns are called '" + column.name + "'.");
        columns.push_back(std::move(column));
      }

      void read_units(const TableLine &line, std::vector<TableColumn> &columns) const
      {
        const auto fields = fields_of(line);
        for (std::size_t k = 0; k < columns.size() && k < fields.size(); ++k)
          if (const std::string &field = fields[k]; !field.empty())
            {
              const bool is_bracketed =
                (field.starts_with('[') && field.ends_with(']')) || (field.starts_with('(') && field.ends_with(')'));
              columns[k].unit         = is_bracketed ? trim_field(field.substr(1, field.size() - 2)) : field;
              columns[k].line_of_unit = line.number;
            }
      }

      void read_row(const TableLine &line, std::vector<TableColumn> &columns) const
      {
        auto fields = fields_of(line);
        while (fields.size() > columns.size() && fields.back().empty())
          fields.pop_back();
        if (fields.size() != columns.size())
          refuse(line.number, std::to_string(fields.size()) + " fields, where there are " +
                                std::to_string(columns.size()) + " names in line " + std::to_string(names().number) +
                                "." + (layout.separator == ',' ? " Numbers have a decimal point, no comma." : ""));
        for (std::size_t k = 0; k < fields.size(); ++k)
          {
            const auto value = parse_cell(fields[k]);
            if (!value && !fields[k].empty() && columns[k].fault.empty())
              columns[k].fault = at(
                line.number, "'" + fields[k] + "' in column '" + columns[k].name + "' is no number" +
                               (fields[k].find(',') != std::string::npos ? ": write a decimal point, no comma." : "."));
            columns[k].values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
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

  DataTable::DataTable(const std::filesystem::path &file) : path(file), all(Reader(file).read(lines_of_rows))
  {
  }

  const TableColumn *DataTable::find(const std::string &name) const
  {
    const auto written = std::ranges::find(all, name, &TableColumn::written);
    const auto found   = written != all.end() && std::ranges::count(all, name, &TableColumn::written) == 1
                           ? written
                           : std::ranges::find(all, name, &TableColumn::name);
    return found == all.end() ? nullptr : &*found;
  }

  const TableColumn &DataTable::column(const std::string &name) const
  {
    if (const TableColumn *found = find(name))
      {
        const bool is_by_name = found->written != name || found->name == name;
        if (is_by_name && !found->twice.empty())
          throw InputError(found->twice);
        if (!found->fault.empty())
          throw InputError(found->fault);
        return *found;
      }
    std::string list;
    for (const TableColumn &column : all)
      list += (list.empty() ? "" : ", ") + column.name;
    constexpr std::size_t most = 400;
    throw InputError("There is no column '" + name + "' in " + path.string() +
                     ".\nIt has: " + (list.size() > most ? list.substr(0, most) + " ..." : list) + ".");
  }

  bool DataTable::has(const std::string &name) const
  {
    return find(name) != nullptr;
  }

  std::size_t DataTable::line_of_row(const std::size_t row) const
  {
    return lines_of_rows[row];
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
