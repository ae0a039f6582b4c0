#include <birdstrike/material/equation_of_state.h>
#include <birdstrike/material/metal_constants.h>
#include <birdstrike/material/metal_parameters.h>
#include <birdstrike/material/unused_entries.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace birdstrike
{
  namespace
  {
    bool differ(const double a, const double b) // beyond what a written file rounds
    {
      return std::abs(a - b) > 1e-5 * std::abs(b);
    }

    /// Entries that say something else than usual and are not used.
    class Unused
    {
    public:
      void add(const bool is_used, const std::string &name, const bool is_changed, const std::string &reason)
      {
        if (!is_used && is_changed)
          all.push_back({name, reason});
      }

      std::vector<UnusedEntry> all;
    };

    void add_hardening(const MetalParameters &p, const Metal &metal, const std::set<std::string> &used, Unused &unused)
    {
      const MetalParameters standard;
      const std::string     law = "Hardening is " + hardening_name(metal);
      for (const auto &[key, name, text, usual] :
           {std::tuple("yield_stress", "Yield stress", &p.yield, &standard.yield),
            std::tuple("hardening_modulus", "Hardening modulus", &p.modulus, &standard.modulus),
            std::tuple("hardening_exponent", "Hardening exponent", &p.exponent, &standard.exponent),
            std::tuple("hardening_strain", "Hardening strain", &p.strain, &standard.strain)})
        unused.add(used.contains(key), name, *text != *usual, law);
      const Hardening &h         = metal.hardening;
      const bool       is_metal  = h.law != HardeningLaw::elastic;
      const bool       is_cowper = h.rate_law == RateLaw::cowper_symonds;
      unused.add(is_metal, "Rate factor", p.rate_factor != standard.rate_factor, law);
      unused.add(is_metal && is_cowper, "Rate exponent", differ(p.rate_exponent, standard.rate_exponent),
                 is_metal ? "Rate law is johnson-cook" : law);
      unused.add(is_metal && (is_cowper || h.rate_factor > 0. || used.contains("failure_reference_rate")),
                 "Reference rate", p.reference_rate != standard.reference_rate, is_metal ? "Rate factor is 0" : law);
    }

    void add_heating(const MetalParameters &p, const Metal &metal, Unused &unused)
    {
      const MetalParameters standard;
      const bool            heats  = metal.hardening.heat_capacity > 0.;
      const std::string     reason = "Adiabatic heating is false";
      for (const auto &[name, text, usual] :
           {std::tuple("Softening exponent", &p.softening_exponent, &standard.softening_exponent),
            std::tuple("Heat capacity", &p.heat_capacity, &standard.heat_capacity),
            std::tuple("Melting temperature", &p.melting_temperature, &standard.melting_temperature)})
        unused.add(heats, name, *text != *usual, reason);
      unused.add(heats, "Heat fraction", differ(p.taylor_quinney, standard.taylor_quinney), reason);
      for (const auto &[name, value, usual] :
           {std::tuple("Initial temperature", p.initial_temperature, standard.initial_temperature),
            std::tuple("Room temperature", p.room_temperature, standard.room_temperature)})
        unused.add(heats, name, differ(value, usual), reason + ", and the metal neither softens nor fails by its heat");
    }

    void add_failure(const MetalParameters &p, Unused &unused)
    {
      const FailureParameters &f         = p.failure, standard;
      const bool               is_strain = f.law == FailureLaw::plastic_strain;
      const std::string        law = is_strain ? "plastic strain" : f.law == FailureLaw::none ? "none" : "Johnson-Cook";
      const std::string        reason = "Failure is " + law;
      unused.add(is_strain, "Failure strain", differ(f.plastic_strain, standard.plastic_strain), reason);
      for (std::size_t k = 0; k < f.d.size(); ++k)
        unused.add(f.law == FailureLaw::johnson_cook, "Damage D" + std::to_string(k + 1), f.d[k] != standard.d[k],
                   reason);
      unused.add(f.law != FailureLaw::none, "Failure size factors", f.size_factors != standard.size_factors, reason);
      unused.add(f.law != FailureLaw::none, "Failed share", differ(f.failed_share, standard.failed_share), reason);
    }
  } // namespace

  std::vector<UnusedEntry> unused_entries(const MetalParameters &p)
  {
    const Metal           metal = p.metal();
    std::set<std::string> used;
    for (const MetalConstant &constant : constants_in_use(metal))
      used.insert(constant.key);
    Unused unused;
    add_hardening(p, metal, used, unused);
    add_heating(p, metal, unused);
    add_failure(p, unused);
    return unused.all;
  }

  std::vector<UnusedEntry> unused_entries(const EosParameters &p)
  {
    const EosParameters standard;
    const bool          is_porous = p.type == EosType::porous, has_shock = p.type == EosType::us_up || is_porous;
    const bool          is_murnaghan = p.type == EosType::murnaghan, is_polynomial = p.type == EosType::polynomial;
    Unused              unused;
    for (const auto &[is_used, name, value, usual] :
         {std::tuple(p.type == EosType::linear, "Bulk modulus", p.bulk_modulus, standard.bulk_modulus),
          std::tuple(is_murnaghan, "Murnaghan modulus", p.murnaghan_modulus, standard.murnaghan_modulus),
          std::tuple(is_murnaghan, "Murnaghan exponent", p.murnaghan_exponent, standard.murnaghan_exponent),
          std::tuple(is_polynomial, "Polynomial C1", p.c1, standard.c1),
          std::tuple(is_polynomial, "Polynomial C2", p.c2, standard.c2),
          std::tuple(is_polynomial, "Polynomial C3", p.c3, standard.c3),
          std::tuple(has_shock, "Sound speed", p.sound_speed, standard.sound_speed),
          std::tuple(has_shock, "Shock slope", p.shock_slope, standard.shock_slope),
          std::tuple(is_porous, "Porosity", p.porosity, standard.porosity),
          std::tuple(is_porous, "Liquid density", p.liquid_density, standard.liquid_density),
          std::tuple(is_porous, "Ambient pressure", p.ambient_pressure, standard.ambient_pressure)})
      unused.add(is_used, name, differ(value, usual), "Type is " + eos_types().name(p.type));
    return unused.all;
  }
} // namespace birdstrike
