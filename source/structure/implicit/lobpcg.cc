#include "structure/implicit/lobpcg.h"
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/core/simd/larger.h>

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace birdstrike
{
  namespace
  {
    using Eigen::Index;
    using Eigen::MatrixXd;
    using Eigen::VectorXd;

    constexpr double dependent       = 1e-12; // squared length below which a direction adds nothing to the others
    constexpr int    most_iterations = 300;

    /// Vectors, and K times them.
    struct Block
    {
      MatrixXd v, k;

      Block operator*(const MatrixXd &factors) const
      {
        return {v * factors, k * factors};
      }
    };

    class Lobpcg
    {
    public:
      Lobpcg(const Multigrid &stiffness, const std::vector<double> &masses, const std::size_t n, const double tolerance)
        : stiffness(stiffness), mass(masses.size()), wanted(static_cast<Index>(n)), tolerance(tolerance)
      {
        for (std::size_t i = 0; i < masses.size(); ++i)
          mass[i] = masses[i] * stiffness.scale()[i] * stiffness.scale()[i];
        begin(std::min(wanted + std::max<Index>(3, wanted / 3), mass.size() / 3));
      }

      Eigenpairs solve()
      {
        double left = 0.;
        for (int iteration = 0; iteration < most_iterations; ++iteration)
          {
            if (!values.allFinite())
              throw NumericalFailure("Modes: the stiffness of the loaded blade has an entry that is no number.");
            if (values[0] <= 0.)
              return {{values[0]}, {}, static_cast<std::size_t>(iteration)};
            const MatrixXd residual = x.k - mass.asDiagonal() * x.v * values.asDiagonal();
            Block          w{precondition(residual), {}};
            left = 0.;
            for (Index k = 0; k < wanted; ++k)
              left = larger(left, std::abs(residual.col(k).dot(w.v.col(k))) / values[k]);
            if (left < tolerance)
              return result(iteration);
            improve(std::move(w));
          }
        throw NumericalFailure(
          fmt::format("Modes: conjugate gradients have not converged in {} iterations (eigenvalues "
                      "to {:.1e}).\nAsk for another number of modes, or set Blade/Spin/Linear "
                      "solver to direct if memory allows.",
                      most_iterations, left));
      }

    private:
      void begin(const Index size)
      {
        std::mt19937 random; // the same in every run and library
        MatrixXd     start(mass.size(), size);
        for (double &value : start.reshaped())
          value = static_cast<double>(random()) / 4294967296. - 0.5;
        x = {std::move(start), {}}; // not preconditioned: of a free body that leaves rigid motions alone
        normalize(x);
        x.k = multiply(x.v);
        take_ritz(x);
      }

      MatrixXd multiply(const MatrixXd &v) const
      {
        MatrixXd product(v.rows(), v.cols());
        for (Index k = 0; k < v.cols(); ++k)
          stiffness.multiply(v.col(k).data(), product.col(k).data());
        return product;
      }

      MatrixXd precondition(const MatrixXd &v) const
      {
        MatrixXd nearly(v.rows(), v.cols());
        for (Index k = 0; k < v.cols(); ++k)
          stiffness.precondition(v.col(k).data(), nearly.col(k).data());
        return nearly;
      }

      MatrixXd product(const MatrixXd &a, const MatrixXd &b) const
      {
        return a.transpose() * (mass.asDiagonal() * b);
      }

      /// Takes away what lies in another block, whose vectors are orthonormal.
      void project(Block &block, const Block &other) const
      {
        const MatrixXd inside = product(other.v, block.v);
        block.v.noalias() -= other.v * inside;
        if (block.k.size() > 0)
          block.k.noalias() -= other.k * inside;
      }

      /// Makes the vectors orthonormal in M by the eigenvectors of their products (Stathopoulos & Wu 2002, SIAM J. Sci.
      /// Comput. 23, 2165); what depends on others is left out.
      void normalize(Block &block) const
      {
        MatrixXd       products = product(block.v, block.v);
        const VectorXd inverse =
          products.diagonal().unaryExpr([](const double square) { return square > 0. ? 1. / std::sqrt(square) : 0.; });
        products = (inverse.asDiagonal() * products * inverse.asDiagonal()).eval();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> found(products);
        const VectorXd                               &size = found.eigenvalues();
        const Index    n_kept  = std::count_if(size.begin(), size.end(), [](const double s) { return s > dependent; });
        const MatrixXd factors = inverse.asDiagonal() * found.eigenvectors().rightCols(n_kept) *
                                 size.tail(n_kept).cwiseSqrt().cwiseInverse().asDiagonal();
        block.v = block.v * factors;
        if (block.k.size() > 0)
          block.k = block.k * factors;
      }

      /// Rayleigh and Ritz within one orthonormal block, which becomes the iterate.
      void take_ritz(const Block &block)
      {
        const MatrixXd                                small = block.v.transpose() * block.k;
        const Eigen::SelfAdjointEigenSolver<MatrixXd> found(0.5 * (small + small.transpose()));
        values = found.eigenvalues();
        x      = block * found.eigenvectors();
      }

      /// The lowest of the space of iterate, preconditioned residuals w and last directions.
      void improve(Block &&w)
      {
        for (int twice = 0; twice < 2; ++twice)
          {
            project(w, x);
            normalize(w);
          }
        w.k = multiply(w.v);
        for (int twice = 0; twice < 2 && p.v.cols() > 0; ++twice)
          {
            project(p, x);
            project(p, w);
            normalize(p);
          }
        const Index                                          n_x = x.v.cols(), n_w = w.v.cols(), n_p = p.v.cols();
        MatrixXd                                             small(n_x + n_w + n_p, n_x + n_w + n_p);
        const std::array<std::pair<const Block *, Index>, 3> blocks{{{&x, 0}, {&w, n_x}, {&p, n_x + n_w}}};
        for (const auto &[a, row] : blocks)
          for (const auto &[b, column] : blocks)
            if (a->v.cols() > 0 && b->v.cols() > 0)
              small.block(row, column, a->v.cols(), b->v.cols()) = a->v.transpose() * b->k;
        const Eigen::SelfAdjointEigenSolver<MatrixXd> found(0.5 * (small + small.transpose()));
        values                 = found.eigenvalues().head(n_x);
        const MatrixXd factors = found.eigenvectors().leftCols(n_x);
        Block          step    = w * factors.middleRows(n_x, n_w);
        if (n_p > 0)
          {
            const Block last = p * factors.bottomRows(n_p);
            step.v += last.v;
            step.k += last.k;
          }
        x = x * factors.topRows(n_x);
        x.v += step.v;
        x.k += step.k;
        p = std::move(step);
      }

      Eigenpairs result(const int n_iterations) const
      {
        Eigenpairs pairs;
        pairs.n_iterations = n_iterations;
        for (Index k = 0; k < wanted; ++k)
          {
            pairs.values.push_back(values[k]);
            pairs.vectors.emplace_back();
            for (Index i = 0; i < mass.size(); ++i)
              pairs.vectors.back().push_back(stiffness.scale()[i] * x.v(i, k));
          }
        return pairs;
      }

      const Multigrid &stiffness;
      VectorXd         mass; ///< D M D
      Index            wanted;
      double           tolerance; ///< of r^T P r/lambda
      VectorXd         values;
      Block            x, p;
    };
  } // namespace

  Eigenpairs find_by_lobpcg(const Multigrid &shifted, const std::vector<double> &masses, const std::size_t n,
                            const double tolerance)
  {
    return Lobpcg(shifted, masses, n, tolerance).solve();
  }
} // namespace birdstrike
