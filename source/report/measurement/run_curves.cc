#include "report/measurement/run_curves.h"
#include "report/comparison/run_record.h"
#include "report/measurement/data_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/output_parameters.h>
#include <birdstrike/report/text.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace birdstrike
{
  namespace
  {
    /// Words for what is measured most, and the table and column that has it.
    const std::map<std::string, std::string> &words()
    {
      static const std::map<std::string, std::string> all{{"tip", "tip_mid_chord"},
                                                          {"root moment", "root_bending_moment"},
                                                          {"root stress", "root_peak_normal_stress"},
                                                          {"impulse", "contact_impulse"},
                                                          {"force", "filtered/contact_force"}};
      return all;
    }

    struct Profile
    {
      std::string    title, dataset, place, unit;
      std::ptrdiff_t face; ///< of how many values each has two faces; -1: one line
    };

    const std::map<std::string, Profile> &profiles()
    {
      static const std::map<std::string, Profile> all{
        {"root profile", {"normal stress along the root, struck face", "root_normal_stress_at_peak", "chord", "Pa", 0}},
        {"rear root profile",
         {"normal stress along the root, rear face", "root_normal_stress_at_peak", "chord", "Pa", 1}},
        {"mid-chord profile",
         {"deflection of the mid-chord line at the tip's peak", "mid_chord_deflection_at_peak", "span", "m", -1}}};
      return all;
    }

    RunCurve read_profile(const std::filesystem::path &run, const Profile &profile)
    {
      const RunRecord record(run);
      RunCurve   curve{profile.title, profile.unit, record.dataset(profile.dataset + "/" + profile.place), {}, true};
      const auto values = record.dataset(profile.dataset + "/values");
      const auto n      = static_cast<std::ptrdiff_t>(curve.x.size());
      const auto first  = std::max<std::ptrdiff_t>(profile.face, 0) * n;
      if (n == 0 || static_cast<std::ptrdiff_t>(values.size()) < first + n)
        throw InputError("The run in " + run.string() + " has no " + profile.title +
                         ".\nIt is in results.h5 of runs with Output/HDF5 = true, of blades that have root and tip.");
      curve.y.assign(values.begin() + first, values.begin() + first + n);
      return curve;
    }

    constexpr std::string_view filtered_table = "filtered";

    void require_filtered(const std::filesystem::path &run)
    {
      if (std::filesystem::exists(run / "filtered.csv"))
        return;
      const std::string of_class = RunRecord(run).summary().text("contact/filtered/class");
      throw InputError("The run in " + run.string() + " has no filtered contact force: " +
                       (of_class == channel_classes().name(0.) ? "it was made with Output/Channel class = none."
                                                               : "it has not ended, or had no contact.") +
                       "\nThe word 'force' takes filtered.csv; contact_force of history.csv is the force as it is.");
    }

    /// A column that another table of the run has under this name, or behind a point: its full name.
    void require_full_name(const std::filesystem::path &run, const DataTable &data, const std::string &column)
    {
      if (data.has(column) || data.has(column + "_x"))
        return;
      std::string names;
      for (const char *table : {"gauges", "nodes", "elements", "sections", "patches"})
        if (const std::filesystem::path file = run / (std::string(table) + ".csv"); std::filesystem::exists(file))
          for (const std::string &name : DataTable(file).names())
            if (name == column || name.ends_with("." + column))
              names += (names.empty() ? "" : ", ") + std::string(table) + "/" + name;
      if (!names.empty())
        throw InputError("There is no column '" + column + "' in " + data.file().string() +
                         ".\nThe full name, with its table, is asked for: " + names + ".");
    }

    /// Each cell of a run's own table is a number.
    const std::vector<double> &whole(const DataTable &data, const TableColumn &column)
    {
      if (std::ranges::any_of(column.values, [](const double value) { return std::isnan(value); }))
        throw InputError("Column '" + column.name + "' of " + data.file().string() + " has empty cells.");
      return column.values;
    }

    /// The filter rings out beyond both ends, where nothing was computed.
    void cut_to_run(RunCurve &curve, const std::filesystem::path &run)
    {
      const DataTable     history(run / "history.csv");
      const auto         &times = history.column("time").values;
      const double        end   = times.empty() ? 0. : times.back();
      std::vector<double> x, y;
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        if (curve.x[k] >= 0. && curve.x[k] <= end)
          {
            x.push_back(curve.x[k]);
            y.push_back(curve.y[k]);
          }
      if (x.size() < 2)
        throw InputError("The run in " + run.string() + " is too short for a filtered force: it ends at " +
                         format_quantity(end, "s") + ".");
      curve.x = std::move(x);
      curve.y = std::move(y);
    }

    RunCurve read_column(const std::filesystem::path &run, const std::string &quantity, const std::string &name)
    {
      const auto        slash  = name.find('/');
      const std::string table  = slash == std::string::npos ? "history" : name.substr(0, slash),
                        column = slash == std::string::npos ? name : name.substr(slash + 1);
      if (table == filtered_table)
        require_filtered(run);
      const DataTable data(run / (table + ".csv"));
      RunCurve        curve{quantity, "", whole(data, data.column("time")), {}, false};
      require_full_name(run, data, column);
      if (data.has(column + "_x") && data.has(column + "_y") && data.has(column + "_z"))
        {
          const auto &x = data.column(column + "_x"), &y = data.column(column + "_y"), &z = data.column(column + "_z");
          for (std::size_t k = 0; k < x.values.size(); ++k)
            curve.y.push_back(std::hypot(x.values[k], y.values[k], z.values[k]));
          curve.unit = x.unit;
        }
      else
        {
          const TableColumn &found = data.column(column);
          curve.y                  = whole(data, found);
          curve.unit               = found.unit;
        }
      if (table == filtered_table)
        cut_to_run(curve, run);
      return curve;
    }
  } // namespace

  RunCurve read_run_curve(const std::filesystem::path &run, const std::string &quantity)
  {
    if (!std::filesystem::exists(run / "history.csv"))
      throw InputError("There is no run in " + run.string() +
                       ": no history.csv.\nA measurement is compared with the folder that 'birdstrike run' has left.");
    const bool        is_turned = quantity.starts_with('-');
    const std::string name      = is_turned ? quantity.substr(1) : quantity;
    const auto        profile   = profiles().find(name);
    const auto        word      = words().find(name);
    RunCurve          curve     = profile != profiles().end()
                                    ? read_profile(run, profile->second)
                                    : read_column(run, quantity, word != words().end() ? word->second : name);
    for (double &y : curve.y)
      y = is_turned ? -y : y;
    return curve;
  }
} // namespace birdstrike
