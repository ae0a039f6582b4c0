#pragma once

#include "shell_harness.h"

#include "structure/elements/shell/laminate/laminate.h"

/// Laminated shells: a ply, stacks of it, and classical lamination theory as the books write it.
namespace laminate_case
{
  using namespace shell_harness;

  Ply carbon(); ///< in epoxy
  /// In units of E2 = 1, as series and elasticity solutions are given.
  Ply of_ratio(double young, double shear_12, double shear_23);
  Ply isotropic(double young, double poisson, double density);

  std::vector<PlyLayer> equal_plies(const std::vector<double> &angles);

  ShellSection section_of(const Ply &ply, const std::vector<PlyLayer> &plies, ShellFormulation formulation,
                          const Point3 &reference = Point3::UnitX());
  ShellSection section_of(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies, ShellFormulation formulation);

  /// Jones, Mechanics of Composite Materials (1999), eqs 2.84 and 4.22-24: A (N/m), B (N), D (N m).
  struct ABD
  {
    Matrix3<double> A = Matrix3<double>::Zero(), B = A, D = A;
  };
  ABD lamination_theory(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies, double thickness);
  ABD lamination_theory(const Ply &p, const std::vector<PlyLayer> &plies, double thickness);
} // namespace laminate_case
