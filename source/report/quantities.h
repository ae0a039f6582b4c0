#pragma once

#include <birdstrike/report/run_view.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace birdstrike
{
  /// Which part a quantity speaks of. Its column exists in a scene that has this part, a comparison shows it of such
  /// runs (of a blade: deformable ones).
  enum class Subject
  {
    run,
    bird,
    contact,
    blade,
    self_contact,
    failure
  };

  /// A quantity that is reported. It is described here and nowhere else: a row of the table in quantities.cc makes it a
  /// column of history.csv, a value of summary.json, or both, of which summary.json has the last value.
  struct Quantity
  {
    using View   = const RunView &;
    using Source = std::variant<double (*)(View), std::size_t (*)(View), std::string (*)(View),
                                std::optional<bool> (*)(View), std::array<double, 3> (*)(View), const LedgerEntry *>;

    std::string column; ///< name in history.csv; of vectors followed by _x, _y, _z; empty: none
    std::string key;    ///< path in summary.json; empty: none
    std::string unit;   ///< "m", "-", "count", "B", "share"
    Source      value;
    std::string text    = {}; ///< in words, where a table shows it
    std::string meaning = {}; ///< of a column: of what, in which frame, with which sign
    Subject     subject = Subject::run;

    bool   is_vector() const;
    double number(const RunView &run, unsigned int component = 0) const; ///< of no text or truth
  };

  /// All of them: in the order of the columns, and within each object of summary.json in the order of its keys.
  const std::vector<Quantity> &quantities();

  /// By its key. Throws std::logic_error if there is none.
  const Quantity &quantity(std::string_view key);
} // namespace birdstrike
