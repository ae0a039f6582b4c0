#include "report/comparison/case_run.h"
#include "report/comparison/figure.h"
#include <birdstrike/report/text.h>
#include <birdstrike/report/vibration.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    constexpr double       rpm            = 60. / (2. * std::numbers::pi); // per rad/s
    constexpr unsigned int most_orders    = 12;
    constexpr double       least_likeness = 0.5; // of shapes that are one mode's

    std::string table_of(const std::vector<ModesAtSpeed> &speeds, const std::size_t n)
    {
      const auto  followed = follow_modes(speeds, n);
      std::string text     = "# 1: speed of the hub [rad/s]\n# 2: mode of the first speed that it goes on from [-]\n"
                             "# 3: natural frequency [Hz]\n# 4: over the frequency of the hub: engine order [-]\n"
                             "# 5, 6, 7: share of the blade's mass that moves along x, y, z [-]\n"
                             "speed,mode,frequency,engine_order,effective_mass_x,effective_mass_y,effective_mass_z\n";
      for (std::size_t s = 0; s < speeds.size(); ++s)
        for (std::size_t k = 0; k < followed[s].size(); ++k)
          {
            if (followed[s][k] == no_mode)
              continue;
            const auto  &mode  = speeds[s].modes.modes[followed[s][k]];
            const double turns = std::abs(speeds[s].speed) / (2. * std::numbers::pi);
            text += fmt::format("{:.10g},{},{:.10g},{},{:.6g},{:.6g},{:.6g}\n", speeds[s].speed, k + 1, mode.frequency,
                                turns > 0. ? fmt::format("{:.6g}", mode.frequency / turns) : "", mode.effective_mass[0],
                                mode.effective_mass[1], mode.effective_mass[2]);
          }
      return text;
    }

    Figure make_campbell(const std::vector<ModesAtSpeed> &speeds, const std::size_t n)
    {
      FigurePanel panel{"Campbell diagram", {"speed of the hub", "rad/s", "rpm", rpm}, {"frequency", "Hz", "Hz"}, {}};
      const auto  followed = follow_modes(speeds, n);
      double      fastest = 0., highest = 0.;
      for (std::size_t k = 0; k < followed[0].size(); ++k)
        {
          FigureLine line{fmt::format("mode {}", k + 1), {}, {}, static_cast<unsigned int>(k), true};
          for (std::size_t s = 0; s < speeds.size() && followed[s][k] != no_mode; ++s)
            {
              line.x.push_back(speeds[s].speed);
              line.y.push_back(speeds[s].modes.modes[followed[s][k]].frequency);
              fastest = std::max(fastest, std::abs(line.x.back()));
              highest = std::max(highest, line.y.back());
            }
          panel.lines.push_back(std::move(line));
        }
      for (unsigned int order = 1; order <= most_orders && fastest > 0.; ++order)
        if (const double end = order * fastest / (2. * std::numbers::pi); end < 1.2 * highest)
          panel.lines.push_back({fmt::format("{} per turn", order), {0., fastest}, {0., end}, 14 + order});
      return {"campbell", 1, {panel}};
    }
  } // namespace

  std::vector<std::vector<std::size_t>> follow_modes(const std::vector<ModesAtSpeed> &speeds, const std::size_t n)
  {
    std::vector<std::vector<std::size_t>> followed;
    for (std::size_t s = 0; s < speeds.size(); ++s)
      {
        const auto              &now = speeds[s].modes.modes;
        std::vector<std::size_t> of_speed(s > 0 ? followed[0].size() : std::min(n, now.size()), no_mode);
        if (s == 0)
          std::iota(of_speed.begin(), of_speed.end(), std::size_t(0));
        std::vector<std::tuple<double, std::size_t, std::size_t>> pairs; // likeness, curve, mode
        for (std::size_t k = 0; k < of_speed.size() && s > 0; ++k)
          if (const std::size_t before = followed[s - 1][k]; before != no_mode)
            for (std::size_t other = 0; other < now.size(); ++other)
              pairs.emplace_back(modal_assurance(speeds[s - 1].modes.modes[before].shape, now[other].shape), k, other);
        std::ranges::stable_sort(pairs, std::greater{}, [](const auto &pair) { return std::get<0>(pair); });
        std::vector<bool> is_taken(now.size(), false);
        for (const auto &[likeness, k, other] : pairs)
          if (likeness >= least_likeness && of_speed[k] == no_mode && !is_taken[other])
            {
              of_speed[k]     = other;
              is_taken[other] = true;
            }
        followed.push_back(std::move(of_speed));
      }
    return followed;
  }

  std::size_t n_spare_modes(const std::size_t n, const std::size_t n_speeds)
  {
    return n_speeds > 1 ? std::max<std::size_t>(3, n / 2) : 0;
  }

  std::string describe_modes(const ModesAtSpeed &at, const std::size_t n)
  {
    std::string text = fmt::format("Modes at {:.6g} rad/s ({:.5g} rpm), {} unknowns\n", at.speed, rpm * at.speed,
                                   format_count(at.modes.n_unknowns));
    text += "  mode   frequency [Hz]   engine order   mass that moves along x, y, z\n";
    const double turns = std::abs(at.speed) / (2. * std::numbers::pi);
    for (std::size_t k = 0; k < std::min(n, at.modes.modes.size()); ++k)
      {
        const auto &mode = at.modes.modes[k];
        text += fmt::format("  {:4d}   {:14.6g}   {:>12}   {:.3f} {:.3f} {:.3f}\n", k + 1, mode.frequency,
                            turns > 0. ? fmt::format("{:.4g}", mode.frequency / turns) : "-", mode.effective_mass[0],
                            mode.effective_mass[1], mode.effective_mass[2]);
      }
    return text;
  }

  std::vector<std::string> write_modes(const ReportFolder &folder, const std::vector<ModesAtSpeed> &speeds,
                                       const std::size_t n)
  {
    std::vector<std::string> said;
    folder.write_text("modes.csv", table_of(speeds, n));
    if (speeds.size() < 2)
      return said;
    const auto followed = follow_modes(speeds, n);
    for (std::size_t k = 0; k < followed[0].size(); ++k)
      for (std::size_t s = 1; s < speeds.size(); ++s)
        if (followed[s][k] == no_mode)
          {
            said.push_back(fmt::format(
              "Mode {} ends before {:.6g} rad/s: none of the {} modes there is like it, or is not another's. Ask for "
              "more modes, or for speeds that are closer.",
              k + 1, speeds[s].speed, speeds[s].modes.modes.size()));
            break;
          }
    const Figure figure = make_campbell(speeds, n);
    folder.write_text("figures.gp", script_of({figure}));
    folder.write_text(figure.stem + ".csv", data_of(figure));
    draw_figures(folder);
    return said;
  }
} // namespace birdstrike
