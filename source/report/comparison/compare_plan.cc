#include "report/comparison/compare_plan.h"

#include "report/comparison/resumable.h"
#include "report/comparison/run_reuse.h"
#include "report/comparison/written_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/output_entries.h>
#include <birdstrike/io/report_folder.h>

#include <fmt/format.h>

#include <set>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What may differ between two files that describe the same case.
    const EntryNames only_names =
      output_entries_and({"Case/Name", "Output/Blade fields", "Output/Bird fields", "Output/HDF5"});

    /// Of runs of one file, with values of their own, only the folders tell which is which.
    std::string name_of(const std::string &file, const CaseParameters &parameters)
    {
      const fs::path path(file), folder = path.parent_path();
      const bool     is_of_run = path == folder / "parameters.prm" && fs::exists(folder / ".birdstrike");
      return is_of_run ? fs::absolute(path).lexically_normal().parent_path().filename().string() : parameters.name;
    }

    /// A deformable blade whose file does not say what a rigid surface would be.
    bool is_of_mesh(const std::string &file, const std::vector<std::string> &overrides)
    {
      CaseParameters plain;
      plain.read(file, overrides);
      return plain.blade.is_deformable() && !plain.file.is_given("Blade/Rigid/Surface");
    }

    /// A run folder stands for the entries of its run.
    std::string file_of(const std::string &path)
    {
      const fs::path entries = fs::path(path) / "parameters.prm";
      return fs::is_regular_file(entries) ? entries.string() : path;
    }

    PlannedCase read_case(const CompareRequest &request, const std::string &path, const std::string &kind)
    {
      const std::string file = file_of(path);
      PlannedCase       planned;
      planned.prm_file  = file;
      planned.overrides = request.overrides;
      if (!kind.empty())
        planned.overrides.push_back("Blade/Kind=" + kind);
      if (kind == blade_kinds().name(BladeKind::rigid) && is_of_mesh(file, request.overrides))
        planned.overrides.push_back("Blade/Rigid/Surface=mesh"); // the blade's own, not a rectangle of its own size
      planned.parameters = std::make_unique<CaseParameters>();
      planned.parameters->read(file, planned.overrides);
      planned.name   = name_of(file, *planned.parameters) + (kind.empty() ? "" : " " + kind);
      planned.folder = ReportFolder::run_folder(request.output, planned.name);
      return planned;
    }

    void require_difference(const PlannedCase &a, const PlannedCase &b)
    {
      if (first_difference(*a.parameters, *b.parameters, only_names).empty())
        throw InputError(fmt::format("'{}' and '{}' are the same case: all entries that matter agree.\n  Action: leave "
                                     "one out, or change an entry of one.",
                                     a.prm_file + (a.prm_file == b.prm_file ? " (" + a.name + ")" : ""),
                                     b.prm_file + (a.prm_file == b.prm_file ? " (" + b.name + ")" : "")));
      if (a.folder == b.folder)
        throw InputError(fmt::format("'{}' and '{}' would both run in the folder '{}'.\n  Action: give one of them "
                                     "another Case/Name.",
                                     a.prm_file, b.prm_file, b.folder.string()));
    }

    /// The name of the case that a folder holds a run of, complete or not; empty if it says none.
    std::string name_of_run_in(const fs::path &folder)
    {
      try
        {
          CaseParameters parameters;
          parameters.read((folder / "parameters.prm").string());
          return parameters.name;
        }
      catch (const InputError &)
        {
          return "";
        }
    }

    /// The comparison's own folder may hold an earlier run of this case.
    void require_own_folder(const PlannedCase &planned)
    {
      const std::string other = name_of_run_in(planned.folder);
      if (!other.empty() && other != planned.parameters->name)
        throw InputError(fmt::format("'{}' is to run in the folder '{}', which holds a run of another case, '{}'.\n  "
                                     "Action: choose another folder with --output DIR.",
                                     planned.name, planned.folder.string(), other));
    }

    void look_for_run(PlannedCase &planned)
    {
      const fs::path parent = fs::path(planned.prm_file).parent_path(), beside = parent.empty() ? "." : parent;
      FoundRun       found =
        find_run({planned.folder, fs::path(planned.parameters->run_directory()), beside}, *planned.parameters);
      if (found.in_use)
        planned.folder = found.folder;
      planned.is_reused = found.in_use != nullptr;
      planned.in_use    = std::move(found.in_use);
      planned.why_run   = found.why_not;
      if (!planned.is_reused)
        planned.goes_on_from = find_resumable_time(planned.folder, *planned.parameters);
    }

    /// What is there of other entries, or in a table of other cases.
    void require_no_loss(const std::vector<PlannedCase> &cases, const fs::path &folder)
    {
      std::set<std::string> names;
      for (const PlannedCase &planned : cases)
        {
          names.insert(planned.name);
          if (planned.is_reused || planned.goes_on_from)
            continue;
          const std::string why = reason_to_keep(planned.folder, *planned.parameters);
          refuse_loss_of_runs(planned.folder, why, why.empty() ? 0 : 1);
        }
      const WrittenTable       table(folder / "comparison.csv");
      std::vector<std::string> lost;
      for (std::size_t row = 0; row < table.n_rows(); ++row)
        if (const std::string &name = table.field(row, "case"); !names.contains(name))
          lost.push_back(name);
      refuse_loss_of(lost, folder, comparison_kind(), "the same cases again, or with more of them");
    }
  } // namespace

  const ReportKind &comparison_kind()
  {
    static const ReportKind kind{
      "comparison",
      {"comparison", "tip_deflection", "contact", "energies", "root_moment", "root_stress", "profiles"},
      {"figures.gp"}};
    return kind;
  }

  std::vector<PlannedCase> plan_comparison(const CompareRequest &request)
  {
    ReportFolder::require_usable(request.output, comparison_kind());
    std::vector<PlannedCase>       cases;
    const std::vector<std::string> as_they_are{""};
    for (const std::string &file : request.prm_files)
      for (const std::string &kind : request.blade_kinds.empty() ? as_they_are : request.blade_kinds)
        {
          cases.push_back(read_case(request, file, kind));
          for (std::size_t k = 0; k + 1 < cases.size(); ++k)
            require_difference(cases[k], cases.back());
        }
    for (PlannedCase &planned : cases)
      {
        require_own_folder(planned);
        look_for_run(planned);
      }
    if (!request.is_forced)
      require_no_loss(cases, request.output);
    return cases;
  }
} // namespace birdstrike
