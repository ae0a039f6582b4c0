#include "blade_case.h"

#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "structure/implicit/symmetric_solver.h"

// Equilibria that cannot be: beyond Euler's loads, and beyond critical speeds.
namespace birdstrike::stability_test
{
  namespace
  {
    constexpr double length = 0.3, chord = 0.02, thickness = 0.002, density = 2700., young = 70e9;
    constexpr double stiffness = young * chord * thickness * thickness * thickness / 12.; // E I, N m^2
    constexpr double euler     = std::numbers::pi * std::numbers::pi * stiffness / (4. * length * length);

    BladeParameters strip(const BladeKind kind = BladeKind::shell)
    {
      BladeParameters p  = test::elastic_plate(40, 2);
      p.kind             = kind;
      p.mesh.length      = length;
      p.mesh.chord       = chord;
      p.thickness.value  = std::to_string(thickness);
      p.material.density = "2700";
      p.material.young   = "70e9";
      p.material.poisson = "0";
      if (kind == BladeKind::solid)
        {
          p.mesh.n_layers       = 1;
          p.element.formulation = element_formulations().at("solid-shell");
        }
      return p;
    }

    /// Pressed along its span by a share of Euler's load, at the three nodes of its tip.
    BladeParameters column(const double share, const LinearSolverChoice linear_solver)
    {
      BladeParameters p = strip();
      for (const auto &[y, part] : {std::pair(-0.01, 0.25), {0., 0.5}, {0.01, 0.25}})
        p.loads.point_loads +=
          fmt::format("{}0.3 {} 0: {}; 0; 0", p.loads.point_loads.empty() ? "" : "|", y, -part * share * euler);
      p.spin.linear_solver = linear_solver;
      return p;
    }

    std::size_t count(const BladeParameters &p)
    {
      ThreadPool pool(1);
      return make_blade(p, pool)->find_equilibrium().n_unstable.value();
    }

    /// The rate s (1/s) at which a column buckles under P = 2 P_Euler: E I w'''' + P w'' + rho A s^2 w = 0, w = w' = 0
    /// at the root, w'' = 0 and E I w''' + P w' = 0 at the tip. By shooting from the root with w'' = 1 and w''' = 1.
    double growth_rate()
    {
      constexpr double p = 0.5 * std::numbers::pi * std::numbers::pi; // P L^2/(E I)
      using State        = Eigen::Vector4d;                           // w and its derivatives
      const auto end     = [p](State y, const double square) {        // square: s^2 rho A L^4/(E I)
        constexpr int    n = 1000;
        constexpr double h = 1. / n;
        const auto       f = [&](const State &at) { return State(at[1], at[2], at[3], -p * at[2] - square * at[0]); };
        for (int k = 0; k < n; ++k)
          {
                const State one = f(y), two = f(y + 0.5 * h * one), three = f(y + 0.5 * h * two), four = f(y + h * three);
                y += h / 6. * (one + 2. * two + 2. * three + four);
          }
        return y;
      };
      const auto determinant = [&](const double square) {
        const State u = end({0., 0., 1., 0.}, square), v = end({0., 0., 0., 1.}, square);
        return u[2] * (v[3] + p * v[1]) - v[2] * (u[3] + p * u[1]);
      };
      double low = 0., high = 100.;
      for (int k = 0; k < 60; ++k)
        {
          const double middle                                        = 0.5 * (low + high);
          (determinant(middle) * determinant(low) > 0. ? low : high) = middle;
        }
      return std::sqrt(low * stiffness / (density * chord * thickness)) / (length * length);
    }
  } // namespace

  // Tridiagonal (-1, 2 - s, -1) of n has the eigenvalues 2 - 2 cos(k pi/(n + 1)) - s: as many negative pivots as of
  // them lie below zero.
  TEST(SymmetricSolver, CountsNegativeEigenvaluesAndSolves)
  {
    constexpr std::uint32_t n = 40;
    for (const double s : {-0.1, 0.01, 0.3, 2.1, 4.1})
      {
        SparseRows  matrix{{0}, {}, {}};
        std::size_t expected = 0;
        for (std::uint32_t row = 0; row < n; ++row)
          {
            for (std::uint32_t c = row == 0 ? 0 : row - 1; c <= std::min(row + 1, n - 1); ++c)
              {
                matrix.column.push_back(c);
                matrix.value.push_back(c == row ? 2. - s : -1.);
              }
            matrix.begin.push_back(matrix.column.size());
            expected += 2. - 2. * std::cos((row + 1.) * std::numbers::pi / (n + 1.)) < s;
          }
        SymmetricSolver     solver(matrix);
        std::vector<double> right(n), x;
        for (std::uint32_t row = 0; row < n; ++row)
          right[row] = std::sin(row + 1.);
        solver.solve(right, 0., x);
        EXPECT_EQ(solver.n_negative(), expected) << s;
        for (std::uint32_t row = 0; row < n; ++row)
          EXPECT_NEAR((2. - s) * x[row] - (row > 0 ? x[row - 1] : 0.) - (row + 1 < n ? x[row + 1] : 0.), right[row],
                      1e-10);
      }
  }

