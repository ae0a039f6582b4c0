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
    unsigned int        colour    = 0; ///< number in the palette
    bool                is_dashed = false;
  };

  /// A quantity on an axis: what it is, its SI unit in the data, and how it is shown: multiplied, with another unit.
  struct FigureAxis
  {
    std::string quantity;
    std::string unit;
    std::string shown_unit;
    double      factor = 1.; ///< shown unit per SI unit
  };

  struct FigurePanel
  {
    std::string             title;
    FigureAxis              x, y;
    std::vector<FigureLine> lines;
    double                  x_end = 0.; ///< where the picture ends, of the data's unit; 0: where the data do
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
  /// for each line of each panel a column x and a column y, one after the other; shorter ones end in empty fields.
  std::string data_of(const Figure &figure);

  /// A gnuplot script that reads the figures' data and draws stem.svg for each, run in their folder.
  std::string script_of(const std::vector<Figure> &figures);
} // namespace birdstrike
