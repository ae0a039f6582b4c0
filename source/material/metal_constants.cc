#include "material/hardening_laws.h"
#include <birdstrike/material/metal_constants.h>

#include <fmt/core.h>

namespace birdstrike
{
  namespace
  {
    using Constants = std::vector<MetalConstant>;

    void add_hardening(const Hardening &h, Constants &all)
    {
      all.push_back({"yield_stress", "Pa", h.yield});
      switch (h.law)
        {
        case HardeningLaw::linear:
          all.push_back({"hardening_modulus", "Pa", h.modulus});
          break;
        case HardeningLaw::swift:
          all.push_back({"hardening_strain", "-", h.strain});
          all.push_back({"hardening_exponent", "-", h.exponent});
          break;
        case HardeningLaw::voce:
        case HardeningLaw::johnson_cook:
          all.push_back({"hardening_modulus", "Pa", h.modulus});
          all.push_back({"hardening_exponent", "-", h.exponent});
          break;
        case HardeningLaw::elastic:
        case HardeningLaw::perfect:
        case HardeningLaw::curve:
          break;
        }
      if (h.rate_law == RateLaw::cowper_symonds)
        {
          all.push_back({"cowper_symonds_rate", "1/s", h.reference_rate});
          all.push_back({"rate_exponent", "-", h.rate_exponent});
        }
      else if (h.rate_factor > 0.)
        {
          all.push_back({"rate_factor", "-", h.rate_factor});
          all.push_back({"reference_rate", "1/s", h.reference_rate});
        }
      if (h.heat_capacity > 0.)
        {
          all.push_back({"softening_exponent", "-", h.softening_exponent});
          all.push_back({"heat_capacity", "J/(kg K)", h.heat_capacity});
          all.push_back({"taylor_quinney", "-", h.taylor_quinney});
          all.push_back({"initial_temperature", "K", h.initial_temperature});
          all.push_back({"melting_temperature", "K", h.melting_temperature});
        }
    }
  } // namespace

  std::vector<MetalConstant> constants_in_use(const Metal &metal)
  {
    Constants all{{"density", "kg/m^3", metal.density},
                  {"youngs_modulus", "Pa", metal.elasticity.young},
                  {"poissons_ratio", "-", metal.elasticity.poisson}};
    if (metal.hardening.law != HardeningLaw::elastic)
      add_hardening(metal.hardening, all);
    if (metal.failure.law == FailureLaw::plastic_strain)
      all.push_back({"failure_strain", "-", metal.failure.plastic_strain});
    if (metal.failure.law == FailureLaw::johnson_cook)
      {
        for (std::size_t k = 0; k < metal.failure.d.size(); ++k)
          all.push_back({"failure_d" + std::to_string(k + 1), "-", metal.failure.d[k]});
        if (metal.failure.d[3] != 0.)
          all.push_back({"failure_reference_rate", "1/s", damage_reference_rate(metal.hardening)});
      }
    if (metal.elongation > 0.)
      all.push_back({"elongation", "-", metal.elongation});
    return all;
  }

  std::string hardening_name(const Metal &metal)
  {
    return hardening_laws().name(metal.hardening.law);
  }

  std::string describe(const Metal &metal)
  {
    const Hardening &h    = metal.hardening;
    std::string      text = fmt::format("{}: {:.5g} kg/m^3, E {:.5g} GPa, nu {:.4g}", metal.name, metal.density,
                                        1e-9 * metal.elasticity.young, metal.elasticity.poisson);
    if (h.law == HardeningLaw::elastic)
      return text + ", never yields";
    text += fmt::format(", yield {:.5g} MPa", 1e-6 * h.yield);
    if (h.law == HardeningLaw::perfect)
      text += ", no hardening";
    else if (h.law == HardeningLaw::curve)
      {
        const auto &last = h.curve.segments[h.curve.n_segments - 1];
        double      top  = h.yield;
        for (std::size_t k = 0; k < h.curve.n_segments; ++k)
          top += h.curve.segments[k].slope * h.curve.segments[k].length;
        text +=
          fmt::format(", by a curve to {:.5g} MPa at a plastic strain of {:.4g}", 1e-6 * top, last.begin + last.length);
      }
    else
      {
        text += ", " + hardening_name(metal) + " hardening";
        if (h.law != HardeningLaw::swift)
          text += fmt::format(" {:.5g} MPa", 1e-6 * h.modulus);
        if (h.law != HardeningLaw::linear)
          text += fmt::format(", exponent {:.4g}", h.exponent);
        if (h.law == HardeningLaw::swift)
          text += fmt::format(", strain {:.4g}", h.strain);
      }
    if (h.rate_law == RateLaw::cowper_symonds)
      text += fmt::format(", Cowper-Symonds {:.4g} 1/s, {:.4g}", h.reference_rate, h.rate_exponent);
    else
      text += h.rate_factor > 0. ? fmt::format(", rate {:.4g}", h.rate_factor) : ", no rate dependence";
    if (h.heat_capacity > 0.)
      text += ", softened by its heat";
    const std::string by_size = metal.failure.size_factors.n > 0 ? ", by the size of an element" : "";
    switch (metal.failure.law)
      {
      case FailureLaw::none:
        return text + ", does not fail";
      case FailureLaw::plastic_strain:
        return text + fmt::format(", fails at a plastic strain of {:.4g}", metal.failure.plastic_strain) + by_size;
      case FailureLaw::johnson_cook:
        break;
      }
    return text + ", fails by Johnson-Cook's damage" + by_size;
  }
} // namespace birdstrike
