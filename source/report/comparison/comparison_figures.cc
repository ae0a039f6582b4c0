#include "report/comparison/comparison_figures.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    const FigureAxis time_axis{"time since first touch", "s", "ms", 1e3};

    /// sqrt(x^2 + y^2 + z^2) of three columns "<name>_x", ...; empty if the run has none.
    std::vector<double> norm_of(const RunRecord &run, const std::string &name)
    {
      const auto         &x = run.column(name + "_x"), &y = run.column(name + "_y"), &z = run.column(name + "_z");
      std::vector<double> norm;
      for (std::size_t k = 0; k < x.size(); ++k)
        norm.push_back(std::hypot(x[k], y[k], z[k]));
      return norm;
    }

    /// A column over time; `is_vector`: the norm of its three columns.
    FigurePanel over_time(const std::vector<ComparedRun> &runs, const std::string &title, const FigureAxis &axis,
                          const std::string &column, const bool is_vector = false)
    {
      FigurePanel panel{title, time_axis, axis, {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          const RunRecord &run    = runs[k].record;
          auto             values = is_vector ? norm_of(run, column) : run.column(column);
          if (!values.empty())
            panel.lines.push_back(
              {runs[k].name, run.column("time"), std::move(values), static_cast<unsigned int>(k), false});
        }
      const auto is_zero = [](const FigureLine &line) {
        return std::all_of(line.y.begin(), line.y.end(), [](const double y) { return y == 0.; });
      };
      if (std::all_of(panel.lines.begin(), panel.lines.end(), is_zero))
        panel.lines.clear(); // what no run has, as the tip of a rigid target
      return panel;
    }

    /// Contact lasts a tenth of a run: its picture ends where all forces have fallen to a hundredth of the largest.
    double find_end_of_contact(const std::vector<ComparedRun> &runs)
    {
      double end = 0.;
      for (const ComparedRun &run : runs)
        {
          const std::vector<double> &force = run.record.column("contact_force_peak"), &time = run.record.column("time");
          const double               peak = force.empty() ? 0. : *std::max_element(force.begin(), force.end());
          for (std::size_t k = 0; k < force.size(); ++k)
            if (force[k] > 0.01 * peak)
              end = std::max(end, time[k]);
        }
      return end;
    }

    Figure make_contact(const std::vector<ComparedRun> &runs)
    {
      Figure figure{
        "contact",
        2,
        {over_time(runs, "Contact", {"force on the blade (largest norm since the last row)", "N", "kN", 1e-3},
                   "contact_force_peak"),
         over_time(runs, "Contact", {"impulse on the blade (norm)", "N s", "N s", 1.}, "contact_impulse", true)}};
      for (FigurePanel &panel : figure.panels)
        panel.x_end = find_end_of_contact(runs);
      return figure;
    }

    Figure make_energies(const std::vector<ComparedRun> &runs)
    {
      const FigureAxis energy{"energy", "J", "J", 1.};
      Figure           figure{"energies", 2, {}};
      figure.panels = {
        over_time(runs, "Bird: kinetic energy of its particles, without retired ones", energy, "bird_kinetic"),
        over_time(runs, "Blade: kinetic energy", energy, "blade_kinetic"),
        over_time(runs, "Blade: elastic energy", energy, "blade_elastic"),
        over_time(runs, "Blade: plastic work", energy, "blade_plastic")};
      std::erase_if(figure.panels, [](const FigurePanel &panel) { return panel.lines.empty(); });
      return figure;
    }

    /// results.h5 holds [face][chord station], the struck face first.
    FigurePanel make_root_profile(const std::vector<ComparedRun> &runs)
    {
      FigurePanel panel{"Root section when its stress peaks (full: struck face, dashed: rear face)",
                        {"place along the chord, from its middle", "m", "mm", 1e3},
                        {"normal stress", "Pa", "MPa", 1e-6},
                        {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          const std::vector<double> chord  = runs[k].record.dataset("root_normal_stress_at_peak/chord"),
                                    values = runs[k].record.dataset("root_normal_stress_at_peak/values");
          if (values.size() != 2 * chord.size() || chord.empty())
            continue;
          const auto middle = values.begin() + static_cast<std::ptrdiff_t>(chord.size());
          const auto colour = static_cast<unsigned int>(k);
          panel.lines.push_back({runs[k].name, chord, {values.begin(), middle}, colour, false});
          panel.lines.push_back({"", chord, {middle, values.end()}, colour, true});
        }
      return panel;
    }

    FigurePanel make_mid_chord_profile(const std::vector<ComparedRun> &runs)
    {
      FigurePanel panel{"Mid-chord line at the tip's peak",
                        {"place along the span, from the root", "m", "mm", 1e3},
                        {"deflection", "m", "mm", 1e3},
                        {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        for (const std::string moment : {"peak", "end"})
          {
            const std::string name   = "mid_chord_deflection_at_" + moment;
            const auto        span   = runs[k].record.dataset(name + "/span");
            const auto        values = runs[k].record.dataset(name + "/values");
            if (values.empty() || values.size() != span.size())
              continue;
            panel.lines.push_back({runs[k].name + (moment == "peak" ? "" : " (at its end)"), span, values,
                                   static_cast<unsigned int>(k), false});
            break; // the end stands only where there is no peak
          }
      return panel;
    }
  } // namespace

  std::vector<Figure> make_comparison_figures(const std::vector<ComparedRun> &runs)
  {
    std::vector<Figure> figures{
      {"tip_deflection", 1, {over_time(runs, "Tip, mid-chord", {"deflection", "m", "mm", 1e3}, "tip_mid_chord")}},
      {"root_moment",
       1,
       {over_time(runs, "Root section", {"bending moment", "N m", "N m", 1.}, "root_bending_moment")}},
      {"root_stress",
       1,
       {over_time(runs, "Root section", {"largest normal stress", "Pa", "MPa", 1e-6}, "root_peak_normal_stress")}},
      make_contact(runs),
      make_energies(runs),
      {"profiles", 2, {make_root_profile(runs), make_mid_chord_profile(runs)}}};
    std::erase_if(figures, [](const Figure &figure) { return !figure.has_lines(); });
    return figures;
  }
} // namespace birdstrike
