#include "material/hardening_laws.h"

#include "material/metal_table.h"
#include <birdstrike/material/metal_constants.h>
#include <birdstrike/material/metal_parameters.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace birdstrike
{
  namespace
  {
    /// The shortest text that is read as the same number.
    std::string text_of(const double value)
    {
      std::array<char, 32> text;
      return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
    }

    struct Entry
    {
      std::string        name;
      const std::string *text;
    };

    /// By the keys of constants_in_use.
    std::map<std::string, Entry> entries_of(const MetalParameters &p)
    {
      std::map<std::string, Entry> entries{{"density", {"Density", &p.density}},
                                           {"youngs_modulus", {"Young's modulus", &p.young}},
                                           {"poissons_ratio", {"Poisson's ratio", &p.poisson}},
                                           {"yield_stress", {"Yield stress", &p.yield}},
                                           {"hardening_modulus", {"Hardening modulus", &p.modulus}},
                                           {"hardening_exponent", {"Hardening exponent", &p.exponent}},
                                           {"hardening_strain", {"Hardening strain", &p.strain}},
                                           {"rate_factor", {"Rate factor", &p.rate_factor}},
                                           {"reference_rate", {"Reference rate", &p.reference_rate}},
                                           {"softening_exponent", {"Softening exponent", &p.softening_exponent}},
                                           {"heat_capacity", {"Heat capacity", &p.heat_capacity}},
                                           {"melting_temperature", {"Melting temperature", &p.melting_temperature}}};
      for (std::size_t k = 0; k < p.failure.d.size(); ++k)
        entries["failure_d" + std::to_string(k + 1)] = {"Damage D" + std::to_string(k + 1), &p.failure.d[k]};
      return entries;
    }
  } // namespace

  std::vector<MetalParameters::UsedValue> MetalParameters::used_values(const std::string &where) const
  {
    const Metal metal   = this->metal(where);
    Metal       plain   = metal_table().at(name);
    const bool  has_law = plain.hardening.law == metal.hardening.law;
    plain.hardening.law = metal.hardening.law;
    plain.failure.law   = metal.failure.law;
    if (!is_adiabatic)
      plain.hardening.heat_capacity = 0.;
    const std::vector<MetalConstant> of_table =
      name == "custom" ? std::vector<MetalConstant>{} : constants_in_use(plain);

    std::vector<UsedValue> used{
      {"Hardening", hardening_name(metal), hardening == "table", has_law && !of_table.empty()}};
    const std::map<std::string, Entry> entries = entries_of(*this);
    for (const MetalConstant &constant : constants_in_use(metal))
      if (const auto entry = entries.find(constant.key); entry != entries.end())
        used.push_back({entry->second.name, text_of(constant.value), *entry->second.text == "table",
                        std::any_of(of_table.begin(), of_table.end(), [&](const MetalConstant &other) {
                          return other.key == constant.key && other.value == constant.value;
                        })});
    return used;
  }
} // namespace birdstrike
