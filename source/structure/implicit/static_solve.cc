#include "structure/implicit/static_solve.h"
#include "structure/implicit/linear_solver.h"
#include "structure/implicit/stability.h"
#include <birdstrike/core/numerical_failure.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double       tolerance       = 1e-10; // of the forces, to the norm of loads and spin
    constexpr double       round_off       = 1e-7; // likewise: below it a norm that no longer falls is one of round-off
    constexpr unsigned int most_iterations = 30;
    constexpr unsigned int patience        = 8;     // iterations within which the norm must halve
    constexpr std::size_t  easy            = 5;     // residuals of a load step after which the next is longer
    constexpr unsigned int most_repetitions = 6;    // of steps with one tangent
    constexpr double       pays             = 0.3;  // what such a step may leave of the forces
    constexpr double       astray           = 1e3;  // what it leaves of them where Newton's method will not converge
    constexpr double       loosest          = 1e-3; // of the linear equations
    constexpr double       shortest_step    = 1. / 1024.; // of the load factor

    double norm_of(const std::vector<double> &v)
    {
      double sum = 0.;
      for (const double x : v)
        sum += x * x;
      return std::sqrt(sum);
    }

    /// One load step: from the accepted state to `step`.
    class Newton
    {
    public:
      Newton(Equilibrium &equilibrium, const double scale, const LinearSolverChoice linear_solver)
        : equilibrium(equilibrium), scale(scale), linear_solver(linear_solver)
      {
      }

      /// False where it does not converge. `step` is the guess, and the result.
      bool solve(std::vector<double> &step)
      {
        residuals.clear();
        why.clear();
        try
          {
            equilibrium.compute_forces(step, forces);
          }
        catch (const NumericalFailure &failure)
          {
            why = failure.what();
            return false;
          }
        for (unsigned int k = 0; k <= most_iterations; ++k)
          {
            const double norm = norm_of(forces) / scale;
            residuals.push_back(norm);
            if (!(norm < 1e10))
              return false;
            if (norm < tolerance || (norm < round_off && k > 0 && norm > 0.5 * residuals[k - 1]))
              return true;
            if (k == most_iterations || (k >= patience && norm > 0.5 * residuals[k - patience]) || !improve(step))
              return norm < round_off;
          }
        return false;
      }

      std::vector<double> residuals;
      std::size_t         n_linear_iterations = 0;
      std::string         why; ///< what has gone wrong last, empty where forces were only left over

    private:
      /// A step of Newton's, as long as it makes the forces smaller, and steps with the same tangent while they pay.
      bool improve(std::vector<double> &step)
      {
        why.clear();
        std::unique_ptr<LinearSolver> solver;
        try
          {
            solver = make_linear_solver(linear_solver, equilibrium.compute_tangent(step), equilibrium);
            solver->solve(forces, inner_tolerance(residuals.back()), correction);
          }
        catch (const NumericalFailure &failure)
          {
            why = failure.what();
            return false; // singular, or an element on the point of turning inside out
          }
        // steps of bending make membrane forces that the next ones take away: the norm may grow for a while
        const double most      = residuals.size() < 3 ? 1e4 : residuals.size() < 8 ? 30. : 1.;
        bool         is_better = false;
        for (double length = 1.; length > 0.05 && !is_better; length *= 0.5)
          is_better = try_step(step, length, most) < most;
        is_better = is_better && repeat(*solver, step);
        n_linear_iterations += solver->n_iterations;
        return is_better;
      }

      /// What a step of bending has left over in the membrane is as stiff as it was before the step, and needs no new
      /// tangent (Shamanskii 1967). False where such a step shows that the load step's first has gone astray.
      bool repeat(LinearSolver &solver, std::vector<double> &step)
      {
        try
          {
            double norm = norm_of(forces) / scale;
            for (unsigned int k = 0; k < most_repetitions && norm > tolerance; ++k)
              {
                solver.solve(forces, 0.1 * pays, correction);
                if (const double left = try_step(step, 1., pays); left >= pays)
                  return residuals.size() > 1 || left < astray;
                norm = norm_of(forces) / scale;
              }
          }
        catch (const NumericalFailure &)
          {
          } // of the linear equations: the step before stands
        return true;
      }

      /// Goes a share of the correction if that leaves less than `most` times the forces. Returns what it would leave.
      double try_step(std::vector<double> &step, const double length, const double most)
      {
        tried.resize(step.size());
        for (std::size_t i = 0; i < step.size(); ++i)
          tried[i] = step[i] + length * correction[i];
        try
          {
            equilibrium.compute_forces(tried, forces_there);
          }
        catch (const NumericalFailure &failure)
          {
            why = failure.what();
            return INFINITY;
          }
        const double left = norm_of(forces_there) / norm_of(forces);
        if (left < most)
          {
            step.swap(tried);
            forces.swap(forces_there);
          }
        return std::isnan(left) ? INFINITY : left;
      }

      /// As the forces fall, so that Newton's method stays quadratic (Eisenstat & Walker 1996, SIAM J. Sci. Comput. 17,
      /// 16), but no tighter than what is wanted of them.
      static double inner_tolerance(const double norm)
      {
        return std::max(std::min(loosest, 0.1 * norm), 0.1 * tolerance / norm);
      }

      Equilibrium        &equilibrium;
      double              scale;
      LinearSolverChoice  linear_solver;
      std::vector<double> forces, forces_there, correction, tried;
    };

    FailureFacts describe_end(const double factor, const Newton &newton)
    {
      FailureFacts facts;
      facts.what = fmt::format("Static solve: no equilibrium beyond {:.4g} of loads and spin", factor);
      if (!newton.residuals.empty())
        facts.what += fmt::format(" (forces left over: {:.2g} of theirs)", newton.residuals.back());
      if (!newton.why.empty())
        facts.details = "The last attempt ended with: " + newton.why.substr(0, newton.why.find('\n'));
      facts.advice = "The blade buckles, flows without bound, fails or is not constrained. Try 'birdstrike static' "
                     "with smaller loads.";
      return facts;
    }
  } // namespace

  StaticReport solve_static(Equilibrium &equilibrium, const unsigned int n_load_steps,
                            const LinearSolverChoice linear_solver)
  {
    StaticReport report;
    const double scale = equilibrium.load_norm();
    if (scale == 0.)
      return report;
    Newton              newton(equilibrium, scale, linear_solver);
    double              factor = 0., length = 1. / n_load_steps;
    std::vector<double> step(equilibrium.unknowns().size(), 0.);
    double              last_length = 0.;
    while (factor < 1.)
      {
        const double to = factor + length > 1. - 1e-9 ? 1. : factor + length;
        for (double &x : step)
          x *= last_length > 0. ? (to - factor) / last_length : 0.;
        equilibrium.set_load_factor(to);
        const bool was_guessed = last_length > 0.;
        bool       is_solved   = newton.solve(step);
        if (!is_solved && was_guessed)
          {
            std::fill(step.begin(), step.end(), 0.);
            is_solved = newton.solve(step);
          }
        if (!is_solved)
          {
            length *= 0.5;
            last_length = 0.;
            if (length < shortest_step)
              throw NumericalFailure(describe_end(factor, newton));
            continue;
          }
        if (to == 1.)
          report.n_unstable = count_unstable(equilibrium, step, linear_solver);
        equilibrium.accept(step);
        report.n_iterations += newton.residuals.size() - 1;
        report.residuals = newton.residuals;
        ++report.n_load_steps;
        last_length = to - factor;
        factor      = to;
        if (newton.residuals.size() <= easy)
          length *= 2.;
      }
    report.n_linear_iterations = newton.n_linear_iterations;
    report.n_unknowns          = equilibrium.unknowns().size();
    return report;
  }
} // namespace birdstrike
