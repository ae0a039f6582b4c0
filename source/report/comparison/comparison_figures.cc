#include "report/comparison/comparison_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace birdstrike
{
  namespace
  {
    const FigureAxis time_axis{"time since first touch", "s", "ms", 1e3};

    /// sqrt(x^2 + y^2 + z^2) of three columns "<name>_x", ...; empty if one of them is absent.
    std::vector<double> norm_of(const RunRecord &run, const std::string &name)
    {
      const auto         &x = run.column(name + "_x"), &y = run.column(name + "_y"), &z = run.column(name + "_z");
      std::vector<double> norm;
      if (y.size() != x.size() || z.size() != x.size())
        return norm;
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
          if (!values.empty() && run.column("time").size() == values.size())
            panel.lines.push_back({runs[k].name, run.column("time"), std::move(values), static_cast<unsigned int>(k)});
        }
      const auto is_zero = [](const FigureLine &line) {
        return std::all_of(line.y.begin(), line.y.end(), [](const double y) { return y == 0.; });
      };
      if (std::all_of(panel.lines.begin(), panel.lines.end(), is_zero))
        panel.lines.clear(); // what no run has, as the tip of a rigid target
      return panel;
    }

    /// All that the bird holds: kinetic energy, compression, heat, and what removed particles took along.
    FigurePanel make_bird_energy(const std::vector<ComparedRun> &runs, const FigureAxis &axis)
    {
      FigurePanel panel =
        over_time(runs, "Bird: all its energy, with heat and removed particles", axis, "bird_kinetic");
      for (FigureLine &line : panel.lines)
        for (const char *more : {"bird_elastic", "bird_dissipated", "bird_retired"})
          if (const auto &values = runs[line.style].record.column(more); !values.empty())
            std::ranges::transform(line.y, values, line.y.begin(), std::plus<>());
      return panel;
    }

    /// Contact lasts a tenth of a run: its pictures end a little after all impulses have come within this of their last
    /// value.
    constexpr double little = 0.002;

    double find_end_of_contact(const std::vector<ComparedRun> &runs)
    {
      double end = 0.;
      for (const ComparedRun &run : runs)
        {
          const std::vector<double> impulse = norm_of(run.record, "contact_impulse"), &time = run.record.column("time");
          for (std::size_t k = 0; k < std::min(impulse.size(), time.size()); ++k)
            if (std::abs(impulse[k] - impulse.back()) > little * impulse.back())
              end = std::max(end, 1.1 * time[k]);
        }
      return end;
    }

    /// The norm of the filtered force, [time][3] in results.h5.
    FigurePanel make_filtered_force(const std::vector<ComparedRun> &runs)
    {
      FigurePanel panel{"Contact force, as a load cell's channel shows it",
                        time_axis,
                        {"force on the blade, filtered (norm)", "N", "kN", 1e-3},
                        {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          const std::vector<double> time   = runs[k].record.dataset("filtered/time"),
                                    values = runs[k].record.dataset("filtered/values");
          if (time.empty() || values.size() != 3 * time.size())
            continue;
          std::vector<double> norm;
          for (std::size_t t = 0; t < time.size(); ++t)
            norm.push_back(std::hypot(values[3 * t], values[3 * t + 1], values[3 * t + 2]));
          // the filter looks ahead: its rise begins before first touch
          const double peak  = *std::ranges::max_element(norm);
          const auto   first = std::ranges::find_if(norm, [&](const double force) { return force > 0.01 * peak; });
          if (first != norm.end())
            panel.x_begin = std::min(panel.x_begin, time[static_cast<std::size_t>(first - norm.begin())]);
          const std::string of_class = runs[k].record.summary().text("contact/filtered/class");
          panel.lines.push_back({runs[k].name + (of_class.empty() ? "" : ", " + of_class), time, std::move(norm),
                                 static_cast<unsigned int>(k)});
        }
      return panel;
    }

    Figure make_contact(const std::vector<ComparedRun> &runs)
    {
      Figure figure{
        "contact",
        2,
        {make_filtered_force(runs),
         over_time(runs, "Contact force, raw",
                   {"force on the blade (largest norm since the last row)", "N", "kN", 1e-3}, "contact_force_peak"),
         over_time(runs, "Contact impulse", {"impulse on the blade (norm)", "N s", "N s", 1.}, "contact_impulse",
                   true)}};
      std::erase_if(figure.panels, [](const FigurePanel &panel) { return panel.lines.empty(); });
      for (FigurePanel &panel : figure.panels)
        panel.x_end = find_end_of_contact(runs);
      return figure;
    }

    Figure make_energies(const std::vector<ComparedRun> &runs)
    {
      const FigureAxis energy{"energy", "J", "J", 1.};
      Figure           figure{"energies", 2, {}};
      figure.panels = {make_bird_energy(runs, energy),
                       over_time(runs, "Blade: kinetic energy", energy, "blade_kinetic"),
                       over_time(runs, "Blade: elastic energy", energy, "blade_elastic"),
                       over_time(runs, "Blade: plastic work", energy, "blade_plastic")};
      std::erase_if(figure.panels, [](const FigurePanel &panel) { return panel.lines.empty(); });
      return figure;
    }

    /// The yield stresses of all runs' metals, each once; also below zero where stresses have signs.
    std::vector<FigureLevel> find_yield(const std::vector<ComparedRun> &runs, const bool is_signed)
    {
      std::map<double, std::string> metals;
      for (const ComparedRun &run : runs)
        for (std::size_t k = 0;; ++k)
          {
            const std::string metal  = "blade/materials/" + std::to_string(k);
            const std::string name   = run.record.summary().text(metal + "/name");
            const double      stress = run.record.summary().number(metal + "/yield_stress");
            if (name.empty())
              break;
            if (!std::isnan(stress))
              metals.emplace(stress, name);
          }
      std::vector<FigureLevel> levels;
      for (const auto &[stress, name] : metals)
        {
          levels.push_back({"yield stress of " + name, stress});
          if (is_signed)
            levels.push_back({"", -stress});
        }
      return levels;
    }

    FigurePanel make_root_stress(const std::vector<ComparedRun> &runs)
    {
      FigurePanel panel =
        over_time(runs, "Root section", {"largest normal stress", "Pa", "MPa", 1e-6}, "root_peak_normal_stress");
      panel.levels = find_yield(runs, false);
      return panel;
    }

    /// results.h5 holds [face][chord station], the struck face first.
    FigurePanel make_root_profile(const std::vector<ComparedRun> &runs, const std::string &face, const bool is_rear)
    {
      FigurePanel panel{"Root section when its stress peaks: " + face + " face",
                        {"place along the chord, from its middle", "m", "mm", 1e3},
                        {"normal stress", "Pa", "MPa", 1e-6},
                        {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        {
          const std::vector<double> chord  = runs[k].record.dataset("root_normal_stress_at_peak/chord"),
                                    values = runs[k].record.dataset("root_normal_stress_at_peak/values");
          if (values.size() != 2 * chord.size() || chord.empty())
            continue;
          const auto first = values.begin() + static_cast<std::ptrdiff_t>(is_rear ? chord.size() : 0);
          panel.lines.push_back({runs[k].name,
                                 chord,
                                 {first, first + static_cast<std::ptrdiff_t>(chord.size())},
                                 static_cast<unsigned int>(k)});
        }
      panel.levels = find_yield(runs, true);
      return panel;
    }

    FigurePanel make_mid_chord_profile(const std::vector<ComparedRun> &runs)
    {
      FigurePanel panel{"Mid-chord line at the tip's peak",
                        {"place along the span, from the root", "m", "mm", 1e3},
                        {"deflection", "m", "mm", 1e3},
                        {}};
      for (std::size_t k = 0; k < runs.size(); ++k)
        for (const bool is_at_peak : {true, false})
          {
            const std::string name   = std::string("mid_chord_deflection_at_") + (is_at_peak ? "peak" : "end");
            const auto        span   = runs[k].record.dataset(name + "/span");
            const auto        values = runs[k].record.dataset(name + "/values");
            if (values.empty() || values.size() != span.size())
              continue;
            panel.lines.push_back(
              {runs[k].name + (is_at_peak ? "" : " (at its end)"), span, values, static_cast<unsigned int>(k)});
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
      {"root_stress", 1, {make_root_stress(runs)}},
      make_contact(runs),
      make_energies(runs),
      {"profiles",
       2,
       {make_root_profile(runs, "struck", false), make_root_profile(runs, "rear", true),
        make_mid_chord_profile(runs)}}};
    std::erase_if(figures, [](const Figure &figure) { return !figure.has_lines(); });
    return figures;
  }
} // namespace birdstrike
