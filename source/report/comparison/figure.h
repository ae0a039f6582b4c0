#pragma once

#include <string>
#include <vector>

/// Pictures as data and a gnuplot script, so that a reader can redraw or change them without this program.
namespace birdstrike
{
  /// One curve: y over x, both in SI units.
  struct FigureLine
  {
    std::string         title; ///< in the legend; empty: none
    std::vector<double> x, y;
    unsigned int        style      = 0;     ///< colour and dashes: the first 28 are all distinct
    bool                has_points = false; ///< each value is marked
    std::vector<double> bar        = {};    ///< half the length of an error bar, of y's unit; empty: no bars
    std::vector<double> colour     = {};    ///< not empty: cells of a map, one about each (x, y), and what they show

    /// 1 for a value that still rises at the end of its run and is no peak yet, else 0; empty: no value does. Such a
    /// value has an open marker, in a map a '+' behind its number.
    std::vector<double> is_rising = {};
  };

  /// A value that a reader looks for: a horizontal line across a panel, of the axis' SI unit.
  struct FigureLevel
  {
    std::string title; ///< in the legend; empty: none
    double      y;
  };

  /// A quantity on an axis: what it is, its SI unit in the data, and how it is shown: multiplied, with another unit.
  struct FigureAxis
  {
    std::string quantity;
    std::string unit;
    std::string shown_unit;
    double      factor = 1.; ///< shown unit per SI unit

    std::vector<std::string> ticks = {}; ///< texts at 1, 2, ...; empty: numbers
  };

  struct FigurePanel
  {
    std::string             title;
    FigureAxis              x, y;
    std::vector<FigureLine> lines;
    double x_begin = 0., x_end = 0.; ///< where the picture begins and ends, of the data's unit; both 0: as the data
    std::vector<FigureLevel> levels = {};
    FigureAxis               colour = {}; ///< of a map
  };

  /// Panels in rows that share one file.
  struct Figure
  {
    std::string              stem; ///< of its files: stem.csv, stem.svg
    unsigned int             n_columns = 1;
    std::vector<FigurePanel> panels;

    bool has_lines() const;
  };

  /// The data of a figure: a head that numbers the columns with their units as history.csv does, a line of names, then
  /// for each line of each panel a column x, a column y and, where there are, one of bars, one of colours and one that
  /// marks values that still rise; shorter ones end in empty fields.
  std::string data_of(const Figure &figure);

  /// A gnuplot script that reads the figures' data and draws stem.svg for each, run in their folder.
  std::string script_of(const std::vector<Figure> &figures);
} // namespace birdstrike
