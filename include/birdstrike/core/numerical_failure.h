#pragma once

#include <birdstrike/core/step_limit.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>

namespace birdstrike
{
  /// What is known of a computation that has left the valid range. Who finds it says what; the loop adds when, the run
  /// which checkpoint is left.
  struct FailureFacts
  {
    std::string what;       ///< what is lost, as a sentence without its end
    std::string quantity{}; ///< that says so, as its column or field is called; empty: `what` is all
    double      value = 0.;
    std::string unit{};                                           ///< "J", "m/s"; "-" and empty are not shown
    double      limit = std::numeric_limits<double>::quiet_NaN(); ///< none: only that it is no number
    std::string limit_name{"limit"};                              ///< "Time/Energy error limit" where it is an entry

    std::optional<double>        time{}; ///< s
    std::optional<std::uint64_t> step{};
    EntityPlace                  where{};
    std::string                  role{}; ///< of that entity, if it is not what is lost: "the fastest, 900 m/s"

    std::string details{}; ///< two lines at most
    std::string advice{};  ///< one line, with the entries that help

    std::string checkpoint{}; ///< the newest file, of a state that was in order; empty: none
    std::string way_on{};     ///< the last line: how to go on from it, or what would have written one

    /// All of it, in at most six lines.
    std::string text() const;
  };

  /// The computation left the valid range.
  class NumericalFailure : public std::exception
  {
  public:
    explicit NumericalFailure(FailureFacts facts);
    explicit NumericalFailure(const std::string &what);

    /// When it was found, unless that is known already.
    void add_instant(double time, std::uint64_t step);

    /// One that says more than nothing about what is lost as a whole.
    void add_entity(const EntityPlace &where, const std::string &role);

    void add_checkpoint(const std::string &file, const std::string &way_on);

    const FailureFacts &facts() const
    {
      return known;
    }
    const char *what() const noexcept override
    {
      return message.c_str();
    }

  private:
    FailureFacts known;
    std::string  message;
  };
} // namespace birdstrike
