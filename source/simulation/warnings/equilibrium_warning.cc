#include "simulation/warnings/equilibrium_warning.h"

#include <fmt/format.h>

namespace birdstrike
{
  std::string describe_stability(const StaticReport &report)
  {
    if (!report.n_unstable)
      return "not known";
    const std::size_t n = *report.n_unstable;
    return n == 0 ? "stable" : fmt::format("unstable in {} direction{}", n, n == 1 ? "" : "s");
  }

  void check_equilibrium(const StaticReport &report, const bool turns, Warnings &warnings)
  {
    if (report.n_unknowns == 0 || report.n_unstable == std::size_t(0))
      return;
    if (!report.n_unstable)
      warnings.push_back(
        {"blade/stability_unknown",
         "The stability of the static equilibrium is not known. The stiffness of the loaded blade is nearly singular, "
         "or pressures that follow the surface make it unsymmetric. Check the motion with 'birdstrike run'."});
    else
      warnings.push_back(
        {"blade/unstable_equilibrium",
         fmt::format("The static equilibrium is {}: the stiffness of the loaded blade is negative there. The blade "
                     "buckles before it carries these loads, and leaves this position at the least disturbance. "
                     "'birdstrike modes' shows the directions. Lower the loads or the speed. Or give the mesh the "
                     "imperfection of the real part: then the static solve finds the bent equilibrium.{}",
                     describe_stability(report),
                     turns ? " Coriolis' forces, which the static solve leaves out, can hold pairs of such directions."
                           : "")});
  }
} // namespace birdstrike
