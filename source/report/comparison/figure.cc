#include "report/comparison/figure.h"
#include "report/comparison/comparison_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Colours that the colour-blind tell apart: M. Okabe, K. Ito, "Color universal design" (2008).
    constexpr std::array<const char *, 7> palette{
      {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"}};

    constexpr unsigned int n_dashes = 4; ///< gnuplot's first dash types: full, dashed, dotted, dash-dotted

    constexpr unsigned int panel_width = 800, panel_height = 480; // pixels

    /// gnuplot's single-quoted text, in which only the quote itself is special.
    std::string quote(const std::string &text)
    {
      std::string quoted = "'";
      for (const char letter : text)
        quoted += letter == '\'' ? std::string("''") : std::string(1, letter);
      return quoted + "'";
    }

    std::string label(const FigureAxis &axis)
    {
      return axis.quantity + " [" + axis.shown_unit + "]";
    }

    std::vector<std::pair<std::string, const std::vector<double> *>> columns_of(const Figure &figure)
    {
      std::vector<std::pair<std::string, const std::vector<double> *>> columns;
      for (const FigurePanel &panel : figure.panels)
        for (const FigureLine &line : panel.lines)
          for (const bool is_x : {true, false})
            {
              const FigureAxis &axis = is_x ? panel.x : panel.y;
              columns.emplace_back(line.title + (line.title.empty() ? "" : ": ") + axis.quantity + " [" + axis.unit +
                                     "]",
                                   is_x ? &line.x : &line.y);
            }
      return columns;
    }

    /// `column`: number of the first line's x in the file.
    std::string plot_of(const FigurePanel &panel, const std::string &file, unsigned int column)
    {
      std::string text =
        "set title " + quote(panel.title) + "\nset xlabel " + quote(label(panel.x)) + "\nset ylabel " +
        quote(label(panel.y)) + "\nset xrange [" +
        (panel.x_end > 0. ? fmt::format("{}:{}", panel.x_begin * panel.x.factor, panel.x_end * panel.x.factor)
                          : "*:*") +
        "]\nplot ";
      for (const FigureLine &line : panel.lines)
        {
          const std::string title  = line.title.empty() ? "notitle" : "title " + quote(line.title);
          const auto        dashes = 1 + line.style / static_cast<unsigned int>(palette.size()) % n_dashes;
          text += fmt::format("{}{} using (${}*{}):(${}*{}) with lines lw 2 dt {} lc rgb '{}' {}",
                              &line == &panel.lines.front() ? "" : ", \\\n     ", quote(file), column, panel.x.factor,
                              column + 1, panel.y.factor, dashes, palette[line.style % palette.size()], title);
          column += 2;
        }
      for (const FigureLevel &level : panel.levels)
        text += fmt::format(", \\\n     {} with lines lw 1 dt 3 lc rgb '#404040' {}", level.y * panel.y.factor,
                            level.title.empty() ? "notitle" : "title " + quote(level.title));
      return text + "\n";
    }
  } // namespace

  bool Figure::has_lines() const
  {
    return std::any_of(panels.begin(), panels.end(), [](const FigurePanel &panel) { return !panel.lines.empty(); });
  }

  std::string data_of(const Figure &figure)
  {
    const auto  columns = columns_of(figure);
    std::string text, names;
    std::size_t n_rows = 0;
    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        text += fmt::format("# {}: {}\n", c + 1, columns[c].first);
        names += (c > 0 ? "," : "") + csv_field(columns[c].first);
        n_rows = std::max(n_rows, columns[c].second->size());
      }
    text += names + "\n";
    for (std::size_t row = 0; row < n_rows; ++row)
      for (std::size_t c = 0; c < columns.size(); ++c)
        {
          if (row < columns[c].second->size())
            text += fmt::format("{}", (*columns[c].second)[row]);
          text += c + 1 < columns.size() ? ',' : '\n';
        }
    return text;
  }

  std::string script_of(const std::vector<Figure> &figures)
  {
    std::string text = "# Draws the figures beside it: gnuplot figures.gp\n"
                       "reset\n"
                       "set datafile separator ','\n"
                       "set datafile columnheaders\n"
                       "set encoding utf8\n"
                       "set grid lc rgb '#d0d0d0'\n"
                       "set autoscale xfix\n"
                       "set key outside bottom center horizontal noenhanced height 1\n"
                       "set title noenhanced\n"
                       "set xlabel noenhanced\n"
                       "set ylabel noenhanced\n";
    for (const Figure &figure : figures)
      {
        const auto         n_panels = static_cast<unsigned int>(figure.panels.size());
        const unsigned int n_rows   = (n_panels + figure.n_columns - 1) / figure.n_columns;
        text += fmt::format("\nset terminal svg size {},{} font 'DejaVu Sans,14' background rgb 'white'\n",
                            figure.n_columns * panel_width, n_rows * panel_height);
        text += "set output " + quote(figure.stem + ".svg") + "\n";
        text += fmt::format("set multiplot layout {},{}\n", n_rows, figure.n_columns);
        unsigned int column = 1;
        for (const FigurePanel &panel : figure.panels)
          {
            text += panel.lines.empty() ? "set multiplot next\n" : plot_of(panel, figure.stem + ".csv", column);
            column += 2 * panel.lines.size();
          }
        text += "unset multiplot\nunset output\n";
      }
    return text;
  }
} // namespace birdstrike
