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

    /// As a label at a tick, which gnuplot reads as a format.
    std::string quote_tick(const std::string &text)
    {
      std::string doubled;
      for (const char letter : text)
        doubled += letter == '%' ? std::string("%%") : std::string(1, letter);
      return quote(doubled);
    }

    std::string label(const FigureAxis &axis)
    {
      return axis.quantity + " [" + axis.shown_unit + "]";
    }

    using DataColumn = std::pair<std::string, const std::vector<double> *>; ///< name and values

    std::vector<DataColumn> columns_of(const FigurePanel &panel, const FigureLine &line)
    {
      std::vector<DataColumn> columns;
      const auto              add = [&](const std::string &quantity, const FigureAxis &axis, const auto &values) {
        columns.emplace_back(line.title + (line.title.empty() ? "" : ": ") + quantity + " [" + axis.unit + "]",
                                          &values);
      };
      add(panel.x.quantity, panel.x, line.x);
      add(panel.y.quantity, panel.y, line.y);
      if (!line.bar.empty())
        add("error bar of " + panel.y.quantity, panel.y, line.bar);
      if (!line.colour.empty())
        add(panel.colour.quantity, panel.colour, line.colour);
      if (!line.is_rising.empty())
        add("still rising, no peak yet: " + (line.colour.empty() ? panel.y : panel.colour).quantity, {"", "-", "-"},
            line.is_rising);
      return columns;
    }

    /// The column of is_rising, if there is one: the last one of a line.
    std::size_t column_of_rising(const FigurePanel &panel, const FigureLine &line, const std::size_t first)
    {
      return first + columns_of(panel, line).size() - 1;
    }

    std::vector<DataColumn> columns_of(const Figure &figure)
    {
      std::vector<DataColumn> columns;
      for (const FigurePanel &panel : figure.panels)
        for (const FigureLine &line : panel.lines)
          for (DataColumn &column : columns_of(panel, line))
            columns.push_back(std::move(column));
      return columns;
    }

    /// Every n-th, where along `axis` there is room for so many letters only.
    std::string ticks_of(const char *axis, const FigureAxis &of, const std::size_t room)
    {
      std::size_t n_letters = 0;
      for (const std::string &tick : of.ticks)
        n_letters += tick.size() + 1;
      const std::size_t stride = std::max<std::size_t>(1, (n_letters + room - 1) / room);
      std::string       text;
      for (std::size_t k = 0; k < of.ticks.size(); k += stride)
        text += (k > 0 ? ", " : "") + quote_tick(of.ticks[k]) + " " + std::to_string(k + 1);
      return std::string("set ") + axis + "tics " + (text.empty() ? "autofreq" : "(" + text + ")") + "\n";
    }

    std::string range_of(const FigurePanel &panel)
    {
      if (!panel.x.ticks.empty())
        return fmt::format("[0.5:{}.5]", panel.x.ticks.size());
      return panel.x_end > 0. ? fmt::format("[{}:{}]", panel.x_begin * panel.x.factor, panel.x_end * panel.x.factor)
                              : "[*:*]";
    }

    std::string head_of(const FigurePanel &panel)
    {
      std::string text = "set title " + quote(panel.title) + "\nset xlabel " + quote(label(panel.x)) + "\nset ylabel " +
                         quote(label(panel.y)) + "\nset xrange " + range_of(panel) + "\n";
      text += "set yrange [" +
              (panel.y.ticks.empty() ? std::string("*:*") : fmt::format("0.5:{}.5", panel.y.ticks.size())) + "]\n";
      constexpr std::size_t letters_along_x = 70, letters_along_y = 1000; // up it takes lines
      return text + ticks_of("x", panel.x, letters_along_x) + ticks_of("y", panel.y, letters_along_y);
    }

    /// From dark to light, S. van der Walt's and N. Smith's viridis (matplotlib, 2015), as far as white letters can be
    /// read on it.
    constexpr auto map_colours = "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#35b779')\n";

    constexpr auto meaning_of_rising = "still rising at the end of the run, no peak yet";

    /// `column`: number of x in the file.
    std::string plot_map(const FigurePanel &panel, const FigureLine &line, const std::string &file,
                         const unsigned int column)
    {
      constexpr std::size_t most_written = 200; // beyond, numbers would overlap
      const std::string     place        = fmt::format("{} using {}:{}", quote(file), column, column + 1),
                        value            = fmt::format("(${}*{})", column + 2, panel.colour.factor);
      std::string text                   = head_of(panel) + map_colours + "set cblabel " + quote(label(panel.colour)) +
                         " noenhanced\nplot " + place + ":" + value + " with image pixels notitle";
      const bool        is_written = line.x.size() <= most_written;
      const std::string rises      = fmt::format("${}>0", column_of_rising(panel, line, column));
      if (is_written)
        text += ", \\\n     " + place +
                (line.is_rising.empty() ? ":(sprintf('%.4g'," + value + "))"
                                        : fmt::format(":(sprintf('%.4g%s',{},{} ? '+' : ''))", value, rises)) +
                " with labels font ',11' textcolor rgb 'white' notitle";
      if (!line.is_rising.empty()) // where the number has its '+', no more than the legend's words
        text += fmt::format(", \\\n     {} using ({} ? ${} : NaN):{} with points pt {} lc rgb 'white' title '+: {}'",
                            quote(file), rises, column, column + 1, is_written ? 0 : 1, meaning_of_rising);
      return text + "\n";
    }

    /// White discs with a ring, over the markers of values that still rise. The legend has them once.
    std::string plot_open_markers(const FigurePanel &panel, const std::string &file, std::size_t column)
    {
      std::string text;
      for (const FigureLine &line : panel.lines)
        {
          const std::string place =
            fmt::format("{} using (${}*{}):(${}>0 ? ${}*{} : NaN) with points", quote(file), column, panel.x.factor,
                        column_of_rising(panel, line, column), column + 1, panel.y.factor);
          if (!line.is_rising.empty())
            text +=
              fmt::format(", \\\n     {0} pt 7 ps 1.1 lc rgb 'white' notitle, \\\n     {0} pt 6 ps 1.1 lw 2 lc rgb "
                          "'{1}' {2}",
                          place, palette[line.style % palette.size()],
                          text.empty() ? "title " + quote(meaning_of_rising) : "notitle");
          column += columns_of(panel, line).size();
        }
      return text;
    }

    /// `column`: number of the first line's x in the file.
    std::string plot_of(const FigurePanel &panel, const std::string &file, unsigned int column)
    {
      const std::string open_markers = plot_open_markers(panel, file, column);
      if (!panel.lines.front().colour.empty())
        return plot_map(panel, panel.lines.front(), file, column);
      std::string text = head_of(panel) + "plot ";
      for (const FigureLine &line : panel.lines)
        {
          const std::string title  = line.title.empty() ? "notitle" : "title " + quote(line.title);
          const auto        dashes = 1 + line.style / static_cast<unsigned int>(palette.size()) % n_dashes;
          const std::string colour = palette[line.style % palette.size()];
          const std::string place =
            fmt::format("using (${}*{}):(${}*{})", column, panel.x.factor, column + 1, panel.y.factor);
          text += fmt::format("{}{} {} with {} lw 2 dt {} lc rgb '{}' {}",
                              &line == &panel.lines.front() ? "" : ", \\\n     ", quote(file), place,
                              !line.has_points        ? "lines"
                              : panel.x.ticks.empty() ? "linespoints pt 7 ps 0.7"
                                                      : "points pt 7 ps 1.2",
                              dashes, colour, title);
          if (!line.bar.empty())
            text += fmt::format(", \\\n     {} {}:(${}*{}) with yerrorbars lw 2 pt 0 lc rgb '{}' notitle", quote(file),
                                place, column + 2, panel.y.factor, colour);
          column += static_cast<unsigned int>(columns_of(panel, line).size());
        }
      for (const FigureLevel &level : panel.levels)
        text += fmt::format(", \\\n     {} with lines lw 1 dt 3 lc rgb '#404040' {}", level.y * panel.y.factor,
                            level.title.empty() ? "notitle" : "title " + quote(level.title));
      return text + open_markers + "\n";
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
                       "set ylabel noenhanced\n"
                       "set xtics noenhanced\n"
                       "set ytics noenhanced\n";
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
            for (const FigureLine &line : panel.lines)
              column += static_cast<unsigned int>(columns_of(panel, line).size());
          }
        text += "unset multiplot\nunset output\n";
      }
    return text;
  }
} // namespace birdstrike
