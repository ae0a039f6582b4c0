#pragma once

#include <birdstrike/core/number.h>

#include <Eigen/SparseCore>

#include <vector>

/// Linear algebra of several tests, compiled once for all of them.
namespace birdstrike::test
{
  using SparseMatrix = Eigen::SparseMatrix<double>;
  using Entries      = std::vector<Eigen::Triplet<double>>;

  SparseMatrix make_square(std::size_t n, const Entries &entries); ///< sums of entries of one place

  /// Of a symmetric matrix, of which the lower triangle is read; ascending.
  Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd &A);
  Eigen::Vector3d symmetric_eigenvalues(const Matrix3<double> &A);
  /// Of K x = value M x, both symmetric.
  Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M);

  /// The largest of the symmetric part of K x = value m x, m > 0 diagonal.
  double largest_eigenvalue(const Eigen::MatrixXd &K, const Eigen::VectorXd &m);

  Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd &A);
  SparseMatrix    symmetric_part(const SparseMatrix &A);

  /// K u = f, K symmetric.
  Eigen::VectorXd solve(const Eigen::MatrixXd &K, const Eigen::VectorXd &f);
  Eigen::VectorXd solve(const SparseMatrix &K, const Eigen::VectorXd &f);

  /// M^{-1} on each of the three components that rows of K have by node, M > 0.
  Eigen::MatrixXd divide_components(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M);

  /// Lowest eigenvalues of a symmetric matrix, and of K x = value M x: subspace iteration (Bathe 1971).
  Eigen::VectorXd lowest_eigenvalues(const SparseMatrix &K, Eigen::MatrixXd start, unsigned int n_iterations);
  Eigen::VectorXd lowest_eigenvalues(const SparseMatrix &K, const SparseMatrix &M, Eigen::MatrixXd start,
                                     unsigned int n_iterations);
} // namespace birdstrike::test
