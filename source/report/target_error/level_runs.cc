#include "report/target_error/level_runs.h"
#include "report/comparison/case_run.h"
#include "report/study/lattice_places.h"
#include "report/study/section_masses.h"
#include "report/study/study_runs.h"
#include "report/target_error/climb.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t n_coarser   = 2; ///< than the case
    constexpr std::size_t most_levels = 5; ///< half the case's sizes; a sixth of the bird takes thrice all before it
    constexpr double      ratio       = std::numbers::sqrt2; ///< of sizes; Celik et al. advise at least 1.3

    /// One level where there is nothing to refine.
    std::vector<LadderLevel> make_levels(const CaseParameters &parameters, const std::size_t axis)
    {
      const Refinement         refinement = axis == 0 ? Refinement::particles : Refinement::mesh;
      std::vector<LadderLevel> made;
      try
        {
          for (std::size_t k = 0; k < most_levels; ++k)
            made.push_back(make_level(parameters, refinement,
                                      std::pow(ratio, static_cast<double>(n_coarser) - static_cast<double>(k))));
        }
      catch (const InputError &)
        {
          return {{0., {}}};
        }
      const auto is_same = [](const LadderLevel &a, const LadderLevel &b) { return !(b.size < a.size); };
      if (std::ranges::adjacent_find(made, is_same) != made.end())
        throw InputError(
          "The mesh is too coarse to have two coarser ones beside it.\n  Action: more Blade/Mesh/Elements "
          "along span and chord.");
      return made;
    }

    /// A rigid rectangle is exact.
    bool has_mesh(const BladeParameters &blade)
    {
      return blade.is_deformable() || (blade.kind == BladeKind::rigid && blade.rigid.surface == RigidSurface::mesh);
    }

    [[noreturn]] void refuse(const std::string &why)
    {
      throw NumericalFailure("The target error cannot be claimed: " + why);
    }
  } // namespace

  LevelRuns::LevelRuns(const TargetRequest &request, const std::filesystem::path &directory,
                       const AskedQuantity &quantity)
    : request(request), directory(directory), asked(quantity)
  {
    CaseParameters parameters;
    parameters.read(request.prm_file, request.overrides);
    for (std::size_t a = 0; a < levels.size(); ++a)
      levels[a] = make_levels(parameters, a);
    are_there = {parameters.bird.enabled, has_mesh(parameters.blade)};
    if (levels[0].size() == 1 && levels[1].size() == 1)
      throw InputError("There is neither a bird nor a built-in mesh that could be refined.\n  Action: run the case "
                       "without --target-error.");
    places = make_lattice_places(parameters, request.n_places);
  }

  bool LevelRuns::is_there(const std::size_t axis) const
  {
    return are_there[axis];
  }

  std::size_t LevelRuns::n_levels(const std::size_t axis) const
  {
    return levels[axis].size();
  }

  double LevelRuns::size(const std::size_t axis, const std::size_t level) const
  {
    return levels[axis][level].size;
  }

  std::vector<std::string> LevelRuns::overrides_at(const Levels &at) const
  {
    return point_at(at, 0).overrides;
  }

  StudyPoint LevelRuns::point_at(const Levels &at, const std::size_t place) const
  {
    LadderLevel both = levels[0][at.first];
    for (const std::vector<std::string> &more : {levels[1][at.second].overrides, places[place]})
      both.overrides.insert(both.overrides.end(), more.begin(), more.end());
    return {both.name(), make_folder_name(both.name()), {place}, both.overrides};
  }

  LevelRuns::KnownRun LevelRuns::read(const StudyPoint &point, const std::filesystem::path &folder)
  {
    const RunRecord record = read_record(folder);
    const auto      rows   = ComparisonTable({{point.name, record}}).rows();
    row                    = find_row(rows, asked);
    const std::string name = row.group + ": " + row.quantity;
    if (!(std::abs(row.values[0]) > 0.) || !std::isfinite(row.values[0]))
      refuse(name + " is zero, or none, with " + point.name + ".");
    if (row.is_rising(0))
      refuse(name + " still rises at the end of " + point.name +
             ", or the bird still loads the blade there: it may be no peak yet.\n  Action: a later Time/End time.");
    return {point.at[0],
            row.values[0],
            record.summary().number("cost/wall"),
            folder,
            {"'" + point.name + "'", record.summary().warnings()}};
  }

  void LevelRuns::require_one_blade() const
  {
    std::vector<std::filesystem::path> folders;
    for (const auto &[at, known] : runs)
      for (const KnownRun &run : known)
        folders.push_back(run.folder);
    if (const std::string why = describe_changing_sections(folders); !why.empty())
      refuse(why);
  }

  void LevelRuns::run(const std::vector<Levels> &wanted)
  {
    std::vector<StudyPoint> points;
    std::vector<Levels>     of_points;
    for (const Levels &at : wanted)
      if (!runs.contains(at))
        for (std::size_t place = 0; place < places.size(); ++place)
          {
            of_points.push_back(at);
            points.push_back(point_at(at, place));
          }
    if (points.empty())
      return;
    RunOptions options{request.prm_file, request.overrides, 0, "", "climb", request.is_forced};
    auto       made = plan_runs(points, directory, options);
    run_points(made, options);
    std::string why;
    for (std::size_t k = 0; k < made.size(); ++k)
      try
        {
          if (!made[k].is_done)
            refuse(made[k].point.name + " " + made[k].state);
          runs[of_points[k]].push_back(read(made[k].point, made[k].folder));
        }
      catch (const NumericalFailure &failure) // the others are there
        {
          why = why.empty() ? failure.what() : why;
        }
    if (!why.empty())
      throw NumericalFailure(why);
    for (const auto &[at, known] : runs)
      if (!values_of.contains(at))
        for (const KnownRun &run : known)
          values_of[at].push_back(run.value);
    require_one_blade();
  }

  std::size_t LevelRuns::n_places() const
  {
    return places.size();
  }

  std::size_t LevelRuns::n_runs() const
  {
    return runs.size() * places.size();
  }

  double LevelRuns::value(const Levels &at) const
  {
    return mean_over_places(values(at), places.size()).at(0).mean;
  }

  const std::vector<double> &LevelRuns::values(const Levels &at) const
  {
    return values_of.at(at);
  }

  std::vector<LevelRuns::Levels> LevelRuns::all() const
  {
    std::vector<Levels> known;
    for (const auto &[at, of_places] : values_of)
      known.push_back(at);
    return known;
  }

  const std::filesystem::path &LevelRuns::folder(const Levels &at) const
  {
    return runs.at(at).at(0).folder;
  }

  const ComparisonRow &LevelRuns::quantity() const
  {
    return row;
  }

  std::string LevelRuns::as_csv() const
  {
    const auto size_of = [&](const std::size_t axis, const std::size_t level) {
      return levels[axis].size() > 1 ? fmt::format("{}", levels[axis][level].size) : "";
    };
    std::string text = "particle spacing [m],size of an element [m]," + csv_heading(row) +
                       ",run time [s],folder,place of the lattice [-]\n";
    for (const auto &[at, known] : runs)
      for (std::size_t place = 0; place < known.size(); ++place)
        text += fmt::format("{},{},{},{},{},{}\n", size_of(0, at.first), size_of(1, at.second), known[place].value,
                            known[place].seconds, csv_field(known[place].folder.string()), known[place].place + 1);
    return text;
  }

  std::string LevelRuns::warnings_as_text() const
  {
    std::vector<WarnedRun> all;
    for (const auto &[at, known] : runs)
      for (const KnownRun &run : known)
        all.push_back(run.warned);
    std::string text;
    for (const std::string &line : digest_warnings(all))
      text += line + "\n";
    return text;
  }
} // namespace birdstrike
