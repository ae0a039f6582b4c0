#include "report/study/convergence_table.h"
#include "report/study/study_figures.h"
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr auto nothing = "-";

    ConvergingRow make_row(const ComparisonRow &row, const std::vector<double> &sizes)
    {
      const std::vector<double> values(row.values.rbegin(), row.values.rend());
      return {&row, values, estimate_convergence(sizes, values)};
    }

    std::string show_share(const double share)
    {
      return std::isnan(share) ? nothing : format_share(share);
    }

    std::string show(const double value, const std::string &unit)
    {
      return std::isnan(value) ? nothing : format_value(value, unit);
    }

    std::string csv_number(const double value)
    {
      return std::isfinite(value) ? fmt::format("{}", value) : "";
    }

    std::string describe_bars(const std::size_t n_levels)
    {
      if (n_levels == 3)
        return "Error bar: of the finest level, 1.25 times what Richardson's value is away where the ladder converges "
               "(grid\nconvergence index), else three times that; without an order three times the largest change.\n";
      return fmt::format(
        "Order, h -> 0 and error bar by least squares over {} levels (Eca, Hoekstra 2014). Error bar: of the finest "
        "level,\n1.25 times what h -> 0 is away where the ladder converges, else three times that, and "
        "the scatter about the fit.\n",
        n_levels);
    }

    /// The finest value with its bar, and the way from there to Richardson's value.
    void add_bar(FigurePanel &panel, const double size, const double value, const GridConvergence &estimate)
    {
      if (std::isfinite(estimate.bar))
        panel.lines.push_back({"error bar", {size}, {value}, 1, true, {estimate.bar}});
      if (std::isfinite(estimate.extrapolated))
        panel.lines.push_back({"Richardson", {0., size}, {estimate.extrapolated, value}, 2, true});
    }
  } // namespace

  ConvergenceTable::ConvergenceTable(const Refinement refinement, const std::vector<LadderLevel> &levels,
                                     const StudyTable &table)
    : refinement(refinement)
  {
    for (auto level = levels.rbegin(); level != levels.rend(); ++level)
      sizes.push_back(level->size);
    for (const ComparisonRow &row : table.rows())
      if (is_response(row))
        all.push_back(make_row(row, sizes));
    for (const ComparisonRow *row : table.headline())
      headline.push_back(make_row(*row, sizes));
  }

  bool ConvergingRow::is_rising() const
  {
    return std::ranges::find(row->rises, true) != row->rises.end();
  }

  const std::vector<ConvergingRow> &ConvergenceTable::rows() const
  {
    return all;
  }

  std::string ConvergenceTable::as_text() const
  {
    std::vector<std::vector<std::string>> cells{{""}};
    for (auto size = sizes.rbegin(); size != sizes.rend(); ++size)
      cells[0].push_back(format_value(*size, size_unit(refinement)));
    for (const char *heading : {"order", "h -> 0", "last change", "error bar", ""})
      cells[0].emplace_back(heading);
    for (const ConvergingRow &each : headline)
      {
        const GridConvergence   &made = each.estimate;
        std::vector<std::string> line{each.row->group + ": " + each.row->quantity};
        for (auto value = each.values.rbegin(); value != each.values.rend(); ++value)
          line.push_back(show(*value, each.row->unit));
        line.push_back(std::isnan(made.order) ? nothing : fmt::format("{:.2f}", made.order));
        line.push_back(show(made.extrapolated, each.row->unit));
        line.push_back(show_share(made.change));
        line.push_back(std::isnan(made.gci) ? "none" : "+- " + format_share(made.gci));
        line.push_back(describe(made.trend) +
                       (made.n_fitted < sizes.size() && made.n_fitted > 0 ? "; of " + made.method() : "") +
                       (each.is_rising() ? "; still rising at the end, no peak, or still pushed by the bird" : ""));
        cells.push_back(std::move(line));
      }
    return size_name(refinement) + ":\n" + align(cells) + describe_bars(sizes.size());
  }

  std::string ConvergenceTable::as_csv() const
  {
    std::string text = "quantity,unit";
    for (auto size = sizes.rbegin(); size != sizes.rend(); ++size)
      text += fmt::format(",at h = {} {}", *size, size_unit(refinement));
    text += ",observed order [-],extrapolated,change [-],extrapolated error [-],GCI [-],error bar,GCI ratio [-],method,"
            "standard deviation,still rising,ladder\n";
    for (const ConvergingRow &each : all)
      {
        const GridConvergence &made = each.estimate;
        text += csv_field(each.row->group + ": " + each.row->quantity) + "," + csv_field(each.row->unit);
        for (auto value = each.values.rbegin(); value != each.values.rend(); ++value)
          text += "," + csv_number(*value);
        for (const double number :
             {made.order, made.extrapolated, made.change, made.extrapolated_error, made.gci, made.bar, made.ratio})
          text += "," + csv_number(number);
        text += "," + made.method() + "," + csv_number(made.deviation);
        text += std::string(each.is_rising() ? ",yes" : ",no") + "," + describe(made.trend) + "\n";
      }
    return text;
  }

  Figure ConvergenceTable::make_figure() const
  {
    Figure figure{"refinement", 2, {}};
    for (const ConvergingRow &each : headline)
      {
        FigurePanel panel{each.row->group + ": " + each.row->quantity + ", " + describe(each.estimate.trend),
                          make_axis(size_name(refinement), size_unit(refinement)),
                          make_axis(each.row->quantity, each.row->unit),
                          {{"levels", sizes, each.values, 0, true}}};
        panel.x_end = 1.05 * sizes.back();
        add_bar(panel, sizes.front(), each.values.front(), each.estimate);
        figure.panels.push_back(std::move(panel));
      }
    return figure;
  }
} // namespace birdstrike
