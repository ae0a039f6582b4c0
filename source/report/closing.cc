#include "report/quantities.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/closing.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// The lines of the table: keys of the summary with their units, in the words of quantities.cc where a line has
    /// none of its own.
    class Closing
    {
    public:
      Closing(const RunView &run, const Summary &summary)
        : run(run)
        , summary(summary)
        , table("Ended at t = " + format_quantity(run.time, "s") + ": " + end_reasons().name(run.end_reason))
      {
        if (run.parameters.has_symmetry_plane)
          table.add_heading("Symmetry plane y = 0: half of the scene is computed; energies, momenta, forces, masses "
                            "and counts are those of the whole.");
        if (run.blade && run.blade->is_deformable())
          add_blade();
        if (run.observed.failure.can_fail)
          add_failure();
        if (run.bird_at_start.particles > 0 && value("contact/peak_force") > 0.)
          add_contact();
        add_balance();
        add_skipped();
        add_cost();
      }

      ToldText text() const
      {
        return {table.text(), table.brief(most_lines)};
      }

    private:
      static constexpr std::size_t most_lines = 20; ///< on the screen, beside warnings

      double value(const std::string &key) const
      {
        return summary.number(key);
      }
      std::string shown(const std::string &key) const
      {
        return format_value(value(key), quantity(key).unit);
      }
      std::string shown_vector(const std::string &key) const
      {
        return fmt::format("({:.4g}, {:.4g}, {:.4g}) {}", value(key + "/0"), value(key + "/1"), value(key + "/2"),
                           quantity(key).unit);
      }
      void add(const std::string &key, const std::string &text)
      {
        table.add(quantity(key).text, text);
      }
      void add(const std::string &key)
      {
        add(key, shown(key));
      }
      void add_detail(const std::string &key, const std::string &text)
      {
        table.add_detail(quantity(key).text, text);
      }
      std::string with_time(const std::string &key) const
      {
        return shown(key) + " at " + shown(key + "_time");
      }
      /// Nothing where there is no such peak.
      void add_peak(const std::string &text, const std::string &key, const double time)
      {
        if (std::isnan(value(key)) || value(key) == 0.)
          return;
        const bool has_time = !std::isnan(value(key + "_time"));
        const auto doubt =
          time < run.time ? " (may be no peak: the bird still loads the blade)" : " (still rising at the end)";
        table.add(text, (has_time ? with_time(key) : shown(key)) + (summary.is_false(key + "_reached") ? doubt : ""));
      }

      void add_blade()
      {
        table.add_heading("Blade");
        add_peak("tip peak (mid-chord)", "tip/peak", run.observed.tip_peak.time());
        if (value("tip/peak") != 0.)
          table.add("tip at the end", shown("tip/final"));
        add_peak("root peak normal stress", "root/peak_normal_stress", run.observed.root_stress.time());
        add_peak("root peak moment", "root/peak_moment", run.observed.root_moment.time());
        add("plastic/work");
        add("plastic/max_strain",
            fmt::format("{:.4f} at {}", value("plastic/max_strain"), shown_vector("plastic/position")));
      }

      void add_failure()
      {
        table.add_heading("Failure");
        add("failed/elements",
            count("failed/elements") + " of " + count("blade/elements") + ", " + shown("failed/mass"));
        if (value("failed/collapsed") > 0)
          add("failed/collapsed", shown("failed/collapsed") + ": below the smallest step");
        if (value("failed/partly") > 0)
          add("failed/partly", count("failed/partly") + ", " + count("failed/points") + " points");
        add("failed/free_mass");
        if (value("failed/fibre_mass") + value("failed/matrix_mass") > 0.)
          {
            add("failed/fibre_mass");
            add("failed/matrix_mass");
          }
        add("failed/energy");
        if (value("failed/at_root") > 0)
          add("failed/at_root", shown("failed/at_root") + ": their stress is zero");
        if (run.observed.failure.has_lost_tip)
          table.add("tip deflection", "of nodes that fly free");
      }

      void add_contact()
      {
        table.add_heading("Contact");
        const double momentum = Point3(run.bird_at_start.momentum.data()).norm();
        const double impulse =
          std::hypot(value("contact/impulse/0"), value("contact/impulse/1"), value("contact/impulse/2"));
        add("contact/impulse",
            shown_vector("contact/impulse") +
              (momentum > 0. ? fmt::format(", {:.2f} of the bird's momentum", impulse / momentum) : ""));
        add_detail("contact/peak_force", with_time("contact/peak_force"));
        if (!std::isnan(value("contact/filtered/peak_force")))
          table.add("peak force, " + summary.text("contact/filtered/class"),
                    shown("contact/filtered/peak_force") + " at " + shown("contact/filtered/peak_time"));
        add_detail("contact/max_penetration",
                   fmt::format("{} ({:.3f} of the particle spacing)", shown("contact/max_penetration"),
                               value("contact/max_penetration_over_spacing")));
      }

      void add_balance()
      {
        const double initial = std::abs(value("energy/initial"));
        table.add_heading("Balance");
        add_detail("energy/initial", shown("energy/initial"));
        for (const auto &[part, energy] : summary.json.at("energy").at("parts").items())
          if (const double joule = energy; joule != 0.)
            table.add_detail("  " + part, format_quantity(joule, "J") + " (" +
                                            format_share(joule / std::max(1e-300, initial)) + ")");
        add("energy/max_relative_error");
        for (const auto &[origin, energy] : summary.json.at("energy").at("error_origins").items())
          if (const double joule = energy; std::abs(joule) > 1e-3 * initial)
            table.add_detail("  at the end, from " + origin,
                             format_quantity(joule, "J") + " (" + format_share(joule / initial) + ")");
        add("momentum/max_relative_error", fmt::format("{:.2e}", value("momentum/max_relative_error")));
        add_detail("angular_momentum/max_relative_error",
                   fmt::format("{:.2e}", value("angular_momentum/max_relative_error")));
        add("energy/max_hourglass_over_internal");
      }

      void add_skipped()
      {
        table.add_heading("Skipped");
        for (const SkippedWork &work : run.skipped)
          {
            const std::string much = work.unit == "s" ? format_quantity(work.count, "s")
                                                      : format_count(std::llround(work.count)) + " " + work.unit;
            table.add_detail("skipped: " + work.what,
                             much + (std::isnan(work.saved) ? "" : ", saved about " + format_share(work.saved)));
          }
        table.add_detail("removed particles", shown("retired/particles") + " of " + shown("bird/particles"));
      }

      void add_cost()
      {
        table.add_heading("Cost");
        table.add_detail("time steps", format_count(run.n_steps) + " (with subcycles: bird " + shown("steps/bird") +
                                         ", blade " + shown("steps/blade") + ")");
        for (const StepLimiters::Limiter &limiter : run.limiters)
          {
            const EntityPlace where{limiter.kind.empty() ? nullptr : limiter.kind.c_str(), limiter.id,
                                    limiter.position};
            table.add_detail("limited by " + limiter.reason,
                             fmt::format("{} ({}), shortest {} at {}{}", format_count(limiter.n_steps),
                                         format_share(double(limiter.n_steps) / double(run.n_steps)),
                                         format_quantity(limiter.step, "s"), format_quantity(limiter.time, "s"),
                                         where.kind ? ", " + where.text() : ""));
          }
        table.add_detail("per particle-step", fmt::format("{:.0f} ns", value("cost/ns_per_particle_step")));
        table.add_detail("per element-step", fmt::format("{:.0f} ns", value("cost/ns_per_element_step")));
        add_detail("cost/peak_memory", shown("cost/peak_memory"));
      }

      std::string count(const std::string &key) const
      {
        return format_value(value(key), "count");
      }

      const RunView &run;
      const Summary &summary;
      TextTable      table;
    };
  } // namespace

  ToldText closing_report(const RunView &run, const Summary &summary)
  {
    return Closing(run, summary).text();
  }
} // namespace birdstrike
