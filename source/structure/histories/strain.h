#pragma once

#include <birdstrike/core/number.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace birdstrike
{
  /// Hencky's logarithmic strain E = ln V = 1/2 ln(F F^T) of a deformation gradient F = dx/dX: components xx, yy, zz,
  /// xy, yz, zx of the tensor (shear: half the engineering strain), in global axes. It turns with the body, is zero in
  /// rigid motion however large, and adds up along an axis (ln of the stretch).
  inline std::array<double, 6> logarithmic_strain(const Matrix3<double> &F)
  {
    const Eigen::SelfAdjointEigenSolver<Matrix3<double>> solver(Matrix3<double>(F * F.transpose()));
    const Point3                                         logs = 0.5 * solver.eigenvalues().array().log().matrix();
    const Matrix3<double> E = solver.eigenvectors() * logs.asDiagonal() * solver.eigenvectors().transpose();
    return {E(0, 0), E(1, 1), E(2, 2), E(0, 1), E(1, 2), E(2, 0)};
  }

  /// A quadrilateral patch of a surface, corners in order round it: the derivatives of its bilinear map at the middle,
  /// in the coordinates -1..1.
  struct Tangents
  {
    Point3 first, second;

    static Tangents of(const std::array<Point3, 4> &x)
    {
      return {0.25 * (x[1] + x[2] - x[0] - x[3]), 0.25 * (x[2] + x[3] - x[0] - x[1])};
    }
    Point3 normal() const
    {
      return first.cross(second).normalized();
    }
  };
} // namespace birdstrike
