#include <birdstrike/report/measurement.h>

#include "report/comparison/case_run.h"
#include "report/comparison/figure.h"
#include "report/measurement/curve_metrics.h"
#include "report/measurement/measured_curve.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/report_folder.h>
#include <birdstrike/io/units.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t n_samples = 1001, fewest_rows = 10;
    constexpr double      opposed = 0.9; ///< phase by Sprague and Geers: 1 is the same curve with the other sign

    const ReportKind &measurement_kind()
    {
      static const ReportKind kind{"measurement", {"measurement", "ratings"}, {"figures.gp"}};
      return kind;
    }

    struct Peak
    {
      double value = 0., at = 0.; ///< the largest in either direction, with its sign
    };

    struct Rated
    {
      std::string  run, column, quantity, unit;
      std::string  asked      = {}; ///< the quantity as it was typed
      bool         is_profile = false;
      double       begin = 0., end = 0.;
      Peak         measured, computed;
      SpragueGeers figures;
      IsoRating    rating;
    };

    /// Peaks a thousand or a million times apart, within a factor of 3, are those of mm for m, or Pa for MPa.
    void warn_of_units(const TableColumn &column, const Rated &r)
    {
      const double ratio = std::abs(r.measured.value / r.computed.value), decades = std::log10(ratio),
                   nearest   = 3. * std::round(decades / 3.);
      const std::string unit = parse_unit(r.unit) ? r.unit : "m/m";
      if (!column.unit.empty() || nearest == 0. || std::abs(nearest) > 6. || !(std::abs(decades - nearest) < 0.5))
        return;
      const std::string prefix = nearest == 3. ? "m" : nearest == 6. ? "u" : nearest == -3. ? "k" : "M";
      log().warn("Column '{0}' has no unit: in {1}, its peak is {2:.3g} times the computed one. Is it in {3}? Write "
                 "'{0} [{3}]'.",
                 column.name, unit, ratio, prefix + unit);
    }

    /// "force: contact_force" -> both sides; a column's name may hold colons.
    std::pair<std::string, std::string> split_pair(const std::string &text)
    {
      const auto colon = text.rfind(':');
      const auto trim  = [](std::string part) {
        part.erase(0, part.find_first_not_of(' '));
        return part.substr(0, part.find_last_not_of(' ') + 1);
      };
      if (colon == std::string::npos || trim(text.substr(0, colon)).empty() || trim(text.substr(colon + 1)).empty())
        throw InputError("'" + text +
                         "' after --measured is no pair \"column: quantity\".\nExample: --measured test.csv " +
                         "\"load cell: force\" \"tip sensor: tip\"");
      return {trim(text.substr(0, colon)), trim(text.substr(colon + 1))};
    }

    double value_at(const Curve &curve, const double x)
    {
      const auto after = std::ranges::upper_bound(curve.x, x);
      const auto k = std::clamp<std::size_t>(static_cast<std::size_t>(after - curve.x.begin()), 1, curve.x.size() - 1);
      return curve.y[k - 1] + (curve.y[k] - curve.y[k - 1]) * (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
    }

    std::vector<double> sample(const Curve &curve, const double begin, const double end)
    {
      std::vector<double> samples(n_samples);
      for (std::size_t k = 0; k < n_samples; ++k)
        samples[k] = value_at(curve, begin + (end - begin) * double(k) / double(n_samples - 1));
      return samples;
    }

    std::size_t count_rows(const Curve &curve, const double begin, const double end)
    {
      return static_cast<std::size_t>(
        std::ranges::count_if(curve.x, [&](const double x) { return x >= begin && x <= end; }));
    }

    Peak find_peak(const Curve &curve, const double begin, const double end)
    {
      Peak       peak;
      const auto look = [&](const double value, const double x) {
        if (std::abs(value) > std::abs(peak.value))
          peak = {value, x};
      };
      look(value_at(curve, begin), begin);
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        if (curve.x[k] >= begin && curve.x[k] <= end)
          look(curve.y[k], curve.x[k]);
      look(value_at(curve, end), end);
      return peak;
    }

    Rated rate(const std::string &run, const std::string &column, const std::string &asked, const RunCurve &of_run,
               const Curve &measured)
    {
      const Curve  computed{of_run.x, of_run.y};
      const double begin     = std::max(measured.x.front(), computed.x.front()),
                   end       = std::min(measured.x.back(), computed.x.back());
      const std::string axis = of_run.is_profile ? "m" : "s";
      if (begin >= end || count_rows(measured, begin, end) < fewest_rows)
        throw InputError(fmt::format(
          "'{}' was measured from {} to {}, {} of {} is from {} to {}: fewer than {} rows lie in both.{}", column,
          format_quantity(measured.x.front(), axis), format_quantity(measured.x.back(), axis), of_run.quantity, run,
          format_quantity(computed.x.front(), axis), format_quantity(computed.x.back(), axis), fewest_rows,
          of_run.is_profile ? ""
                            : "\n--time-offset moves the measurement; a unit in its header ('time [ms]') scales it."));
      if (const std::size_t n = count_rows(computed, begin, end); !of_run.is_profile && n < fewest_rows)
        throw InputError(fmt::format("{} of {} has fewer than {} rows ({}) from {} to {}, where it was measured.\n"
                                     "Run it with a shorter Output/History interval, or further.",
                                     of_run.quantity, run, fewest_rows, n, format_quantity(begin, axis),
                                     format_quantity(end, axis)));
      const auto m = sample(measured, begin, end), c = sample(computed, begin, end);
      if (std::ranges::all_of(m, [](const double y) { return y == 0.; }))
        throw InputError("'" + column + "' is zero wherever the run has values: nothing can be compared with it.");
      return {run,
              column,
              of_run.quantity,
              of_run.unit,
              asked,
              of_run.is_profile,
              begin,
              end,
              find_peak(measured, begin, end),
              find_peak(computed, begin, end),
              compute_sprague_geers(m, c),
              compute_iso_rating(m, c)};
    }

    FigureAxis axis_of(const std::string &quantity, const std::string &unit)
    {
      static const std::map<std::string, std::pair<std::string, double>> shown{
        {"Pa", {"MPa", 1e-6}}, {"m", {"mm", 1e3}}, {"N", {"kN", 1e-3}}, {"s", {"ms", 1e3}}};
      const auto found = shown.find(unit);
      return found == shown.end() ? FigureAxis{quantity, unit, unit, 1.}
                                  : FigureAxis{quantity, unit, found->second.first, found->second.second};
    }

    FigurePanel make_panel(const std::string &column, const RunCurve &of_run, const Curve &measured)
    {
      constexpr unsigned int black = 6;
      FigurePanel            panel{of_run.quantity + ", measured as " + column,
                        of_run.is_profile ? FigureAxis{"place", "m", "mm", 1e3}
                                                     : FigureAxis{"time since first touch", "s", "ms", 1e3},
                        axis_of(of_run.quantity, of_run.unit),
                        {}};
      panel.lines.push_back({"measured", measured.x, measured.y, black});
      return panel;
    }

    std::string show(const Rated &r)
    {
      const std::string axis = r.is_profile ? "m" : "s";
      std::string       text = fmt::format("{}: {} against {}, {} to {}\n", r.run, r.quantity, r.column,
                                           format_quantity(r.begin, axis), format_quantity(r.end, axis));
      text += fmt::format("  peak               {} at {}, measured {} at {}: {:.3f} of it\n",
                          format_quantity(r.computed.value, r.unit), format_quantity(r.computed.at, axis),
                          format_quantity(r.measured.value, r.unit), format_quantity(r.measured.at, axis),
                          r.computed.value / r.measured.value);
      text += fmt::format("  Sprague and Geers  magnitude {:+.3f}, phase {:.3f}, comprehensive {:.3f}\n",
                          r.figures.magnitude, r.figures.phase, r.figures.comprehensive);
      if (r.figures.phase > opposed)
        text +=
          fmt::format("  The curves are opposed: one may have its sign turned. --measured ... \"{}: {}\" turns the "
                      "computed one.\n",
                      r.column, r.asked.starts_with('-') ? r.asked.substr(1) : "-" + r.asked);
      if (!r.is_profile)
        text += fmt::format(
          "  ISO/TS 18571       {:.3f}, {}: corridor {:.3f}, phase {:.3f}, magnitude {:.3f}, slope {:.3f}\n",
          r.rating.overall, r.rating.grade(), r.rating.corridor, r.rating.phase, r.rating.magnitude, r.rating.slope);
      return text;
    }

    std::string as_csv(const std::vector<Rated> &all)
    {
      std::string text =
        "run,column,quantity,unit,begin,end,measured_peak,measured_peak_at,computed_peak,computed_peak_at,"
        "peak_ratio,sprague_geers_magnitude,sprague_geers_phase,sprague_geers_comprehensive,iso_corridor,"
        "iso_phase,iso_magnitude,iso_slope,iso_overall\n";
      for (const Rated &r : all)
        {
          text += fmt::format("\"{}\",\"{}\",\"{}\",{},{},{},{},{},{},{},{},{},{},{}", r.run, r.column, r.quantity,
                              r.unit, r.begin, r.end, r.measured.value, r.measured.at, r.computed.value, r.computed.at,
                              r.computed.value / r.measured.value, r.figures.magnitude, r.figures.phase,
                              r.figures.comprehensive);
          text += r.is_profile ? ",,,,,\n" // the rating is one of signals in time
                               : fmt::format(",{},{},{},{},{}\n", r.rating.corridor, r.rating.phase, r.rating.magnitude,
                                             r.rating.slope, r.rating.overall);
        }
      return text;
    }
  } // namespace

  std::vector<std::string> shortest_names(const std::vector<std::string> &folders)
  {
    std::vector<std::filesystem::path> left;
    std::vector<std::string>           names(folders.size());
    for (const std::string &folder : folders)
      left.push_back((std::filesystem::path(folder) / "").parent_path());
    const auto is_unique = [&](const std::string &name) { return std::ranges::count(names, name) == 1; };
    while (!std::ranges::all_of(names, is_unique) || names[0].empty())
      {
        const std::vector<std::string> before = names;
        for (std::size_t k = 0; k < names.size(); ++k)
          if ((before[k].empty() || std::ranges::count(before, before[k]) > 1) && left[k].has_filename())
            {
              names[k] = before[k].empty() ? left[k].filename().string() : (left[k].filename() / before[k]).string();
              left[k]  = left[k].parent_path();
            }
        if (names == before)
          break; // the same folder twice
      }
    return names;
  }

  void compare_with_measurement(const MeasurementRequest &request)
  {
    if (request.of_file.size() < 2)
      throw InputError(
        "--measured needs a file and pairs \"column: quantity\".\nExample: birdstrike compare runs/frontal "
        "--measured test.csv \"tip sensor: tip\"");
    const DataTable    table(request.of_file.front());
    std::vector<Rated> rated;
    const auto         names = shortest_names(request.runs);
    Figure             figure{"measurement", request.of_file.size() > 2 ? 2u : 1u, {}};
    for (std::size_t k = 1; k < request.of_file.size(); ++k)
      {
        const auto [column, quantity] = split_pair(request.of_file[k]);
        for (std::size_t run = 0; run < request.runs.size(); ++run)
          {
            const std::filesystem::path folder(request.runs[run]);
            const RunCurve              of_run   = read_run_curve(folder, quantity);
            const Curve                 measured = read_measured(table, request, column, of_run);
            const std::string          &name     = names[run];
            rated.push_back(rate(name, column, quantity, of_run, measured));
            warn_of_units(table.column(column), rated.back());
            if (run == 0)
              figure.panels.push_back(make_panel(column, of_run, measured));
            figure.panels.back().lines.push_back({name, of_run.x, of_run.y, static_cast<unsigned int>(run)});
          }
      }
    const ReportFolder folder(request.output, measurement_kind());
    folder.write_text("ratings.csv", as_csv(rated));
    folder.write_text("figures.gp", script_of({figure}));
    folder.write_text(figure.stem + ".csv", data_of(figure));
    for (const Rated &one : rated)
      log().info("\n{}", show(one));
    draw_figures(folder);
    log().info("Ratings and curves in {}", folder.path().string());
  }
} // namespace birdstrike
