#include "report/study/study_figures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

namespace birdstrike
{
  namespace
  {
    std::string title_of(const ComparisonRow &row)
    {
      return row.group + ": " + row.quantity;
    }

    /// Values as a picture writes them: numbers with four digits, more where two would look alike.
    std::vector<std::string> texts_of(const VariedEntry &entry)
    {
      for (int n_digits = 4; n_digits < 12 && !entry.numbers.empty(); ++n_digits)
        {
          std::vector<std::string> texts;
          for (const double number : entry.numbers)
            texts.push_back(fmt::format("{:.{}g}", number, n_digits));
          if (std::set<std::string>(texts.begin(), texts.end()).size() == texts.size())
            return texts;
        }
      return entry.values;
    }

    std::string text_of(const VariedEntry &entry, const std::size_t value)
    {
      return texts_of(entry)[value] + (entry.unit == "-" ? "" : " " + entry.unit);
    }

    /// Texts stand side by side, as cells of a map do.
    FigureAxis axis_of(const StudyPlan &plan, const std::size_t e, const bool is_of_cells)
    {
      const VariedEntry &entry = plan.entries[e];
      FigureAxis         axis  = make_axis(plan.short_name(e), entry.unit);
      if (is_of_cells || entry.numbers.empty())
        axis = {plan.short_name(e), entry.unit, entry.unit, 1., texts_of(entry)};
      return axis;
    }

    double place_of(const VariedEntry &entry, const std::size_t value, const bool is_of_cells)
    {
      return is_of_cells || entry.numbers.empty() ? static_cast<double>(value + 1) : entry.numbers[value];
    }

    /// Over the first entry; pairs too, whose further entries go along.
    FigurePanel make_curves(const StudyPlan &plan, const std::vector<PointRun> &runs, const ComparisonRow &row)
    {
      FigurePanel       panel{title_of(row), axis_of(plan, 0, false), make_axis(row.quantity, row.unit), {}};
      const bool        is_family = plan.entries.size() == 2 && !plan.are_pairs;
      const std::size_t n_lines   = is_family ? plan.entries[1].values.size() : 1;
      for (std::size_t k = 0; k < n_lines; ++k)
        panel.lines.push_back({is_family ? plan.short_name(1) + " " + text_of(plan.entries[1], k) : "",
                               {},
                               {},
                               static_cast<unsigned int>(k),
                               true});
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          const auto &at   = runs[k].point.at;
          FigureLine &line = panel.lines[is_family ? at[1] : 0];
          line.x.push_back(place_of(plan.entries[0], at[0], false));
          line.y.push_back(row.values[k]);
          if (row.is_any_rising())
            line.is_rising.push_back(row.is_rising(k) ? 1. : 0.);
        }
      return panel;
    }

    FigurePanel make_map(const StudyPlan &plan, const std::vector<PointRun> &runs, const ComparisonRow &row)
    {
      FigurePanel panel{title_of(row), axis_of(plan, 0, true), axis_of(plan, 1, true), {{}}};
      panel.colour     = make_axis(row.quantity, row.unit);
      FigureLine &line = panel.lines[0];
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          line.x.push_back(place_of(plan.entries[0], runs[k].point.at[0], true));
          line.y.push_back(place_of(plan.entries[1], runs[k].point.at[1], true));
          if (row.is_any_rising())
            line.is_rising.push_back(row.is_rising(k) ? 1. : 0.);
        }
      line.colour = row.values;
      return panel;
    }
  } // namespace

  FigureAxis make_axis(const std::string &quantity, const std::string &unit)
  {
    struct Shown
    {
      const char *unit, *shown;
      double      factor;
    };
    static constexpr std::array<Shown, 4> shown{
      {{"m", "mm", 1e3}, {"Pa", "MPa", 1e-6}, {"N", "kN", 1e-3}, {"s", "ms", 1e3}}};
    for (const Shown &each : shown)
      if (unit.compare(each.unit) == 0)
        return {quantity, unit, each.shown, each.factor};
    return {quantity, unit, unit, 1.};
  }

  std::vector<Figure> make_study_figures(const StudyPlan &plan, const std::vector<PointRun> &runs,
                                         const StudyTable &table)
  {
    Figure curves{"responses", 2, {}}, maps{"maps", 2, {}};
    if (plan.shape().size() > 2)
      return {};
    for (const ComparisonRow *row : table.headline())
      {
        curves.panels.push_back(make_curves(plan, runs, *row));
        if (plan.shape().size() == 2)
          maps.panels.push_back(make_map(plan, runs, *row));
      }
    std::vector<Figure> figures;
    for (Figure *figure : {&curves, &maps})
      if (figure->has_lines())
        figures.push_back(std::move(*figure));
    return figures;
  }
} // namespace birdstrike
