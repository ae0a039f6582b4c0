#include "report/histories/columns.h"
#include "report/quantities.h"
#include <birdstrike/contact/report.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/columns.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/histories.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace birdstrike
{
  namespace
  {
    bool has_columns(const RunView &run, const Subject subject)
    {
      switch (subject)
        {
        case Subject::run:
          return true;
        case Subject::bird:
          return run.has_bird();
        case Subject::contact:
          return run.contact != nullptr;
        case Subject::blade:
          return run.blade != nullptr;
        case Subject::self_contact:
          return run.has_self_contact;
        case Subject::failure:
          return run.blade != nullptr && run.blade->failure().can_fail;
        }
      return false;
    }

    void add_quantities(const RunView *run, const bool of_blade, std::vector<HistoryColumn> &columns)
    {
      for (const Quantity &each : quantities())
        if (!each.column.empty() && (run == nullptr || has_columns(*run, each.subject)) &&
            (each.subject >= Subject::blade) == of_blade)
          for (unsigned int c = 0; c < (each.is_vector() ? 3 : 1); ++c)
            columns.push_back(
              {{each.column + (each.is_vector() ? std::string("_") + axis_names[c] : ""), each.unit, each.meaning},
               [&each, c](const RunView &now) { return each.number(now, c); }});
    }

    void add_pressures(const RunView *run, std::vector<HistoryColumn> &columns)
    {
      const auto patches = run == nullptr ? std::vector<PressurePatch>{{"NAME", {}, 0., 0.}}
                           : run->contact ? run->parameters.contact.pressure_patches()
                                          : std::vector<PressurePatch>{};
      for (std::size_t p = 0; p < patches.size(); ++p)
        columns.push_back(
          {{"pressure_" + column_name(patches[p].name), "Pa",
            "Mean contact pressure where the closest point lies in this disc of Contact/Pressure patches"},
           [p](const RunView &now) {
             return now.contact && !now.contact->patch_pressures.empty() ? now.contact->patch_pressures[p] : 0.;
           }});
    }

    /// Of each bird, where there are several.
    void add_birds(const RunView *run, std::vector<HistoryColumn> &columns)
    {
      const std::size_t n = run == nullptr ? 1 : run->birds.size() > 1 && run->contact ? run->birds.size() : 0;
      for (std::size_t k = 0; k < n; ++k)
        for (unsigned int c = 0; c < 3; ++c)
          columns.push_back(
            {{"bird_" + (run ? std::to_string(run->birds[k].number) : "NUMBER") + "_impulse_" + axis_names[c], "N s",
              "Time integral of the contact force of this bird, of several, on the blade, global axes"},
             [k, c](const RunView &now) { return now.birds[k].impulse[c]; }});
    }

    void add_probes(const RunView *run, std::vector<HistoryColumn> &columns)
    {
      const auto probes = run == nullptr ? std::vector<ProbeValues>{{"NAME"}}
                          : run->blade   ? run->blade->probes()
                                         : std::vector<ProbeValues>{};
      for (std::size_t p = 0; p < probes.size(); ++p)
        for (unsigned int c = 0; c < 3; ++c)
          columns.push_back({{"probe_" + column_name(probes[p].name) + "_u" + axis_names[c], "m",
                              "Displacement of the node nearest to this point of Blade/Probes, global axes"},
                             [p, c](const RunView &now) { return now.observed.probes[p].displacement[c]; }});
    }

    const Column &find(const std::vector<Column> &all, const std::string &name)
    {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Column &each) { return each.name == name; });
      if (found == all.end())
        throw std::logic_error("There is no dataset '" + name + "'.");
      return *found;
    }

    const std::vector<Column> &profiles()
    {
      static const std::vector<Column> all{
        {"root_normal_stress", "Pa",
         "Normal stress along the span in the root's elements, tension positive, [time][face][chord]"},
        {"root_normal_stress_at_peak", "Pa",
         "Normal stress along the span in the root's elements when its largest absolute value peaks, [face][chord]"},
        {"mid_chord_deflection_at_peak", "m",
         "Displacement of the mid-chord line along the tip's undeformed normal when the tip peaks, positive away from "
         "the struck side, [span]"},
        {"mid_chord_deflection_at_end", "m",
         "Displacement of the mid-chord line along the tip's undeformed normal at the end of the run, [span]"},
        {"filtered", "N", "Contact force on the blade filtered as filtered.csv, global axes, [time][component]"},
      };
      return all;
    }

    const std::vector<Column> &axes()
    {
      static const std::vector<Column> all{
        {"time", "s", "Time since first touch"},
        {"face", "-", "-1: the struck face, +1: the other"},
        {"chord", "m", "Distance along the chord from the middle of the root's section"},
        {"span", "m", "Distance along the undeformed span from the root"},
        {"component", "-", "0, 1, 2: x, y, z"},
      };
      return all;
    }

    /// Names of the columns from k on that share unit and meaning: "force_x, _y, _z".
    std::string joined_names(const std::vector<Column> &columns, std::size_t &k)
    {
      const Column &first = columns[k];
      std::string   names = first.name;
      for (++k; k < columns.size() && columns[k].unit == first.unit && columns[k].meaning == first.meaning; ++k)
        {
          names += ", " + columns[k].name.substr(columns[k].name.rfind('_'));
        }
      return names;
    }

    std::string describe(const std::string &title, const std::vector<Column> &columns)
    {
      std::vector<Column> lines;
      std::size_t         width = 0;
      for (std::size_t k = 0; k < columns.size();)
        {
          Column line = columns[k];
          line.name   = joined_names(columns, k);
          width       = std::max(width, line.name.size());
          lines.push_back(line);
        }
      std::string text = title + "\n";
      for (const Column &line : lines)
        text += fmt::format("  {:<{}}  {:<6}  {}\n", line.name, width, line.unit, line.meaning);
      return text;
    }
  } // namespace

  std::string column_name(std::string name)
  {
    for (char &letter : name)
      if (letter == ' ' || letter == ',' || letter == '/' || letter == '\t')
        letter = '_';
    return name;
  }

  std::vector<HistoryColumn> history_columns(const RunView *run)
  {
    std::vector<HistoryColumn> columns;
    add_quantities(run, false, columns);
    add_pressures(run, columns);
    add_birds(run, columns);
    add_quantities(run, true, columns);
    add_probes(run, columns);
    return columns;
  }

  const std::vector<Column> &filtered_columns()
  {
    static const std::vector<Column> all = [] {
      std::vector<Column> columns{axis("time")};
      for (const char *name : axis_names)
        columns.push_back({std::string("contact_force_") + name, "N",
                           "Contact force on the blade as a load cell of class Output/Channel class shows it (SAE "
                           "J211-1), global axes"});
      return columns;
    }();
    return all;
  }

  const Column &profile(const std::string &name)
  {
    return find(profiles(), name);
  }

  const Column &axis(const std::string &name)
  {
    return find(axes(), name);
  }

  std::string describe_columns(const RunView *run)
  {
    std::vector<Column> of_history;
    for (const HistoryColumn &column : history_columns(run))
      of_history.push_back(column.what);
    std::string text =
      describe("history.csv; results.h5: datasets of the group 'history', whose attributes repeat this", of_history);
    if (run == nullptr || (run->contact && run->parameters.output.channel_class > 0.))
      text += describe("filtered.csv", filtered_columns());
    if (run != nullptr && run->histories)
      for (const auto &table : run->histories->tables)
        text += describe(table->name + ".csv; results.h5: group '" + table->name + "'", table->columns);
    if (run == nullptr)
      text +=
        "nodes.csv, elements.csv, gauges.csv, sections.csv, patches.csv: what Output/Histories asks for; give the "
        "parameter file\n";
    return text + describe("results.h5: 'values' of these groups", profiles()) +
           describe("results.h5: their axes", axes());
  }
} // namespace birdstrike
