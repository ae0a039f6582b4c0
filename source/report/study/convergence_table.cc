#include "report/study/convergence_table.h"
#include "report/study/lattice_places.h"
#include "report/study/study_figures.h"
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace birdstrike
{
  namespace
  {
    constexpr auto nothing = "-";

    /// None without the finest value, or fewer than four in all.
    std::optional<KnownOrderFit> fit_what_is_there(const OrderRange &orders, const std::vector<double> &sizes,
                                                   const std::vector<double> &values)
    {
      std::vector<double> h, f;
      for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k]))
          {
            h.push_back(sizes[k]);
            f.push_back(values[k]);
          }
      if (!std::isfinite(values[0]) || f.size() < fewest_of_an_interval)
        return std::nullopt;
      return fit_order_range(orders, h, f);
    }

    ConvergingRow make_row(const ComparisonRow &row, const std::vector<double> &sizes, const std::size_t n_places,
                           const std::optional<OrderRange> &orders)
    {
      std::vector<double> values;
      double              variances = 0.;
      const auto          means     = mean_over_places(row.values, n_places);
      for (auto level = means.rbegin(); level != means.rend(); ++level)
        {
          values.push_back(level->mean);
          variances += level->variance;
        }
      const double  scatter = std::sqrt(variances / static_cast<double>(means.size()));
      ConvergingRow made{&row, values, scatter, estimate_convergence(sizes, values), {}};
      if (orders)
        made.of_known_order = fit_what_is_there(*orders, sizes, values);
      return made;
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

    /// Of so many levels, where all are there.
    std::string describe_bars(const std::size_t n_levels)
    {
      if (n_levels < 3)
        return "";
      if (n_levels == 3)
        return "Error bar of the finest level: 1.25 times the distance to Richardson's value where the ladder "
               "converges (grid\nconvergence index), else three times that distance; without an order, three times the "
               "largest change.\n";
      return fmt::format("Order, h -> 0 and error bar by least squares over {} levels (Eca, Hoekstra 2014). Error bar "
                         "of the finest level:\n1.25 times the distance to h -> 0 where the ladder converges, else "
                         "three times that distance, and the scatter about\nthe fit.\n",
                         n_levels);
    }

    std::string describe_places(const std::size_t n_places)
    {
      return n_places > 1
               ? fmt::format("Values: means over {} places of the bird's lattice; one run: standard deviation of a run "
                             "among its level's, of all\nlevels, in percent of the finest.\n",
                             n_places)
               : "";
    }

    std::string describe_interval(const std::optional<OrderRange> &orders)
    {
      if (!orders)
        return "";
      const std::string fitted =
        orders->low < orders->high
          ? "of the fits with these orders that are not rejected, with what their 95 % confidence intervals span"
          : "of the fit with this order, with its 95 % confidence interval, which holds scatter alone";
      return fmt::format("Order {}, h -> 0: {};\nrejected: another order fits better than scatter explains, at the 5 % "
                         "level (Box, Tidwell 1962).\n",
                         orders->text(), fitted);
    }

    /// Two: the value by the known order, and half of its interval, in percent of it unless that holds zero.
    std::vector<std::string> show_limit(const std::optional<KnownOrderFit> &fit, const std::string &unit)
    {
      if (!fit)
        return {nothing, nothing};
      return {show(fit->limit, unit),
              "+- " + (fit->half_interval < std::abs(fit->limit) ? show_share(fit->half_interval / std::abs(fit->limit))
                                                                 : show(fit->half_interval, unit))};
    }

    std::string csv_limit(const std::optional<OrderRange> &orders, const std::optional<KnownOrderFit> &fit)
    {
      return "," + (orders ? orders->text() : "") +
             (fit ? fmt::format(",{},{},", fit->limit, fit->half_interval) + csv_number(fit->p_value) : ",,,");
    }

    std::string describe_test(const std::optional<OrderRange> &orders, const std::optional<KnownOrderFit> &fit)
    {
      return fit && fit->rejects_order()
               ? fmt::format("; order {} is rejected, p = {:.2g}", orders->text(), fit->p_value)
               : "";
    }

    /// The finest value with its bar, and the way from there to Richardson's value.
    void add_bar(FigurePanel &panel, const double size, const double value, const ConvergingRow &row)
    {
      const GridConvergence &estimate = row.estimate;
      if (std::isfinite(estimate.bar))
        panel.lines.push_back({"error bar", {size}, {value}, 1, true, {estimate.bar}});
      if (std::isfinite(estimate.extrapolated))
        panel.lines.push_back({"Richardson", {0., size}, {estimate.extrapolated, value}, 2, true});
      if (const auto &fit = row.of_known_order)
        panel.lines.push_back({"by the known order, 95 %", {0.}, {fit->limit}, 3, true, {fit->half_interval}});
    }
  } // namespace

  ConvergenceTable::ConvergenceTable(const Refinement refinement, const std::vector<LadderLevel> &levels,
                                     const std::size_t n_places, const StudyTable &table,
                                     const std::optional<OrderRange> orders)
    : refinement(refinement), n_places(n_places), known_orders(orders)
  {
    for (auto level = levels.rbegin(); level != levels.rend(); ++level)
      sizes.push_back(level->size);
    for (const ComparisonRow &row : table.rows())
      if (is_response(row))
        all.push_back(make_row(row, sizes, n_places, orders));
    for (const ComparisonRow *row : table.headline())
      headline.push_back(make_row(*row, sizes, n_places, orders));
  }

  bool ConvergingRow::is_rising() const
  {
    return row->is_any_rising();
  }

  std::vector<double> ConvergingRow::rising_levels() const
  {
    std::vector<double> rising;
    const std::size_t   n_places = row->values.size() / values.size();
    for (std::size_t run = row->values.size(); run-- > 0 && is_rising();)
      {
        if (run % n_places == n_places - 1)
          rising.push_back(0.);
        if (row->is_rising(run))
          rising.back() = 1.;
      }
    return rising;
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
    if (n_places > 1)
      cells[0].emplace_back("one run");
    for (const char *heading : {"order", "h -> 0", "last change", "error bar"})
      cells[0].emplace_back(heading);
    if (known_orders)
      for (const std::string &heading : {"order " + known_orders->text() + ", h -> 0", std::string("95 %")})
        cells[0].push_back(heading);
    cells[0].emplace_back("");
    for (const ConvergingRow &each : headline)
      {
        const GridConvergence   &made = each.estimate;
        std::vector<std::string> line{each.row->group + ": " + each.row->quantity};
        for (auto value = each.values.rbegin(); value != each.values.rend(); ++value)
          line.push_back(show(*value, each.row->unit));
        if (n_places > 1)
          line.push_back("+- " + show_share(each.scatter / std::abs(each.values[0])));
        line.push_back(std::isnan(made.order) ? nothing : fmt::format("{:.2f}", made.order));
        line.push_back(show(made.extrapolated, each.row->unit));
        line.push_back(show_share(made.change));
        line.push_back(std::isnan(made.gci) ? "none" : "+- " + format_share(made.gci));
        if (known_orders)
          std::ranges::move(show_limit(each.of_known_order, each.row->unit), std::back_inserter(line));
        line.push_back(describe(made.trend) +
                       (made.n_fitted < sizes.size() && made.n_fitted > 0 ? "; of " + made.method() : "") +
                       describe_test(known_orders, each.of_known_order) +
                       (each.is_rising() ? "; still rising at the end, no peak, or still pushed by the bird" : ""));
        cells.push_back(std::move(line));
      }
    std::size_t n_fitted = 0;
    for (const ConvergingRow &each : headline)
      n_fitted = std::max(n_fitted, each.estimate.n_fitted);
    return size_name(refinement) + ":\n" + align(cells) + describe_places(n_places) + describe_bars(n_fitted) +
           describe_interval(known_orders);
  }

  std::string ConvergenceTable::as_csv() const
  {
    std::string text = "quantity,unit";
    for (auto size = sizes.rbegin(); size != sizes.rend(); ++size)
      text += fmt::format(",at h = {} {}", *size, size_unit(refinement));
    text += ",observed order [-],extrapolated,change [-],extrapolated error [-],GCI [-],error bar,GCI ratio [-],method,"
            "standard deviation,places,standard deviation of a run,known order [-],extrapolated by known order,"
            "half of its 95 % interval,p-value of known order [-],still rising,ladder\n";
    for (const ConvergingRow &each : all)
      {
        const GridConvergence &made = each.estimate;
        text += csv_field(each.row->group + ": " + each.row->quantity) + "," + csv_field(each.row->unit);
        for (auto value = each.values.rbegin(); value != each.values.rend(); ++value)
          text += "," + csv_number(*value);
        for (const double number :
             {made.order, made.extrapolated, made.change, made.extrapolated_error, made.gci, made.bar, made.ratio})
          text += "," + csv_number(number);
        text += "," + made.method() + "," + csv_number(made.deviation) + fmt::format(",{},", n_places) +
                csv_number(each.scatter) + csv_limit(known_orders, each.of_known_order);
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
                          {{"levels", sizes, each.values, 0, true, {}, {}, each.rising_levels()}}};
        panel.x_begin = -0.03 * sizes.back(); // what stands at h = 0 would lie on the frame
        panel.x_end   = 1.05 * sizes.back();
        add_bar(panel, sizes.front(), each.values.front(), each);
        figure.panels.push_back(std::move(panel));
      }
    return figure;
  }
} // namespace birdstrike
