#pragma once

#include <birdstrike/material/failure.h>

#include <array>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// The failure of a metal as the user gives it. Damage constants are texts, since "table" (take them from the named
  /// metal) stands beside numbers; `failure` refuses any other text.
  struct FailureParameters
  {
    FailureLaw                 law            = FailureLaw::none;
    double                     plastic_strain = Failure().plastic_strain; ///< -
    std::array<std::string, 5> d              = {{"table", "table", "table", "table", "table"}};
    std::string                size_factors   = "";                      ///< "1e-3: 1.5; 3e-3: 1", m and -
    double                     failed_share   = Failure().failed_share;  ///< -
    double                     smallest_step  = Failure().smallest_step; ///< -

    bool operator==(const FailureParameters &) const = default;

    /// Declares the entries in the section that the caller has entered.
    void declare(dealii::ParameterHandler &prm);
    /// The law that follows, with the constants of a metal of the table and its name; throws InputError, which names
    /// the entries with `where` they stand.
    Failure failure(const Failure &table, const std::string &metal, const std::string &where) const;
  };
} // namespace birdstrike
