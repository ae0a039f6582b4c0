#include "report/comparison_table.h"
#include "report/curve_features.h"
#include <birdstrike/report/text.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr double absent = std::numeric_limits<double>::quiet_NaN();

    using Value = std::function<double(const RunRecord &)>;

    Value number(const std::string &key)
    {
      return [key](const RunRecord &run) { return run.number(key); };
    }

    /// Of results that only a deformable blade has: a rigid one reports zeros.
    Value of_deformable(const std::string &key)
    {
      return [key](const RunRecord &run) {
        return run.column("root_bending_moment").empty() || run.text("blade/kind") == "rigid" ? absent
                                                                                              : run.number(key);
      };
    }

    Value of_contact(const std::string &key)
    {
      return [key](const RunRecord &run) { return run.column("contact_force_x").empty() ? absent : run.number(key); };
    }

    double compute_impulse(const RunRecord &run)
    {
      return run.column("contact_force_x").empty()
               ? absent
               : std::hypot(run.number("contact/impulse/0"), run.number("contact/impulse/1"),
                            run.number("contact/impulse/2"));
    }

    /// What the blade has at the end, less what it had at the start: a spinning blade brings energy of its own.
    double compute_absorbed(const RunRecord &run)
    {
      if (run.text("blade/kind") == "none" || run.column("blade_kinetic").empty())
        return absent;
      double initial = 0.;
      for (const std::string part : {"kinetic", "elastic", "plastic", "hourglass", "viscous", "damped", "eroded"})
        if (const auto &column = run.column("blade_" + part); !column.empty())
          initial += column.front();
      return run.sum("energy/parts/blade_") - initial;
    }

    ComparisonRow make_row(const std::string &group, const std::string &quantity, const std::string &unit,
                           const std::vector<ComparedRun> &runs, const Value &value)
    {
      ComparisonRow row{group, quantity, unit, {}, {}};
      for (const ComparedRun &run : runs)
        row.values.push_back(value(run.record));
      return row;
    }

    ComparisonRow make_text_row(const std::string &group, const std::string &property,
                                const std::vector<ComparedRun>                      &runs,
                                const std::function<std::string(const RunRecord &)> &text)
    {
      ComparisonRow row{group, property, "", {}, {}};
      for (const ComparedRun &run : runs)
        row.texts.push_back(text(run.record));
      return row;
    }

    std::string describe_end(const RunRecord &run)
    {
      return run.is_complete() ? run.text("end/reason") : "lost";
    }
  } // namespace

  double ComparisonRow::difference(const std::size_t run) const
  {
    const double first = values[0];
    return first == 0. ? absent : (values[run] - first) / std::abs(first);
  }

  ComparisonTable::ComparisonTable(const std::vector<ComparedRun> &runs)
  {
    for (const ComparedRun &run : runs)
      {
        names.push_back(run.name);
        if (!run.record.is_complete())
          remarks.push_back("'" + run.name +
                            "' was lost: " + (run.record.state().empty() ? "it left no state" : run.record.state()) +
                            ". Its curves go as far as it came.");
      }
    add_row(make_text_row("Case", "blade", runs, [](const RunRecord &run) { return run.text("blade/kind"); }));
    add_row(make_row("Case", "elements", "count", runs, number("blade/elements")));
    add_row(make_row("Case", "particles", "count", runs, number("bird/particles")));
    add_row(make_text_row("Case", "ended", runs, describe_end));
    add_row(make_row("Case", "end time", "s", runs, number("end/time")));
    add_blade(runs);
    add_row(make_row("Contact", "peak force", "N", runs, of_contact("contact/peak_force")));
    add_row(make_row("Contact", "impulse (norm)", "N s", runs, compute_impulse));
    add_row(make_row("Contact", "largest penetration over spacing", "-", runs,
                     of_contact("contact/max_penetration_over_spacing")));
    add_cost(runs);
  }

  void ComparisonTable::add_blade(const std::vector<ComparedRun> &runs)
  {
    add_row(make_row("Tip", "peak (mid-chord)", "m", runs, of_deformable("tip/peak")));
    add_row(make_row("Tip", "time of the peak", "s", runs, of_deformable("tip/peak_time")));
    add_row(make_row("Tip", "deflection at the end", "m", runs, of_deformable("tip/final")));
    add_permanent_deflection(runs);
    add_row(make_row("Root", "peak force", "N", runs, of_deformable("root/peak_force")));
    add_row(make_row("Root", "peak bending moment", "N m", runs, of_deformable("root/peak_moment")));
    add_row(make_row("Root", "peak normal stress", "Pa", runs, of_deformable("root/peak_normal_stress")));
    add_row(make_row("Root", "time of the peak stress", "s", runs, of_deformable("root/peak_normal_stress_time")));
    add_row(make_row("Plasticity", "peak plastic strain", "-", runs, of_deformable("plastic/max_strain")));
    add_row(make_row("Plasticity", "plastic work", "J", runs, of_deformable("plastic/work")));
    add_row(make_row("Energy", "absorbed by the blade (end less start)", "J", runs, compute_absorbed));
  }

  void ComparisonTable::add_permanent_deflection(const std::vector<ComparedRun> &runs)
  {
    ComparisonRow row{"Tip", "permanent deflection", "m", {}, {}};
    std::string   how, without;
    for (const ComparedRun &run : runs)
      {
        const RunRecord &record = run.record;
        const auto       mean   = record.is_complete()
                                    ? compute_mean_over_last_period(record.column("time"), record.column("tip_mid_chord"))
                                    : std::nullopt;
        row.values.push_back(mean ? mean->mean : absent);
        if (mean)
          how += (how.empty() ? "" : "; ") + run.name + ": " + format_quantity(mean->period, "s") + " from " +
                 format_quantity(mean->begin, "s");
        else if (record.is_complete() && !record.column("tip_mid_chord").empty() &&
                 record.text("blade/kind") != "rigid")
          without += (without.empty() ? "'" : ", '") + run.name + "'";
      }
    add_row(row);
    if (!how.empty())
      remarks.push_back("Permanent deflection: mean over the last whole period of the tip after its peak (" + how +
                        ").");
    if (!without.empty())
      remarks.push_back("Permanent deflection: none for " + without +
                        ", no whole period after the tip's peak; a later Time/End time gives it.");
  }

  void ComparisonTable::add_cost(const std::vector<ComparedRun> &runs)
  {
    add_row(make_row("Balance", "largest energy error", "share", runs, number("energy/max_relative_error")));
    add_row(make_row("Balance", "hourglass over internal, at most", "share", runs,
                     of_deformable("energy/max_hourglass_over_internal")));
    add_row(make_row("Cost", "steps of the blade", "count", runs, number("steps/blade")));
    add_row(make_row("Cost", "steps of the bird", "count", runs, number("steps/bird")));
    add_row(make_row("Cost", "run time", "s", runs, number("cost/wall")));
    add_row(make_row("Cost", "threads", "count", runs, number("cost/threads")));
    add_row(make_row("Cost", "peak memory", "B", runs, number("cost/peak_memory")));
  }

  void ComparisonTable::add_row(ComparisonRow row)
  {
    const bool has_value = std::any_of(row.values.begin(), row.values.end(), [](double v) { return !std::isnan(v); });
    const bool has_text =
      std::any_of(row.texts.begin(), row.texts.end(), [](const std::string &text) { return !text.empty(); });
    if (has_value || has_text)
      all.push_back(std::move(row));
  }

  const std::vector<ComparisonRow> &ComparisonTable::rows() const
  {
    return all;
  }

  const std::vector<std::string> &ComparisonTable::notes() const
  {
    return remarks;
  }
} // namespace birdstrike
