#include "material/metal_table.h"

#include <array>
#include <map>
#include <string>

namespace birdstrike
{
  namespace
  {
    Metal make_metal(const std::string &name, const double density, const Elasticity &elasticity, const double yield,
                     const double elongation)
    {
      Metal metal;
      metal.name              = name;
      metal.density           = density;
      metal.elasticity        = elasticity;
      metal.hardening.law     = HardeningLaw::perfect;
      metal.hardening.yield   = yield;
      metal.hardening.density = density;
      metal.elongation        = elongation;
      return metal;
    }

    /// Heat capacity (J/(kg K)) and temperature at which melting begins (K).
    Metal with_heat(Metal metal, const double heat_capacity, const double melting_temperature)
    {
      metal.hardening.heat_capacity       = heat_capacity;
      metal.hardening.melting_temperature = melting_temperature;
      return metal;
    }

    /// A, B in Pa, the rest without unit.
    Metal make_johnson_cook(Metal metal, const std::string &name, const std::array<double, 5> &a_b_n_c_m)
    {
      metal.name                         = name;
      metal.hardening.law                = HardeningLaw::johnson_cook;
      metal.hardening.yield              = a_b_n_c_m[0];
      metal.hardening.modulus            = a_b_n_c_m[1];
      metal.hardening.exponent           = a_b_n_c_m[2];
      metal.hardening.rate_factor        = a_b_n_c_m[3];
      metal.hardening.softening_exponent = a_b_n_c_m[4];
      return metal;
    }
  } // namespace

  const NamedChoices<Metal> &metal_table()
  {
    static const Metal ti_811  = make_metal("Ti-8Al-1Mo-1V", 4370., {121e9, 0.32}, 930e6, 0.12);
    static const Metal ti_64   = with_heat(make_metal("Ti-6Al-4V", 4430., {113.8e9, 0.342}, 880e6, 0.14), 526.3, 1873.);
    static const Metal al      = make_metal("Al 6061-T6", 2700., {68.9e9, 0.33}, 276e6, 0.12);
    static const Metal al_2024 = [] {
      const Metal data  = with_heat(make_metal("Al 2024", 2780., {73e9, 0.33}, 369e6, 0.), 875., 775.);
      Metal       metal = make_johnson_cook(data, "Al 2024 Johnson-Cook", {369e6, 684e6, 0.73, 0.0083, 1.7});
      metal.failure.d   = {{0.13, 0.13, -1.5, 0.011, 0.}};
      return metal;
    }();
    static const NamedChoices<Metal> table{
      {"custom", Metal()}, {ti_811.name, ti_811}, {ti_64.name, ti_64}, {al.name, al}, {al_2024.name, al_2024}};
    return table;
  }

  std::string source_of(const Metal &metal)
  {
    static const std::map<std::string, std::string> sources{
      {"Ti-8Al-1Mo-1V", "ASM data sheet MTA816, annealed: yield 930, ultimate 1000 MPa, elongation 12 %"},
      {"Ti-6Al-4V", "ASM data sheet MTP641, annealed: yield 880, ultimate 950 MPa, elongation 14 %, c_p 526.3 J/(kg "
                    "K), melting 1873 K"},
      {"Al 6061-T6", "ASM data sheet MA6061T6: yield 276, ultimate 310 MPa, elongation 12 % of a sheet of 1.6 mm"},
      {"Al 2024 Johnson-Cook",
       "Johnson-Cook constants and damage of an input deck; density, elasticity, c_p 875 J/(kg K) and melting 775 K of "
       "data sheets"}};
    return sources.at(metal.name);
  }
} // namespace birdstrike
