#include "report/comparison/comparison_table.h"
#include "report/comparison/curve_features.h"
#include "report/comparison/warning_digest.h"
#include "report/quantities.h"
#include "report/run_warnings.h"
#include <birdstrike/report/text.h>
#include <birdstrike/structure/choices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace birdstrike
{
  namespace
  {
    constexpr double absent = std::numeric_limits<double>::quiet_NaN();

    bool is_rigid(const RunRecord &run)
    {
      return run.summary().text("blade/kind") == blade_kinds().name(BladeKind::rigid);
    }

    /// Whether a run has what a quantity speaks of: a rigid blade, or no contact, reports zeros.
    bool has(const RunRecord &run, const Subject subject)
    {
      return subject == Subject::blade     ? !run.column("root_bending_moment").empty() && !is_rigid(run)
             : subject == Subject::contact ? !run.column("contact_force_x").empty()
                                           : true;
    }

    bool has_warning(const RunRecord &run, const std::string &code)
    {
      return std::ranges::any_of(run.summary().warnings(), [&](const Warning &each) { return each.code == code; });
    }

    void add_name(std::string &names, const std::string &name)
    {
      names += (names.empty() ? "'" : ", '") + name + "'";
    }

    /// Less the first: what spin and steady loads did before the strike is not permanent.
    std::vector<double> change_of(std::vector<double> values)
    {
      for (const double first = values[0]; double &value : values)
        value -= first;
      return values;
    }

    double compute_impulse(const RunRecord &run)
    {
      const Summary &summary = run.summary();
      return !has(run, Subject::contact)
               ? absent
               : std::hypot(summary.number("contact/impulse/0"), summary.number("contact/impulse/1"),
                            summary.number("contact/impulse/2"));
    }

    /// What the blade has at the end, less what it had at the start: a spinning blade brings energy of its own.
    double compute_absorbed(const RunRecord &run)
    {
      if (run.summary().text("blade/kind") == blade_kinds().name(BladeKind::none) ||
          run.column("blade_kinetic").empty() || !run.is_complete())
        return absent;
      double initial = 0., final = 0.;
      for (const LedgerEntry &entry : ledger)
        if (const auto &column = run.column(std::string(entry.column));
            entry.part == &SystemState::blade && entry.rules().account == Account::held && !column.empty())
          initial += column.front();
      std::set<std::string> parts; // by name, as summary.json has them
      for (const Quantity &each : quantities())
        if (each.key.starts_with("energy/parts/blade_"))
          parts.insert(each.key);
      for (const std::string &part : parts)
        if (const double energy = run.summary().number(part); !std::isnan(energy))
          final += energy;
      return final - initial;
    }

    /// Whether nothing of the blade has flowed or failed since the start, as far as the history tells.
    bool is_elastic(const RunRecord &run)
    {
      constexpr std::array<const char *, 2> losses{{"blade_plastic", "blade_eroded"}};
      return std::ranges::all_of(losses, [&](const char *name) {
        const auto &column = run.column(name);
        return !column.empty() && column.back() == column.front();
      });
    }
  } // namespace

  double ComparisonRow::difference(const std::size_t run) const
  {
    const double first = values[0];
    return first == 0. ? absent : (values[run] - first) / std::abs(first);
  }

  bool ComparisonRow::is_rising(const std::size_t run) const
  {
    return !rises.empty() && rises[run];
  }

  bool ComparisonRow::is_any_rising() const
  {
    return std::ranges::find(rises, true) != rises.end();
  }

  ComparisonTable::ComparisonTable(const std::vector<ComparedRun> &runs)
  {
    if (runs.size() > 1)
      remarks.push_back("Differences are to '" + runs[0].name + "'.");
    for (const ComparedRun &run : runs)
      {
        names.push_back(run.name);
        if (!run.record.is_complete())
          remarks.push_back("'" + run.name +
                            "' was lost: " + (run.record.state().empty() ? "it left no state" : run.record.state()) +
                            ". Its curves go as far as it came.");
      }
    add_texts("Case", "blade/kind", runs);
    add("Case", {"blade/elements", "bird/particles"}, runs);
    add_texts("Case", "end/reason", runs, "lost");
    add("Case", {"end/time"}, runs);
    add("Tip", {"tip/peak", "tip/peak_time", "tip/final"}, runs);
    add_permanent_deflection(runs);
    add("Root", {"root/peak_force", "root/peak_moment", "root/peak_normal_stress", "root/peak_normal_stress_time"},
        runs);
    add_unreached_peaks(runs);
    say_what_root_stress_is(runs);
    add("Plasticity", {"plastic/max_strain", "plastic/work"}, runs);
    add_computed("Energy", "absorbed by the blade (end less start)", "J", runs, compute_absorbed);
    add("Contact", {"contact/peak_force", "contact/filtered/peak_force"}, runs);
    say_what_filters_are(runs);
    add_computed("Contact", "impulse (norm)", "N s", runs, compute_impulse);
    add("Contact", {"contact/max_penetration_over_spacing"}, runs);
    add("Balance", {"energy/max_relative_error", "energy/max_hourglass_over_internal"}, runs);
    add("Cost", {"steps/blade", "steps/bird", "cost/wall", "cost/threads", "cost/peak_memory"}, runs);
    add_warnings(runs);
  }

  void ComparisonTable::add(const std::string &group, const std::initializer_list<const char *> keys,
                            const std::vector<ComparedRun> &runs)
  {
    for (const char *key : keys)
      {
        const Quantity   &each = quantity(key);
        const std::string peak = each.key.substr(0, each.key.rfind("_time"));
        ComparisonRow     row{group, each.text, each.unit, {}, {}};
        for (const auto &[name, run] : runs)
          {
            const double value   = has(run, each.subject) ? run.summary().number(each.key) : absent;
            const bool   is_zero = value == 0. && (each.key.starts_with("tip/") || each.key.starts_with("root/"));
            row.values.push_back(is_zero ? absent : value); // no tip or root, or held ones
            row.rises.push_back(!std::isnan(row.values.back()) && run.summary().is_false(peak + "_reached"));
          }
        add_row(std::move(row));
      }
  }

  void ComparisonTable::add_computed(const std::string &group, const std::string &text, const std::string &unit,
                                     const std::vector<ComparedRun>                 &runs,
                                     const std::function<double(const RunRecord &)> &value)
  {
    ComparisonRow row{group, text, unit, {}, {}};
    for (const ComparedRun &run : runs)
      row.values.push_back(value(run.record));
    add_row(std::move(row));
  }

  void ComparisonTable::add_texts(const std::string &group, const std::string &key,
                                  const std::vector<ComparedRun> &runs, const std::string &of_lost)
  {
    ComparisonRow row{group, quantity(key).text, "", {}, {}};
    for (const ComparedRun &run : runs)
      row.texts.push_back(run.record.is_complete() ? run.record.summary().text(key) : of_lost);
    add_row(std::move(row));
  }

  void ComparisonTable::add_unreached_peaks(const std::vector<ComparedRun> &runs)
  {
    for (const char *key : {"tip/peak_reached", "root/peak_normal_stress_reached", "root/peak_moment_reached"})
      {
        std::string rising, pushed;
        for (const ComparedRun &run : runs)
          if (has(run.record, quantity(key).subject) && run.record.summary().is_false(key))
            add_name(has_warning(run.record, unfinished_contact) ? pushed : rising, run.name);
        if (!rising.empty())
          remarks.push_back(quantity(key).text + " of " + rising + ": still rising at the end, no peak yet.");
        if (!pushed.empty())
          remarks.push_back(quantity(key).text + " of " + pushed +
                            ": the bird still loads the blade at the end, it may be no peak yet.");
      }
    if (std::ranges::any_of(all, [](const ComparisonRow &row) { return row.is_any_rising(); }))
      remarks.emplace_back("+: a value that is no peak yet.");
  }

  void ComparisonTable::say_what_root_stress_is(const std::vector<ComparedRun> &runs)
  {
    std::set<std::string> kinds;
    for (const ComparedRun &run : runs)
      if (has(run.record, Subject::blade) && run.record.is_complete())
        kinds.insert(run.record.summary().text("blade/kind"));
    if (kinds.size() > 1)
      remarks.emplace_back("Root stress of a shell is that of the outermost integration points (of half the "
                           "thickness 0.95 with seven Gauss points, as by default, 0.91 with five, all with Lobatto), "
                           "of a solid that of its skin, both in the row of "
                           "elements at the clamped edge: more apart than the blades are. Compare root moments, or "
                           "stresses of one kind on one mesh.");
  }

  void ComparisonTable::add_permanent_deflection(const std::vector<ComparedRun> &runs)
  {
    ComparisonRow row{"Tip", "permanent deflection", "m", {}, {}};
    std::string   how, pushed, elastic, without;
    for (const ComparedRun &run : runs)
      {
        const RunRecord &record  = run.record;
        const bool       has_tip = record.is_complete() && !record.column("tip_mid_chord").empty() && !is_rigid(record),
                   is_pushed     = has_tip && has_warning(record, unfinished_contact);
        if (has_tip && !is_pushed && is_elastic(record))
          {
            row.values.push_back(0.);
            add_name(elastic, run.name);
            continue;
          }
        const auto mean =
          has_tip && !is_pushed
            ? compute_mean_over_last_period(record.column("time"), change_of(record.column("tip_mid_chord")))
            : std::nullopt;
        row.values.push_back(mean ? mean->mean : absent);
        if (mean)
          how += (how.empty() ? "" : "; ") + run.name + ": " + format_quantity(mean->period, "s") + " from " +
                 format_quantity(mean->begin, "s");
        else if (has_tip)
          add_name(is_pushed ? pushed : without, run.name);
      }
    add_row(row);
    if (!how.empty())
      remarks.push_back("Permanent deflection: mean over the last whole period of the tip after its peak, less the "
                        "deflection before the strike (" +
                        how + ").");
    if (!elastic.empty())
      remarks.push_back("Permanent deflection: zero for " + elastic + ", where nothing has yielded or failed.");
    if (!pushed.empty())
      remarks.push_back("Permanent deflection: none for " + pushed +
                        ", where the bird still loads the blade at the end; a later Time/End time gives it.");
    if (!without.empty())
      remarks.push_back("Permanent deflection: none for " + without +
                        ", no whole period after the tip's peak; a later Time/End time gives it.");
  }

  void ComparisonTable::say_what_filters_are(const std::vector<ComparedRun> &runs)
  {
    std::set<std::string> classes;
    std::string           of;
    for (const ComparedRun &run : runs)
      if (const std::string name = run.record.summary().text("contact/filtered/class");
          has(run.record, Subject::contact) && !name.empty())
        {
          classes.insert(name);
          of += (of.empty() ? "'" : ", '") + run.name + "' " + name;
        }
    if (classes.size() > 1)
      remarks.push_back("Filtered forces are not alike, by Output/Channel class: " + of + ".");
  }

  void ComparisonTable::add_warnings(const std::vector<ComparedRun> &runs)
  {
    std::vector<WarnedRun> all_of;
    for (const ComparedRun &run : runs)
      {
        warned.push_back(run.record.summary().warnings());
        all_of.push_back({"'" + run.name + "'", warned.back()});
      }
    for (std::string &line : digest_warnings(all_of))
      remarks.push_back(std::move(line));
  }

  void ComparisonTable::add_row(ComparisonRow row)
  {
    const bool has_value = std::any_of(row.values.begin(), row.values.end(), [](double v) { return !std::isnan(v); });
    const bool has_text =
      std::any_of(row.texts.begin(), row.texts.end(), [](const std::string &text) { return !text.empty(); });
    if (has_value || has_text || names.empty())
      all.push_back(std::move(row));
  }
} // namespace birdstrike
