#include "simulation/warnings/equilibrium_warning.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/structure/make_blade.h>

#include <fmt/format.h>

#include <regex>

namespace birdstrike
{
  namespace
  {
    /// A formula that is there and does not know the time.
    bool is_constant(const std::string &formula)
    {
      static const std::regex time("\\bt\\b");
      return is_present(formula) && !std::regex_search(formula, time);
    }
  } // namespace

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

  void check_constant_loads(const BladeParameters &parameters, const std::size_t n_nodes, Warnings &warnings)
  {
    constexpr std::size_t most_nodes = 20000; // some seconds
    if (Rotor(parameters.spin).turns() || n_nodes > most_nodes ||
        !(is_constant(parameters.loads.pressure) || is_constant(parameters.loads.point_loads)))
      return;
    try
      {
        ThreadPool         pool(1);
        const StaticReport report = make_blade(parameters, pool)->find_equilibrium();
        if (report.n_unstable > std::size_t(0))
          warnings.push_back(
            {"blade/unstable_equilibrium",
             fmt::format("The static equilibrium under the constant loads is {}: the blade buckles before it carries "
                         "them. A mesh without imperfection may stay straight in the run. Lower the loads, or give the "
                         "mesh the imperfection of the real part. 'birdstrike static' and 'modes' show more.",
                         describe_stability(report))});
      }
    catch (const InputError &) // a free blade has none, and a program may be built without the solver
      {
      }
    catch (const NumericalFailure &) // the loads are beyond any equilibrium: the run shows the motion
      {
      }
  }
} // namespace birdstrike
