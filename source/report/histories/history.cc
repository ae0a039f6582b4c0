#include <birdstrike/core/log.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/history.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <utility>

#include "report/histories/history_hdf5.h"

namespace birdstrike
{
  namespace
  {
    std::size_t compute_size(const std::vector<History::Axis> &axes)
    {
      std::size_t size = 1;
      for (const History::Axis &axis : axes)
        size *= axis.values.size();
      return size;
    }

    /// The value, if it is one.
    double require_number(const std::filesystem::path &table, const Column &what, const double value)
    {
      if (std::isfinite(value))
        return value;
      FailureFacts facts{"A row has a value that is no number, and is not written to '" + table.filename().string() +
                           "'",
                         what.name, value, what.unit};
      facts.advice = "Reduce Time/Step scale and Time/Bird step scale, and check the rows and fields before.";
      throw NumericalFailure(std::move(facts));
    }

    /// The shortest digits that read back as the same number.
    void add_number(std::string &line, const double value)
    {
      char       digits[32];
      const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
      line.append(digits, end);
    }
  } // namespace

  History::History(const std::filesystem::path &folder, const bool write_hdf5, const std::string &table)
    : folder(folder), table(folder / table), write_hdf5(write_hdf5)
  {
    if (!std::filesystem::is_directory(folder))
      throw std::runtime_error("Cannot write " + this->table.string() + ": there is no such folder.");
  }

  History::~History()
  {
    try
      {
        // deal.II's HDF5 objects abort the process when they are destroyed while an exception unwinds the stack: a
        // failing run keeps its table, and of results.h5 what its owner flushed.
        if (std::uncaught_exceptions() > 0)
          write_csv_rows();
        else
          flush();
      }
    catch (const std::exception &error)
      {
        log().error("{}", error.what());
      }
  }

  std::string History::group() const
  {
    return table.stem().string();
  }

  void History::add_group(const History &other)
  {
    require_new_name(other.group());
    groups.push_back(&other);
  }

  void History::require_new_name(const std::string &name) const
  {
    const auto is_taken = [&](const auto &item) { return item.what.name == name; };
    if (name.empty() || name == group() || std::any_of(columns.begin(), columns.end(), is_taken) ||
        std::any_of(profiles.begin(), profiles.end(), is_taken))
      throw std::logic_error("History: the name '" + name + "' is empty or taken.");
    if (rows > 0)
      throw std::logic_error("History: '" + name + "' is added after the first row.");
  }

  void History::add_column(const Column &what, std::function<double()> value)
  {
    require_new_name(what.name);
    if (what.name.find_first_of(", \n/") != std::string::npos)
      throw std::logic_error("History: the name '" + what.name + "' holds a comma, a blank or a slash.");
    columns.push_back({what, std::move(value), {}});
  }

  void History::add_profile(const Column &what, std::vector<Axis> axes, std::function<void(std::span<double>)> fill)
  {
    require_new_name(what.name);
    const std::size_t size = compute_size(axes);
    if (size > 0 && write_hdf5)
      profiles.push_back({what, std::move(axes), size, std::move(fill), {}});
  }

  void History::set_constant(const Column &what, std::vector<Axis> axes, std::vector<double> values)
  {
    const std::size_t size = compute_size(axes);
    if (size != values.size() || what.name == group())
      throw std::logic_error("History: '" + what.name + "' has " + std::to_string(values.size()) + " values for " +
                             std::to_string(size) + " places.");
    for (const double value : values)
      require_number(table, what, value);
    if (size > 0)
      constants[what.name] = {what, std::move(axes), size, {}, std::move(values)};
  }

  void History::append_row()
  {
    std::vector<double>              row;
    std::vector<std::vector<double>> of_profiles;
    for (const Curve &column : columns)
      row.push_back(require_number(table, column.what, column.value()));
    for (const Profile &profile : profiles)
      {
        of_profiles.emplace_back(profile.size);
        profile.fill(of_profiles.back());
        for (const double value : of_profiles.back())
          require_number(table, profile.what, value);
      }
    for (std::size_t k = 0; k < columns.size(); ++k)
      columns[k].rows.push_back(row[k]);
    for (std::size_t k = 0; k < profiles.size(); ++k)
      profiles[k].rows.insert(profiles[k].rows.end(), of_profiles[k].begin(), of_profiles[k].end());
    ++rows;
  }

  void History::write_csv_header()
  {
    std::string names;
    for (std::size_t i = 0; i < columns.size(); ++i)
      {
        csv << "# " << i + 1 << ": " << columns[i].what.name << " [" << columns[i].what.unit << "]\n";
        names += (i > 0 ? "," : "") + columns[i].what.name;
      }
    csv << names << '\n';
  }

  void History::write_csv_rows()
  {
    if (rows_in_file == 0 && rows > 0) // not before there are rows: a run that goes on keeps the table until then
      {
        csv.open(table, std::ios::binary);
        write_csv_header();
      }
    std::string line;
    for (; rows_in_file < rows; ++rows_in_file)
      {
        line.clear();
        for (const Curve &column : columns)
          {
            if (!line.empty())
              line += ',';
            add_number(line, column.rows[rows_in_file]);
          }
        csv << line << '\n';
      }
    csv.flush();
    if (!csv)
      throw std::runtime_error("Cannot write " + table.string() + ": is the disk full?");
  }

  void History::flush_table()
  {
    write_csv_rows();
  }

  void History::flush()
  {
    const bool has_new_rows = rows_in_file < rows;
    write_csv_rows();
    if (write_hdf5 && (has_new_rows || !constants.empty()))
      write_results();
  }

  void History::write_results() const
  {
    ResultsFile results(folder / "results.h5");
    const auto  write_columns = [&](const History &of) {
      for (const Curve &column : of.columns)
        if (of.rows > 0)
          results.write(of.group(), column.what.name, column.what, {of.rows}, column.rows);
    };
    write_columns(*this);
    for (const History *other : groups)
      write_columns(*other);
    const auto write = [&](const Profile &profile, std::vector<std::size_t> shape) {
      for (const Axis &axis : profile.axes)
        {
          shape.push_back(axis.values.size());
          results.write(profile.what.name, axis.what.name, axis.what, {axis.values.size()}, axis.values);
        }
      if (!profile.rows.empty())
        results.write(profile.what.name, "values", profile.what, shape, profile.rows);
    };
    for (const Profile &profile : profiles)
      write(profile, {rows});
    for (const auto &[name, constant] : constants)
      write(constant, {});
    results.close();
  }

  std::size_t History::n_rows() const
  {
    return rows;
  }

  std::vector<std::string> History::column_names() const
  {
    std::vector<std::string> names;
    for (const Curve &column : columns)
      names.push_back(column.what.name);
    return names;
  }

  const std::vector<double> &History::column(const std::string &name) const
  {
    for (const Curve &column : columns)
      if (column.what.name == name)
        return column.rows;
    throw std::logic_error("History: there is no column '" + name + "'.");
  }

  std::size_t History::bytes_per_row() const
  {
    // 18 characters are the mean length of a printed double with its comma (measured on sampled sines).
    std::size_t bytes = columns.size() * (18 + (write_hdf5 ? sizeof(double) : 0));
    for (const Profile &profile : profiles)
      bytes += profile.size * sizeof(double);
    return bytes;
  }
} // namespace birdstrike