  // Euler's loads of a cantilever are (2 k - 1)^2 of the first: at 10 of them two directions are unstable, at 30 three.
  TEST(Stability, OfAColumnEndsAtEulersLoads)
  {
    for (const auto &[share, n] : {std::pair(0.99, 0U), {1.02, 1U}, {2., 1U}, {8.8, 1U}, {9.3, 2U}, {26., 3U}})
      EXPECT_EQ(count(column(share, LinearSolverChoice::direct)), n) << share;
  }

  TEST(Stability, IsFoundByMultigridToo)
  {
    for (const auto &[share, n] : {std::pair(0.99, 0U), {1.02, 1U}, {2., 1U}})
      EXPECT_EQ(count(column(share, LinearSolverChoice::multigrid)), n) << share;
  }

  // Modes: the column of 2 P_Euler grows, and vibrates in none of its first bending; the others stay vibrations. 1 %:
  // 40 elements, and what the load shortens.
  TEST(Stability, UnstableModesGrowAtTheRateOfABeam)
  {
    for (const auto linear_solver : {LinearSolverChoice::direct, LinearSolverChoice::multigrid})
      {
        ThreadPool pool(1);
        const auto blade = make_blade(column(2., linear_solver), pool);
        blade->find_equilibrium();
        const auto modes = blade->compute_modes(4).modes;
        ASSERT_EQ(modes.size(), 4U);
        EXPECT_TRUE(modes[0].is_unstable());
        EXPECT_EQ(modes[0].frequency, 0.);
        EXPECT_NEAR(modes[0].growth_rate / growth_rate(), 1., 0.01);
        for (std::size_t k = 1; k < 4; ++k)
          {
            EXPECT_FALSE(modes[k].is_unstable()) << k;
            EXPECT_GT(modes[k].frequency, 50.) << k;
          }
      }
  }

  // At 30 P_Euler three modes grow, and all of them come before what vibrates, however few are asked for.
  TEST(Stability, NoUnstableModeIsMissed)
  {
    for (const auto linear_solver : {LinearSolverChoice::direct, LinearSolverChoice::multigrid})
      {
        ThreadPool pool(1);
        const auto blade = make_blade(column(26., LinearSolverChoice::direct), pool);
        blade->find_equilibrium();
        BladeParameters p     = column(26., linear_solver);
        const auto      modes = blade->compute_modes(5).modes;
        for (std::size_t k = 0; k < 5; ++k)
          EXPECT_EQ(modes[k].is_unstable(), k < 3) << k;
        EXPECT_GT(modes[0].growth_rate, modes[1].growth_rate);
        EXPECT_GT(modes[1].growth_rate, modes[2].growth_rate);
      }
  }

  // A strip that spins about its own span has no tension: its stiffness is k - m w^2, and its equilibrium ends at its
  // first frequency, 1.8751^2 sqrt(E I/(rho A))/L^2.
  TEST(Stability, OfAStripAboutItsSpanEndsAtItsFrequency)
  {
    const double first = 1.875104 * 1.875104 * std::sqrt(stiffness / (density * chord * thickness)) / (length * length);
    for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
      for (const double share : {0.99, 1.01})
        {
          BladeParameters p = strip(kind);
          p.spin.speed      = fmt::format("{:.17g}", share * first);
          p.spin.axis       = {1., 0., 0.};
          EXPECT_EQ(count(p), share < 1. ? 0U : 1U) << share;
        }
  }

  // A blade on a hub is held by its tension at any speed. The tangent of a pressure that follows the plate is not
  // symmetric, and the sign of its symmetric part decides nothing: q L^3/(E I) = 8 bends the plate without buckling.
  TEST(Stability, OfTensionIsNotDoubtedAndOfFollowingPressureNotClaimed)
  {
    BladeParameters p = strip();
    p.spin.speed      = "1500";
    p.spin.axis       = {0., 0., 1.};
    EXPECT_EQ(count(p), 0U);
    p                = strip();
    p.loads.pressure = fmt::format("{}", 8. * stiffness / (length * length * length * chord));
    ThreadPool pool(1);
    EXPECT_EQ(make_blade(p, pool)->find_equilibrium().n_unstable.value_or(0), 0U);
  }
} // namespace birdstrike::stability_test
