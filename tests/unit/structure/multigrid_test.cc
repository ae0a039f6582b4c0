#include "blade_case.h"

#include "structure/implicit/multigrid_solver.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <memory>

namespace birdstrike::multigrid_test
{
  namespace
  {
    struct Formulation
    {
      const char *kind, *name;
    };
    constexpr std::array<Formulation, 5> formulations{{{"shell", "physical"},
                                                       {"shell", "fully integrated"},
                                                       {"solid", "one point"},
                                                       {"solid", "solid-shell"},
                                                       {"solid", "B-bar"}}};

    /// A plate under pressure on a hub that turns.
    BladeParameters loaded(const Formulation &formulation, const unsigned int n_span, const unsigned int n_chord)
    {
      BladeParameters p     = test::elastic_plate(n_span, n_chord);
      p.kind                = blade_kinds().at(formulation.kind);
      p.element.formulation = element_formulations().at(formulation.name);
      p.mesh.n_layers       = formulation.name == std::string("solid-shell") ? 1 : 2;
      p.spin.axis           = {0., 1., 0.};
      p.spin.speed          = "300";
      p.spin.n_load_steps   = 1; // what forms of increments make of a state depends on them in the fifth digit
      p.loads.pressure      = "1e3*(1 + 5*y)";
      p.probes              = "corner: 0.3112 0.04445 0; inside: 0.15 0.04 0";
      return p;
    }

    /// A blade in equilibrium, with its threads.
    struct Solved
    {
      std::unique_ptr<ThreadPool> pool;
      std::unique_ptr<Blade>      blade;

      Blade *operator->() const
      {
        return blade.get();
      }
    };

    Solved solve(BladeParameters p, const LinearSolverChoice linear_solver, const unsigned int n_threads = 1)
    {
      p.spin.linear_solver = linear_solver;
      Solved solved{std::make_unique<ThreadPool>(n_threads), nullptr};
      solved.blade = make_blade(p, *solved.pool);
      solved->find_equilibrium();
      return solved;
    }

    std::vector<double> displacements(const Solved &blade)
    {
      std::vector<double> result;
      for (const ProbeValues &probe : blade->probes())
        result.insert(result.end(), probe.displacement.begin(), probe.displacement.end());
      return result;
    }

    void expect_same_equilibrium(const BladeParameters &p, const char *name)
    {
      const auto direct = solve(p, LinearSolverChoice::direct), multigrid = solve(p, LinearSolverChoice::multigrid);
      EXPECT_EQ(direct->static_report().n_linear_iterations, 0u) << name;
      EXPECT_GT(multigrid->static_report().n_linear_iterations, 0u) << name;
      const auto   exact = displacements(direct), found = displacements(multigrid);
      const double size = std::abs(*std::max_element(
        exact.begin(), exact.end(), [](const double a, const double b) { return std::abs(a) < std::abs(b); }));
      EXPECT_EQ(multigrid->static_report().n_load_steps, direct->static_report().n_load_steps) << name;
      EXPECT_GT(size, 1e-4) << name;
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(found[i], exact[i], 1e-7 * size) << name << ' ' << i;
      EXPECT_NEAR(multigrid->root_section().bending_moment / direct->root_section().bending_moment, 1., 1e-7) << name;
    }

    VibrationModes modes_of(const BladeParameters &p, const LinearSolverChoice linear_solver, const std::size_t n)
    {
      return solve(p, linear_solver)->compute_modes(n);
    }
  } // namespace

  // A chain of springs; a right-hand side of which one entry is no number is no solution, wherever it stands.
  TEST(Multigrid, DoesNotTakeWhatIsNoNumberForSolved)
  {
    constexpr std::uint32_t          n_nodes = 20, n = 3 * n_nodes;
    const FreeUnknowns               unknowns(std::vector<bool>(n, false), n_nodes, {});
    std::vector<std::vector<double>> motions(6, std::vector<double>(n, 0.));
    for (std::uint32_t k = 0; k < n; ++k)
      motions[k % 3][k] = 1.;
    SparseRows matrix{{0}, {}, {}};
    for (std::uint32_t row = 0; row < n; ++row)
      {
        for (const int offset : {-3, 0, 3})
          if (const int column = static_cast<int>(row) + offset; column >= 0 && column < static_cast<int>(n))
            {
              matrix.column.push_back(static_cast<std::uint32_t>(column));
              matrix.value.push_back(offset == 0 ? 2.1 : -1.);
            }
        matrix.begin.push_back(matrix.column.size());
      }
    MultigridSolver     solver(Multigrid(std::move(matrix), unknowns, motions));
    std::vector<double> result;
    solver.solve(std::vector<double>(n, 1.), 1e-8, result);
    for (const std::uint32_t at : {0U, 31U, n - 1})
      {
        std::vector<double> right(n, 1.);
        right[at] = NAN;
        EXPECT_THROW(solver.solve(right, 1e-8, result), NumericalFailure) << at;
      }
  }

  TEST(Multigrid, FindsTheEquilibriumOfFactors)
  {
    for (const Formulation &formulation : formulations)
      expect_same_equilibrium(loaded(formulation, 16, 5), formulation.name);
  }

  TEST(Multigrid, FindsTheEquilibriumOfFactorsBeyondYield)
  {
    for (const Formulation &formulation : {formulations[0], formulations[3]})
      {
        BladeParameters p    = loaded(formulation, 16, 5);
        p.spin.n_load_steps  = 4;
        p.material.hardening = "linear";
        p.material.yield     = "24e6";
        p.material.modulus   = "5e9";
        EXPECT_GT(solve(p, LinearSolverChoice::multigrid)->peak_plastic_strains().front().value, 1e-4)
          << formulation.name;
        expect_same_equilibrium(p, formulation.name);
      }
  }

