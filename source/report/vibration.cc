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

    /// Frequency over that of the hub, of so many digits; `none` of a hub that stands still and of an unstable mode.
    std::string engine_order(const VibrationModes::Mode &mode, const double speed, const int digits, const char *none)
    {
      const double turns = std::abs(speed) / (2. * std::numbers::pi);
      return turns > 0. && !mode.is_unstable() ? fmt::format("{:.{}g}", mode.frequency / turns, digits) : none;
    }

    std::string table_of(const std::vector<ModesAtSpeed> &speeds, const std::size_t n)
    {
      const auto  followed = follow_modes(speeds, n);
      std::string text     = "# 1: speed of the hub [rad/s]\n# 2: mode of the first speed that it goes on from [-]\n"
                             "# 3: natural frequency [Hz]\n# 4: over the frequency of the hub: engine order [-]\n"
                             "# 5, 6, 7: share of the blade's mass that moves along x, y, z [-]\n"
                             "# 8: of an unstable mode, without a frequency, rate of its growth [1/s]\n"
                             "speed,mode,frequency,engine_order,effective_mass_x,effective_mass_y,effective_mass_z,"
                             "growth_rate\n";
      for (std::size_t s = 0; s < speeds.size(); ++s)
        for (std::size_t k = 0; k < followed[s].size(); ++k)
          {
            if (followed[s][k] == no_mode)
              continue;
            const auto &mode = speeds[s].modes.modes[followed[s][k]];
            text += fmt::format("{:.10g},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g}\n", speeds[s].speed, k + 1,
                                mode.is_unstable() ? "" : fmt::format("{:.10g}", mode.frequency),
                                engine_order(mode, speeds[s].speed, 6, ""), mode.effective_mass[0],
                                mode.effective_mass[1], mode.effective_mass[2], mode.growth_rate);
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
              const auto &mode = speeds[s].modes.modes[followed[s][k]];
              if (mode.is_unstable())
                continue;
              line.x.push_back(speeds[s].speed);
              line.y.push_back(mode.frequency);
              fastest = std::max(fastest, std::abs(line.x.back()));
              highest = std::max(highest, line.y.back());
            }
          if (!line.x.empty())
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
    for (std::size_t k = 0; k < std::min(n, at.modes.modes.size()); ++k)
      {
        const auto &mode = at.modes.modes[k];
        text += fmt::format("  {:4d}   {:>14}   {:>12}   {:.3f} {:.3f} {:.3f}{}\n", k + 1,
                            mode.is_unstable() ? "unstable" : fmt::format("{:.6g}", mode.frequency),
                            engine_order(mode, at.speed, 4, "-"), mode.effective_mass[0], mode.effective_mass[1],
                            mode.effective_mass[2],
                            mode.is_unstable() ? fmt::format("   grows tenfold in {}",
                                                             format_quantity(std::log(10.) / mode.growth_rate, "s"))
                                               : "");
      }
    return text;
  }

  std::vector<std::string> write_modes(const ReportFolder &folder, const std::vector<ModesAtSpeed> &speeds,
                                       const std::size_t n)
  {
    std::vector<std::string> said;
    folder.write_text("modes.csv", table_of(speeds, n));
    for (const ModesAtSpeed &at : speeds)
      if (const auto n_unstable = std::ranges::count_if(at.modes.modes, &VibrationModes::Mode::is_unstable);
          n_unstable > 0)
        said.push_back(fmt::format(
          "The static equilibrium at {:.6g} rad/s is unstable: {} of its modes grow{} instead of vibrating. The blade "
          "buckles before it carries these loads. Lower the loads or the speed.{}",
          at.speed, n_unstable, n_unstable == 1 ? "s" : "",
          at.speed != 0. ? " Coriolis' forces, which the modes leave out, can hold pairs of such modes." : ""));
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
