#include "simulation/run_size.h"
#include "simulation/explain.h"
#include "simulation/scene.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr double bytes_of_a_row  = 8. * 50.;
    constexpr double best_compressed = 20.; ///< times smaller than before

    /// On the disk of a folder that may still have to be made; infinite where the system does not say (/proc).
    double free_bytes(fs::path folder)
    {
      std::error_code error;
      for (folder = fs::absolute(folder, error); !fs::exists(folder, error) && folder.has_relative_path();)
        folder = folder.parent_path();
      const fs::space_info space = fs::space(folder, error);
      return error || space.available == 0 ? std::numeric_limits<double>::infinity()
                                           : static_cast<double>(space.available);
    }
  } // namespace

  void require_bounded_run(const CaseParameters &parameters, const Scene &scene)
  {
    const OutputParameters &output   = parameters.output;
    const double            end_time = parameters.time.end_time, n_steps = end_time / scene.last_plan().step;
    const double            n_rows =
      output.history_interval > 0. ? std::min(n_steps, end_time / output.history_interval) : n_steps;
    if (const auto available = static_cast<double>(available_memory()); n_rows * bytes_of_a_row > available)
      throw InputError(fmt::format("Output/History interval = {:g} s makes {:.2g} rows: more than {} of memory; {} are "
                                   "there.\nAction: a larger interval.",
                                   output.history_interval, n_rows, format_bytes(n_rows * bytes_of_a_row),
                                   format_bytes(available)));

    const double bytes = compute_field_bytes(parameters, scene), free = free_bytes(parameters.run_directory());
    if (bytes > best_compressed * free)
      throw InputError(fmt::format("Output/Field interval = {:g} s makes field files of {} before compression; {} are "
                                   "free on the disk.\nAction: a larger interval, or another disk by --output DIR.",
                                   output.field_interval, format_bytes(bytes), format_bytes(free)));
  }
} // namespace birdstrike