  // u = rho w^2 L^3/(3 E) of a rotating bar, as of factors.
  TEST(Multigrid, StretchesABar)
  {
    BladeParameters p  = test::elastic_plate(80, 2);
    p.material.poisson = "0";
    p.spin.speed       = "600";
    p.probes           = "tip: 0.3112 0 0";
    const double exact = 4430. * 600. * 600. * std::pow(0.3112, 3) / (3. * 113.8e9);
    EXPECT_NEAR(displacements(solve(p, LinearSolverChoice::multigrid))[0] / exact, 1., 2e-3);
  }

  TEST(Multigrid, FindsTheModesOfFactors)
  {
    for (const Formulation &formulation : formulations)
      {
        const BladeParameters p     = loaded(formulation, 20, 6);
        const auto            exact = modes_of(p, LinearSolverChoice::direct, 8),
                   found            = modes_of(p, LinearSolverChoice::multigrid, 8);
        ASSERT_EQ(found.modes.size(), exact.modes.size());
        for (std::size_t k = 0; k < exact.modes.size(); ++k)
          {
            EXPECT_NEAR(found.modes[k].frequency / exact.modes[k].frequency, 1., 1e-7) << formulation.name << k;
            EXPECT_GT(modal_assurance(found.modes[k].shape, exact.modes[k].shape), 1. - 1e-6) << formulation.name << k;
          }
      }
  }

  // Six rigid motions, then those that bend and twist.
  TEST(Multigrid, FindsTheModesOfABodyThatNothingHolds)
  {
    for (const char *kind : {"shell", "solid"})
      {
        BladeParameters p = test::free_plate(20, 6);
        p.kind            = blade_kinds().at(kind);
        const auto exact  = modes_of(p, LinearSolverChoice::direct, 10),
                   found  = modes_of(p, LinearSolverChoice::multigrid, 10);
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_LT(std::abs(found.modes[k].frequency), 1e-3 * exact.modes[6].frequency) << kind << k;
        for (std::size_t k = 6; k < 10; ++k)
          EXPECT_NEAR(found.modes[k].frequency / exact.modes[k].frequency, 1., 1e-6) << kind << k;
      }
  }

  // Partly held nodes have fewer unknowns than others: hinges, and a plane of symmetry.
  TEST(Multigrid, TakesPartlyHeldNodes)
  {
    for (const char *kind : {"shell", "solid"})
      {
        BladeParameters p  = test::elastic_plate(24, 8);
        p.kind             = blade_kinds().at(kind);
        p.supports.clamped = "";
        p.supports.held    = "0: hinged; 1: uz; 2: uy";
        const auto exact   = modes_of(p, LinearSolverChoice::direct, 5),
                   found   = modes_of(p, LinearSolverChoice::multigrid, 5);
        for (std::size_t k = 0; k < 5; ++k)
          EXPECT_NEAR(found.modes[k].frequency / exact.modes[k].frequency, 1., 1e-8) << kind << k;
      }
  }

  // A small load: the equations of the first tangent, on meshes of up to sixteen times the unknowns.
  TEST(Multigrid, NeedsAsManyIterationsOnFinerMeshes)
  {
    for (const Formulation &formulation : formulations)
      {
        std::vector<double> iterations;
        for (const unsigned int n : {1u, 2u, 4u})
          {
            BladeParameters p   = loaded(formulation, 20 * n, 6 * n);
            p.spin.speed        = "0";
            p.spin.n_load_steps = 1;
            p.loads.pressure    = "1";
            const auto blade    = solve(p, LinearSolverChoice::multigrid);
            const auto report   = blade->static_report();
            iterations.push_back(static_cast<double>(report.n_linear_iterations));
          }
        EXPECT_LT(iterations[2], 1.5 * iterations[0]) << formulation.name;
      }
  }

  TEST(Multigrid, GivesTheSameBitsAgainAndWithThreads)
  {
    const BladeParameters p     = loaded(formulations[0], 16, 5);
    const auto            first = displacements(solve(p, LinearSolverChoice::multigrid));
    EXPECT_TRUE(test::is_bitwise_equal(first, displacements(solve(p, LinearSolverChoice::multigrid))));
    EXPECT_TRUE(test::is_bitwise_equal(first, displacements(solve(p, LinearSolverChoice::multigrid, 3))));
    const auto once  = modes_of(p, LinearSolverChoice::multigrid, 4),
               again = modes_of(p, LinearSolverChoice::multigrid, 4);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_TRUE(test::is_bitwise_equal(once.modes[k].shape, again.modes[k].shape));
  }

  TEST(Multigrid, SaysWhatToDoWhereItFails)
  {
    BladeParameters p = test::free_plate(12, 4); // nothing holds it against the pressure
    p.loads.pressure  = "1e3";
    try
      {
        solve(p, LinearSolverChoice::multigrid);
        FAIL() << "an equilibrium of a body that flies away";
      }
    catch (const NumericalFailure &failure)
      {
        EXPECT_NE(std::string(failure.what()).find("Static solve"), std::string::npos) << failure.what();
        EXPECT_NE(std::string(failure.what()).find("constrained"), std::string::npos) << failure.what();
      }
  }
} // namespace birdstrike::multigrid_test
