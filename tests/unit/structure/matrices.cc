#include "matrices.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>

#include <cmath>

namespace birdstrike::test
{
  SparseMatrix make_square(const std::size_t n, const Entries &entries)
  {
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd &A)
  {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
  }

  Eigen::Vector3d symmetric_eigenvalues(const Matrix3<double> &A)
  {
    return Eigen::SelfAdjointEigenSolver<Matrix3<double>>(A, Eigen::EigenvaluesOnly).eigenvalues();
  }

  Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M)
  {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M, Eigen::EigenvaluesOnly).eigenvalues();
  }

  double largest_eigenvalue(const Eigen::MatrixXd &K, const Eigen::VectorXd &m)
  {
    Eigen::VectorXd scale(m.size());
    for (Eigen::Index d = 0; d < m.size(); ++d)
      scale[d] = 1. / std::sqrt(m[d]);
    const Eigen::MatrixXd scaled = scale.asDiagonal() * symmetric_part(K) * scale.asDiagonal();
    return symmetric_eigenvalues(scaled).maxCoeff();
  }

  Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd &A)
  {
    return 0.5 * (A + A.transpose());
  }

  SparseMatrix symmetric_part(const SparseMatrix &A)
  {
    return 0.5 * (A + SparseMatrix(A.transpose()));
  }

  Eigen::VectorXd solve(const Eigen::MatrixXd &K, const Eigen::VectorXd &f)
  {
    return K.ldlt().solve(f);
  }

  Eigen::VectorXd solve(const SparseMatrix &K, const Eigen::VectorXd &f)
  {
    const Eigen::SimplicialLDLT<SparseMatrix> solver(K);
    return solver.solve(f);
  }

  Eigen::MatrixXd divide_components(const Eigen::MatrixXd &K, const Eigen::MatrixXd &M)
  {
    const Eigen::LLT<Eigen::MatrixXd> inverse(M);
    const Eigen::Index                n = M.rows();
    Eigen::MatrixXd                   A(K.rows(), K.cols());
    for (Eigen::Index column = 0; column < A.cols(); ++column)
      for (int d = 0; d < 3; ++d)
        {
          Eigen::VectorXd of_axis(n);
          for (Eigen::Index i = 0; i < n; ++i)
            of_axis[i] = K(3 * i + d, column);
          of_axis = inverse.solve(of_axis);
          for (Eigen::Index i = 0; i < n; ++i)
            A(3 * i + d, column) = of_axis[i];
        }
    return A;
  }

  Eigen::VectorXd lowest_eigenvalues(const SparseMatrix &K, Eigen::MatrixXd X, const unsigned int n_iterations)
  {
    const Eigen::SimplicialLDLT<SparseMatrix> solver(K);
    Eigen::VectorXd                           values;
    for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        X = solver.solve(X).eval();
        X = X.householderQr().householderQ() * Eigen::MatrixXd::Identity(X.rows(), X.cols());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(X.transpose() * (K * X));
        X      = X * small.eigenvectors();
        values = small.eigenvalues();
      }
    return values;
  }

  Eigen::VectorXd lowest_eigenvalues(const SparseMatrix &K, const SparseMatrix &M, Eigen::MatrixXd X,
                                     const unsigned int n_iterations)
  {
    const Eigen::SimplicialLDLT<SparseMatrix> solver(K);
    Eigen::VectorXd                           values;
    for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        X = solver.solve(M * X).eval();
        X = X.householderQr().householderQ() * Eigen::MatrixXd::Identity(X.rows(), X.cols());
        const Eigen::MatrixXd small_K = X.transpose() * (K * X), small_M = X.transpose() * (M * X);
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(small_K, small_M);
        X      = X * small.eigenvectors();
        values = small.eigenvalues();
      }
    return values;
  }
} // namespace birdstrike::test
