#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/column.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Curves over time. A column is a name, a unit and a function that gives its present value; a row asks all of them.
  ///
  /// history.csv: a header that numbers the columns with their units (lines "# 1: time [s]", as ASPECT's statistics
  /// file), one line with the names, then rows with 17 digits. results.h5: /history/<column> [rows], and for each
  /// profile /<profile>/values [rows][shape...] with its axes /<profile>/<axis>; every dataset has the attributes
  /// "name", "unit" and "description". Of a table of another name the file and the group are called by it. Raises
  /// std::logic_error for a name used twice or a column added after the first row, std::runtime_error where the disk
  /// refuses. Does not decide when a row is due.
  class History
  {
  public:
    struct Axis
    {
      Column              what; ///< e.g. "chord"
      std::vector<double> values;
    };

    /// Opens folder/`table`; folder/results.h5 too if `write_hdf5`.
    History(const std::filesystem::path &folder, bool write_hdf5, const std::string &table = "history.csv");
    ~History(); ///< flushes (while an exception unwinds: the table only); an error of the disk is logged

    void add_column(const Column &what, std::function<double()> value);

    /// An array over `axes` (row-major, last axis fastest) in every row, for results.h5 only: e.g. root stress over
    /// [chord station][face]. `fill` writes the present values.
    void add_profile(const Column &what, std::vector<Axis> axes, std::function<void(std::span<double>)> fill);

    /// Columns of another table (without profiles), which outlives this one, go to results.h5 too: its own group.
    void add_group(const History &other);

    /// Asks every column and profile for its present value. Throws NumericalFailure where one is no number: there is
    /// no such row.
    void append_row();

    /// Brings history.csv up to date: writes the new rows only, so that its cost does not grow with the run.
    void flush_table();

    /// Brings history.csv and results.h5 up to date on disk; results.h5 is written anew as a whole.
    void flush();

    /// All rows so far; reading writes the table anew.
    void archive(Archive &archive);

    std::size_t                n_rows() const;
    std::vector<std::string>   column_names() const;
    const std::vector<double> &column(const std::string &name) const; ///< all rows so far
    std::size_t                bytes_per_row() const;                 ///< in both files together, about

    /// A further result that does not change in time: /<name> [shape of the axes], written by the next flush.
    void set_constant(const Column &what, std::vector<Axis> axes, std::vector<double> values);

  private:
    struct Curve
    {
      Column                  what;
      std::function<double()> value;
      std::vector<double>     rows;
    };
    struct Profile
    {
      Column                                 what;
      std::vector<Axis>                      axes;
      std::size_t                            size = 0;
      std::function<void(std::span<double>)> fill;
      std::vector<double>                    rows;
    };

    std::filesystem::path          folder, table;
    bool                           write_hdf5;
    std::ofstream                  csv;
    std::vector<Curve>             columns;
    std::vector<Profile>           profiles;
    std::map<std::string, Profile> constants;
    std::vector<const History *>   groups; ///< besides its own
    std::size_t                    rows         = 0;
    std::size_t                    rows_in_file = 0;

    std::string group() const; ///< in results.h5
    void        require_new_name(const std::string &name) const;
    void        write_csv_header();
    void        write_csv_rows();
    void        write_results() const;
  };
} // namespace birdstrike
