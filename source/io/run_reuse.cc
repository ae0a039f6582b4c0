#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/parameter_tree.h>
#include <birdstrike/io/run_record.h>
#include <birdstrike/io/run_reuse.h>
#include <birdstrike/io/summary.h>

#include <algorithm>
#include <cstdlib>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    const EntryNames place_of_the_run{"Output/Directory"};

    std::string name_of(const KnownEntry &entry)
    {
      return (entry.section.empty() ? "" : to_string(entry.section) + "/") + entry.name;
    }

    /// False for what is no number as a whole.
    bool parse(const std::string &text, double &value)
    {
      char *end = nullptr;
      value     = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0';
    }

    bool are_equal(const std::string &a, const std::string &b)
    {
      double of_a = 0., of_b = 0.;
      return a == b || (parse(a, of_a) && parse(b, of_b) && of_a == of_b);
    }

    /// The first file that an entry names and that was changed after `time`; empty if there is none.
    std::string newer_file(const CaseParameters &parameters, const fs::file_time_type time)
    {
      const ParameterTree tree = parameters.file.tree();
      for (const KnownEntry &entry : tree.entries())
        {
          std::error_code error;
          if (!entry.value.empty() && fs::is_regular_file(entry.value, error) &&
              fs::last_write_time(entry.value, error) > time)
            return entry.value;
        }
      return "";
    }
  } // namespace

  std::string first_difference(const CaseParameters &a, const CaseParameters &b, const EntryNames &ignored)
  {
    const ParameterTree tree_a = a.file.tree(), tree_b = b.file.tree();
    for (const KnownEntry &entry : tree_a.entries())
      {
        const std::string name = name_of(entry);
        if (std::find(ignored.begin(), ignored.end(), name) == ignored.end() &&
            !are_equal(entry.value, tree_b.find(entry.section, entry.name)->value))
          return name;
      }
    return "";
  }

  std::string reason_not_to_reuse(const fs::path &folder, const CaseParameters &wanted)
  {
    const RunRecord run(folder);
    if (!run.is_complete())
      return "there is no complete run";
    if (run.text("program/version") != program_identity().version)
      return "another release of the program made it";
    if (run.text("program/build") != program_identity().build)
      return "another build of the program made it";
    if (run.text("end/reason") == stopped_by_signal)
      return "a signal ended it";
    CaseParameters made_from;
    try
      {
        made_from.read((folder / "parameters.prm").string());
      }
    catch (const InputError &)
      {
        return "its parameters.prm cannot be read";
      }
    if (const std::string entry = first_difference(wanted, made_from, place_of_the_run); !entry.empty())
      return entry + " differs";
    if (const std::string file = newer_file(wanted, fs::last_write_time(folder / "summary.json")); !file.empty())
      return "'" + file + "' was changed since";
    return "";
  }
} // namespace birdstrike
