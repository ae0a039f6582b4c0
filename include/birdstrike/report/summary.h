#pragma once

#include <birdstrike/io/input_files.h>
#include <birdstrike/report/run_view.h>

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace birdstrike
{
  /// The outcome of a run in stable keys for scripts (summary.json): SI units, absent parts are zero, a quantity that
  /// could not be computed (NaN) becomes null. The keys are those of source/report/quantities.h and, with one entry for
  /// each name, energy/parts (J at the end, see ledger.h), energy/error_origins (J), inputs, warnings and
  /// skipped. Its JSON schema: tests/data/summary.schema.json.
  struct Summary
  {
    /// Of the keys and their meaning: a script that reads another one than it knows should look. Keys may be added
    /// under the same number.
    static constexpr int schema = 1;

    nlohmann::ordered_json json;

    Summary() = default;
    explicit Summary(const RunView &run); ///< at the end of a run

    /// A value by its path, e.g. "tip/peak", "contact/impulse/2"; NaN if it is absent or null.
    double number(const std::string &key) const;
    /// The same for texts, e.g. "end/reason"; empty if it is absent.
    std::string text(const std::string &key) const;
    /// Whether it says no, e.g. "tip/peak_reached"; what is absent or null says nothing.
    bool is_false(const std::string &key) const;

    Warnings warnings() const;

    void add_aim(const StrikeAim &aim);
    void set_inputs(const std::vector<InputFile> &files); ///< as they were when the run read them
  };

  /// The text of summary.json.
  std::string to_text(const Summary &summary);

  /// Largest resident memory of this process so far (bytes).
  std::size_t compute_peak_memory();
} // namespace birdstrike
