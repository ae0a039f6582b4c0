#include "material/table_entry.h"

#include <birdstrike/core/declare_choice.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/material/failure_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    namespace Patterns = dealii::Patterns;

    const NamedChoices<FailureLaw> &failure_laws()
    {
      static const NamedChoices<FailureLaw> laws{{"none", FailureLaw::none},
                                                 {"plastic strain", FailureLaw::plastic_strain},
                                                 {"Johnson-Cook", FailureLaw::johnson_cook}};
      return laws;
    }

    const std::array<const char *, 5> what{{"failure strain at any triaxiality", "factor of the exponential term",
                                            "exponent of the triaxiality", "factor of the logarithmic strain rate",
                                            "factor of the homologous temperature"}};

    std::string entry_of(const std::size_t k)
    {
      return "Damage D" + std::to_string(k + 1);
    }

    SizeFactors read_size_factors(const std::string &text, const std::string &entry)
    {
      SizeFactors factors;
      const auto  pairs = parse_pairs(text, entry);
      const auto  read  = [where = entry + " (sizes in m, no unit behind them)"](const std::string &number) {
        return parse_numbers(number, 1, where)[0];
      };
      if (pairs.size() > SizeFactors::most_points)
        throw InputError(fmt::format("{}: {} points were read.\nAllowed: up to {} points 'size: factor'.", entry,
                                     pairs.size(), SizeFactors::most_points));
      for (const auto &[size_text, factor_text] : pairs)
        {
          const SizeFactors::Point point{read(size_text), read(factor_text)};
          const bool               grows = factors.n == 0 || point.size > factors.points[factors.n - 1].size;
          if (!(point.size > 0.) || !(point.factor > 0.) || !(point.factor <= 1000.) || !grows)
            throw InputError(
              fmt::format("{}: {:g} m: {:g} was read.\nAllowed: sizes of elements above 0 that grow from point to "
                          "point, factors above 0, at most 1000: '1e-3: 1.5; 3e-3: 1'.",
                          entry, point.size, point.factor));
          factors.points[factors.n++] = point;
        }
      return factors;
    }
  } // namespace

  void FailureParameters::declare(dealii::ParameterHandler &prm)
  {
    declare_choice(
      prm, "Failure", law, failure_laws(),
      "Failure law of the metal. A point that fails carries no load any more. none: never. plastic strain: at Failure "
      "strain. Johnson-Cook: at the damage sum dp / e_f = 1. Its failure strain is e_f = (D1 + D2 exp(D3 s*)) (1 + D4 "
      "ln r*) (1 + D5 T*). s* is the mean stress over the von Mises stress, positive in tension. r* is the plastic "
      "strain rate over the reference rate of a johnson-cook rate law, else over 1/s. [-]");
    prm.add_parameter("Failure strain", plastic_strain,
                      "Equivalent plastic strain at which a point fails, for Failure = plastic strain. [-]",
                      Patterns::Double(1e-6, 100.));
    for (std::size_t k = 0; k < d.size(); ++k)
      prm.add_parameter(entry_of(k), d[k],
                        std::string("Johnson-Cook damage constant: ") + what[k] +
                          (k == 2 ? ", negative for metals, or 'table'. [-]" : ", or 'table'. [-]"),
                        Patterns::Anything());
    prm.add_parameter(
      "Failure size factors", size_factors,
      "Factors on the failure strain over the element size: 'size: factor; ...', e.g. '1e-3: 1.5; 3e-3: 1'. Up to 16 "
      "points of growing size are joined by straight lines. Beyond both ends the factor is constant. The size is that "
      "at the start: the root of a shell's area, the cube root of a brick's volume. Sizes are in m, written without "
      "the unit. LS-DYNA has the same in LCREGD. Empty: 1. [-]",
      Patterns::Anything());
    prm.add_parameter("Failed share", failed_share,
                      "Share of an element's points that must have failed before the element is removed. 1, the usual "
                      "choice, waits for the last point. A point on the neutral axis of bending hardly strains: 0.8 "
                      "does not wait for one of five. [-]",
                      Patterns::Double(1e-3, 1.));
    prm.add_parameter("Smallest step", smallest_step,
                      "Smallest stable step of an element whose metal can fail, as a share of its first one. An "
                      "element with a smaller step is removed, and so is one that is turned inside out. 0: neither is "
                      "removed, and an element that is turned inside out ends the run. [-]",
                      Patterns::Double(0., 0.9));
  }

  Failure FailureParameters::failure(const Failure &table, const std::string &metal, const std::string &where) const
  {
    Failure result        = table;
    result.law            = law;
    result.plastic_strain = plastic_strain;
    result.failed_share   = failed_share;
    result.smallest_step  = smallest_step;
    if (result.law == FailureLaw::none && smallest_step > 0.)
      throw InputError(where + "Smallest step: " + number_text(smallest_step) +
                       " was read, but Failure is none, and no element of such a metal is removed.\nSet Smallest step "
                       "= 0, or name a law of failure.");
    result.size_factors = read_size_factors(size_factors, where + "Failure size factors");
    for (std::size_t k = 0; k < d.size(); ++k)
      replace(result.d[k], d[k], where + entry_of(k), k == 0 || k == 2 ? -100. : 0., 100.);
    const bool has_no_constants = std::all_of(result.d.begin(), result.d.end(), [](const double x) { return x == 0.; });
    if (result.law == FailureLaw::johnson_cook && has_no_constants)
      throw InputError(where + "Failure: Johnson-Cook was read, but the table has no damage constants for '" + metal +
                       "'.\nGive Damage D1 to D5, or choose a metal that has them: Al 2024 Johnson-Cook.");
    if (result.law == FailureLaw::johnson_cook)
      for (const double triaxiality : {-2. / 3., 1. / 3., 2. / 3.})
        if (result.d[0] + result.d[1] * std::exp(result.d[2] * triaxiality) <= 0.)
          throw InputError(where + "Damage D1: with these constants the failure strain at a triaxiality of " +
                           number_text(triaxiality) + " is not positive.\nSign of D3: negative for metals.");
    return result;
  }
} // namespace birdstrike
