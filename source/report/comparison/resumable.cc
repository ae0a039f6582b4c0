#include "report/comparison/resumable.h"
#include "report/comparison/run_reuse.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/program.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/checkpoint_file.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string read_text_of(const fs::path &file)
    {
      std::ifstream in(file, std::ios::binary);
      return {std::istreambuf_iterator<char>(in), {}};
    }

    /// As `resume` takes it: the newest that can be read.
    std::optional<Checkpoint> read_newest_of(const fs::path &folder)
    {
      for (const fs::path &file : find_checkpoints(folder))
        try
          {
            return read_checkpoint(file);
          }
        catch (const InputError &)
          {
          }
      return std::nullopt;
    }
  } // namespace

  namespace
  {
    /// Whether the files of the case are what the run began with.
    bool reads_the_same(const Checkpoint &checkpoint, const CaseParameters &wanted)
    {
      std::vector<InputFile> now = list_input_files(wanted);
      std::erase_if(now, [](const InputFile &file) { return file.is_included; });
      return std::ranges::equal(now, checkpoint.inputs, {}, &InputFile::fingerprint, &InputFile::fingerprint);
    }
  } // namespace

  std::optional<double> find_resumable_time(const fs::path &folder, const CaseParameters &wanted)
  {
    const fs::path prm = folder / "parameters.prm";
    if (fs::exists(folder / "failure.json") || !fs::exists(prm))
      return std::nullopt;
    const auto checkpoint = read_newest_of(folder);
    if (!checkpoint || checkpoint->program != program_identity().version + " " + program_identity().build ||
        checkpoint->parameters != read_text_of(prm) || checkpoint->time >= wanted.time.end_time * (1. - 1e-12))
      return std::nullopt;
    try
      {
        CaseParameters made_from;
        made_from.read(prm.string());
        if (!first_difference(wanted, made_from, entries_that_may_differ()).empty() ||
            !reads_the_same(*checkpoint, wanted))
          return std::nullopt;
      }
    catch (const InputError &)
      {
        return std::nullopt;
      }
    return checkpoint->time;
  }
} // namespace birdstrike
