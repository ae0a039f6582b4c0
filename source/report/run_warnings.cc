#include "report/run_warnings.h"
#include <birdstrike/contact/contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/run_view.h>
#include <birdstrike/report/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace birdstrike
{
  namespace
  {
    constexpr double much_energy_error = 0.01; ///< -, of the energy scale
    constexpr double much_hourglass    = 0.1;  ///< -, of the internal energy (usual limit: 5 to 10 %)
    constexpr double much_momentum     = 1e-4; ///< -: bookkeeping is right to round-off, friction's couple to 1e-5
    constexpr double much_lost         = 0.01; ///< -, of the energy scale, by contact's springs
    constexpr double deep              = 0.5;  ///< particle spacings
    constexpr double much_strain       = 0.05; ///< -, equivalent plastic: brittle metals break there

    void check_balance(const RunView &run, Warnings &warnings)
    {
      if (const double error = run.balance.energy_error().largest; error > much_energy_error)
        {
          const Balance::Origins                from      = run.balance.origins();
          const std::pair<const char *, double> origins[] = {
            {"the bird", from.bird}, {"the blade", from.blade}, {"contact", from.contact}, {"the steps", from.steps}};
          const auto most = std::max_element(std::begin(origins), std::end(origins), [](const auto &a, const auto &b) {
            return std::abs(a.second) < std::abs(b.second);
          });
          warnings.push_back({"balance/energy", "The energy balance was off by up to " + format_share(error) +
                                                  "; most of it, at the end, from " + most->first + " (" +
                                                  format_quantity(most->second, "J") + ")."});
        }
      for (const auto &[name, error] : {std::pair("momentum", run.balance.momentum_error().largest),
                                        std::pair("angular momentum", run.balance.angular_momentum_error().largest)})
        if (error > much_momentum)
          warnings.push_back({"balance/momentum", fmt::format("The balance of {} was off by {:.2g}.", name, error)});
      if (const double share = run.observed.hourglass_share.value(); share > much_hourglass)
        warnings.push_back({"balance/hourglass",
                            "Hourglass energy was up to " + format_share(share) +
                              " of the internal energy: refine the mesh, or set Blade/Element/Formulation to 'fully "
                              "integrated' or 'B-bar'."});
    }

    void check_peaks(const RunView &run, Warnings &warnings)
    {
      const Observed &of = run.observed;
      std::string     passed;
      for (const auto &[name, value, time, may_rise] :
           {std::tuple("tip deflection", of.tip_peak.value(), of.tip_peak.time(), run.may_deflect_further()),
            std::tuple("root normal stress", of.root_stress.value(), of.root_stress.time(), run.is_pushed()),
            std::tuple("root moment", of.root_moment.value(), of.root_moment.time(), run.is_pushed())})
        if (value != 0. && time >= run.time)
          warnings.push_back({"peak/not_reached", fmt::format("The largest {} is that at the end of the run, where it "
                                                              "still rises: no peak yet (Time/End time).",
                                                              name)});
        else if (value != 0. && may_rise)
          passed += (passed.empty() ? "" : ", ") + std::string(name);
      if (!passed.empty())
        warnings.push_back(
          {"peak/not_reached", fmt::format("The maxima so far ({}) may not be the peaks: at the end of the run the "
                                           "bird still loads the blade, or the tip has only swung back against it "
                                           "(Time/End time).",
                                           passed)});
    }

    struct BreakingStrain
    {
      double      value = INFINITY; ///< true strain, -
      const char *of    = "";
    };

    /// In a tensile test: by the elongation, else by Johnson and Cook's damage of slow flow at a triaxiality of 1/3 and
    /// room temperature, D1 + D2 exp(D3/3). Infinite where neither is known.
    BreakingStrain find_breaking_strain(const Metal &metal)
    {
      if (metal.elongation > 0.)
        return {std::log1p(metal.elongation), "elongation at break"};
      Failure damage          = metal.failure;
      damage.law              = FailureLaw::johnson_cook;
      const double in_tension = compute_failure_strain(damage, 1. / 3., 1., 0.);
      if (in_tension > Failure::smallest_strain) // else it has no constants
        return {in_tension, "failure strain in tension by Johnson and Cook's damage"};
      return {};
    }

    /// Of a metal that cannot fail here: whether it would have torn, and whether that can be told.
    void check_strain(const BladeParameters &of_section, const PeakPlasticStrain &most, Warnings &warnings)
    {
      const BreakingStrain breaking = find_breaking_strain(of_section.material.metal());
      const std::string    entry    = "Blade/" + BladeParameters::section_path(most.section) + "Material/";
      const std::string reached = fmt::format("Equivalent plastic strain reaches {:.3g} at ({:.4g}, {:.4g}, {:.4g}) m",
                                              most.value, most.position[0], most.position[1], most.position[2]);
      if (most.value > breaking.value)
        warnings.push_back(
          {"metal/elongation",
           fmt::format("{}, beyond the metal's {} ({:.3g} true strain): it may tear there, and no failure is set "
                       "({}Failure). At clamped edges the strain grows as the mesh is refined.",
                       reached, breaking.of, breaking.value, entry)});
      else if (std::isinf(breaking.value) && most.value > much_strain)
        warnings.push_back(
          {"metal/no_elongation", fmt::format("{}. Whether the metal tears there cannot be told: it has neither an "
                                              "elongation at break nor constants of failure ({}Elongation).",
                                              reached, entry)});
    }

    void check_metal(const RunView &run, Warnings &warnings)
    {
      const auto                               sections = run.parameters.blade.by_section();
      std::map<std::size_t, PeakPlasticStrain> most; // of a row the blade that is strained most
      for (const PeakPlasticStrain &peak : run.observed.plastic)
        if (const auto [found, is_new] = most.emplace(peak.section, peak); found->second.value < peak.value)
          found->second = peak;
      for (const auto &[number, peak] : most)
        if (const BladeParameters &of_section = sections.at(number);
            !of_section.is_laminate() && !of_section.material_can_fail())
          check_strain(of_section, peak, warnings);
      const FailureReport &failure = run.observed.failure;
      const auto           are_of  = [&](const bool plies) {
        return std::ranges::any_of(sections, [&](const auto &each) {
          return each.second.is_laminate() == plies && each.second.material_can_fail();
        });
      };
      if (failure.n_partly > 0)
        warnings.push_back(
          {"metal/partly_failed",
           fmt::format("{} elements still carry load with {} failed points, most of them in the element at ({:.4g}, "
                       "{:.4g}, {:.4g}) m. They do not count as failed elements (fields: failed_points). "
                       "Blade/{}/Failed share removes an element before its last {} fails.",
                       failure.n_partly, failure.n_points, failure.partly_at[0], failure.partly_at[1],
                       failure.partly_at[2],
                       are_of(true) ? (are_of(false) ? "Material or Laminate" : "Laminate") : "Material",
                       are_of(true) ? "point or ply" : "point")});
      if (failure.n_at_root > 0)
        warnings.push_back(
          {"metal/failed_at_root",
           fmt::format("{} elements at the root section have failed: root forces and stresses do not include them.",
                       failure.n_at_root)});
      if (failure.has_lost_tip)
        warnings.push_back(
          {"metal/lost_tip", "The tip deflection is that of nodes without elements, which fly freely."});
    }
  } // namespace

  Warnings find_run_warnings(const RunView &run)
  {
    Warnings warnings;
    check_balance(run, warnings);
    if (run.parameters.blade.is_deformable())
      {
        check_peaks(run, warnings);
        check_metal(run, warnings);
      }
    if (run.is_pushed())
      warnings.push_back(
        {unfinished_contact,
         "The bird still loads the blade at the end of the run: the mean contact force of the last 0.25 ms is " +
           format_quantity(run.closing_force(), "N") +
           ". Impulse, momentum and all that depends on them are not final (Time/End time)."});
    if (const double lost = run.contact ? run.contact->released_energy / run.balance.energy_scale() : 0.;
        lost > much_lost)
      warnings.push_back({"contact/released",
                          "Contact springs lost " + format_share(lost) +
                            " of the energy. Particles passed through or around a blade that is thinner than they are, "
                            "or elements below them failed. Smaller particles (Bird/Particle spacing) lose less."});
    if (const double depth = run.observed.contact.max_penetration_over_spacing(); depth > deep)
      warnings.push_back(
        {"contact/penetration", fmt::format("Particles penetrated the blade by up to {:.2g} spacings: contact was too "
                                            "soft for this strike (Contact/Stiffness scale).",
                                            depth)});
    return warnings;
  }
} // namespace birdstrike
