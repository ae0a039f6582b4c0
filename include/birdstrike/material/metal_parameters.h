#pragma once

#include <birdstrike/material/failure_parameters.h>
#include <birdstrike/material/metal.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// The metal of a blade as the user gives it: a name of `metal_table`, and values that replace those of the table.
  /// Values are texts, since "table" (take it from the name) stands beside numbers; metal() refuses any other text.
  /// Hardening data default to what a law needs to be neutral, where the table has nothing.
  struct MetalParameters
  {
    std::string name      = "Ti-6Al-4V";
    std::string density   = "table"; ///< kg/m^3
    std::string young     = "table"; ///< Pa
    std::string poisson   = "table"; ///< -
    std::string hardening = "table"; ///< law
    std::string yield     = "table"; ///< Pa
    std::string modulus   = "table"; ///< Pa
    std::string exponent  = "table"; ///< -
    std::string strain    = "table"; ///< -

    std::string curve = ""; ///< "0: 880e6; 0.02: 910e6", plastic strain and Pa

    RateLaw     rate_law       = RateLaw::johnson_cook;
    std::string rate_factor    = "table"; ///< -
    std::string reference_rate = "table"; ///< 1/s
    double      rate_exponent  = 5.;      ///< -, of Cowper and Symonds

    bool        is_adiabatic        = false;
    std::string heat_capacity       = "table"; ///< J/(kg K)
    double      taylor_quinney      = 0.9;     ///< -
    double      initial_temperature = 293.;    ///< K
    double      room_temperature    = 293.;    ///< K
    std::string melting_temperature = "table"; ///< K
    std::string elongation          = "table"; ///< -
    std::string softening_exponent  = "table"; ///< -

    FailureParameters failure{};

    bool operator==(const MetalParameters &) const = default;

    /// Declares the entries in the section that the caller has entered; a default name that the table does not have
    /// may be chosen too.
    void declare(dealii::ParameterHandler &prm);
    /// The metal that follows; throws InputError, which names the entries with `where` they stand.
    Metal metal(const std::string &where = "Blade/Material/") const;

    /// A value that the metal's laws use.
    struct UsedValue
    {
      std::string entry;       ///< "Yield stress"
      std::string value;       ///< as the entry may say it, to the last bit
      bool        is_taken;    ///< the entry says 'table'
      bool        is_of_table; ///< what the table has for the named metal, taken or repeated
    };
    /// Of all entries that may say 'table'; those that play no part are left out. Throws as `metal` does.
    std::vector<UsedValue> used_values(const std::string &where = "Blade/Material/") const;

  private:
    void set_heating(Hardening &hardening, const std::string &where) const;
    void set_curve(Hardening &hardening, double young, const std::string &where) const;
    void set_rate(Hardening &hardening, const std::string &where) const;
  };
} // namespace birdstrike
