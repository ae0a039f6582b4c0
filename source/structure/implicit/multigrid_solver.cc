#include "structure/implicit/multigrid_solver.h"
#include <birdstrike/core/numerical_failure.h>

#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    constexpr unsigned int most_iterations = 300;
    constexpr unsigned int n_vectors       = 100; // until the method begins anew

    struct Product
    {
      const Multigrid &multigrid;

      void vmult(Vector &to, const Vector &from) const
      {
        multigrid.multiply(from.begin(), to.begin());
      }
    };

    struct Cycle
    {
      const Multigrid &multigrid;

      void vmult(Vector &to, const Vector &from) const
      {
        multigrid.precondition(from.begin(), to.begin());
      }
    };
  } // namespace

  void MultigridSolver::solve(const std::span<const double> right, const double tolerance, std::vector<double> &result)
  {
    const std::vector<double> &scale = multigrid.scale();
    Vector                     b(scale.size()), x(scale.size());
    for (std::size_t k = 0; k < scale.size(); ++k)
      b[k] = scale[k] * right[k];
    const double                size = b.l2_norm();
    dealii::SolverControl       control(most_iterations, tolerance * size, false, false);
    dealii::SolverGMRES<Vector> gmres(control, dealii::SolverGMRES<Vector>::AdditionalData(n_vectors + 2, true));
    try
      {
        gmres.solve(Product{multigrid}, x, b, Cycle{multigrid});
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        throw NumericalFailure(fmt::format(
          "Static solve: multigrid leaves {:.2g} of the right-hand side after {} iterations (wanted: {:.2g}).\nSet "
          "Blade/Spin/Linear solver to direct if memory allows, or check the mesh: are its elements slivers?",
          control.last_value() / size, control.last_step(), tolerance));
      }
    n_iterations += control.last_step();
    result.resize(scale.size());
    for (std::size_t k = 0; k < scale.size(); ++k)
      result[k] = scale[k] * x[k];
  }
} // namespace birdstrike
