#include "structure/implicit/modes.h"
#include "structure/implicit/krylov_schur.h"
#include "structure/implicit/lobpcg.h"
#include "structure/implicit/symmetric_solver.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    constexpr double       relative_shift = 1e-9; // of the mean of K_ii/M_ii: below all modes of stable states
    constexpr unsigned int most_shifts    = 30;   // each four times as far
    const char *const      no_bound = "Modes: the stiffness of the loaded blade has no lower bound. Check its loads.";

    VibrationModes::Mode make_mode(const Equilibrium &equilibrium, const std::vector<double> &masses,
                                   const double value, std::vector<double> shape)
    {
      VibrationModes::Mode  mode;
      std::array<double, 3> moving{}, all{};
      double                modal = 0.;
      if (value < 0.)
        mode.growth_rate = std::sqrt(-value);
      else
        mode.frequency = std::sqrt(value) / (2. * std::numbers::pi);
      for (std::size_t k = 0; k < shape.size(); ++k)
        {
          const FreeUnknown &unknown = equilibrium.unknowns()[k];
          modal += masses[k] * shape[k] * shape[k];
          for (unsigned int d = 0; d < 3 && !unknown.is_rotation; ++d)
            {
              moving[d] += masses[k] * shape[k] * unknown.axis[d];
              all[d] += masses[k] * unknown.axis[d] * unknown.axis[d];
            }
        }
      for (unsigned int d = 0; d < 3; ++d)
        mode.effective_mass[d] = all[d] > 0. ? moving[d] * moving[d] / (modal * all[d]) : 0.;
      mode.shape     = equilibrium.nodal_displacements(shape);
      double largest = 0., sign = 1.;
      for (std::size_t n = 0; n < mode.shape.size(); n += 3)
        if (const Point3 u(&mode.shape[n]); u.norm() > largest * (1. + 1e-6))
          {
            largest = u.norm();
            Eigen::Index k;
            u.cwiseAbs().maxCoeff(&k);
            sign = u[k] < 0. ? -1. : 1.;
          }
      for (double &u : mode.shape)
        u *= largest > 0. ? sign / largest : 0.;
      return mode;
    }

    /// The lowest of (K - lambda M) x = 0. The shift lies below all of them: of a stable state a little below zero,
    /// else where factors have no negative pivot, or no Rayleigh quotient is negative.
    class Spectrum
    {
    public:
      Spectrum(Equilibrium &equilibrium, const LinearSolverChoice linear_solver)
        : masses(equilibrium.masses()), equilibrium(equilibrium), linear_solver(linear_solver)
      {
        stiffness   = make_stiffness();
        double mean = 0.;
        for (std::uint32_t k = 0; k < masses.size(); ++k)
          mean += stiffness.find(k, k) / (masses[k] * static_cast<double>(masses.size()));
        round_off = relative_shift * std::abs(mean);
        shift     = -round_off;
      }

      struct Pair
      {
        double              value;
        std::vector<double> shape;
      };
      std::vector<Pair> find_lowest(const std::size_t n)
      {
        Eigenpairs        pairs = takes_multigrid(linear_solver, masses.size()) ? by_multigrid(n) : by_factors(n);
        std::vector<Pair> result;
        for (std::size_t k = 0; k < pairs.values.size(); ++k)
          {
            const double value   = pairs.values[k] + shift;
            const bool   is_zero = std::abs(value) < round_off && is_rigid(pairs.vectors[k]);
            result.push_back({is_zero ? std::abs(value) : value, std::move(pairs.vectors[k])});
          }
        return result;
      }

      std::vector<double> masses;
      double              asymmetry = 0.;

    private:
      SparseRows make_stiffness()
      {
        SparseRows made = equilibrium.compute_elastic_tangent();
        asymmetry       = made.make_symmetric();
        return made;
      }
      SparseRows make_shifted()
      {
        SparseRows shifted = stiffness.column.empty() ? make_stiffness() : std::move(stiffness);
        stiffness          = {}; // as large as its factors, or nearly so: made anew for the next shift
        for (std::uint32_t k = 0; k < masses.size(); ++k)
          shifted.at(k, k) -= shift * masses[k];
        return shifted;
      }

      Eigenpairs by_factors(const std::size_t n)
      {
        for (unsigned int k = 0; k < most_shifts; ++k, shift *= 4.)
          if (SymmetricSolver factors(make_shifted()); factors.n_negative() == 0)
            return find_by_krylov_schur(factors, masses, n);
        throw NumericalFailure(no_bound);
      }

      Eigenpairs by_multigrid(const std::size_t n)
      {
        for (unsigned int k = 0; k < most_shifts; ++k)
          {
            const Multigrid multigrid(make_shifted(), equilibrium.unknowns(), equilibrium.rigid_motions());
            Eigenpairs      pairs = find_by_lobpcg(multigrid, masses, n);
            if (pairs.is_positive())
              return pairs;
            shift = std::min(4. * shift, shift + 4. * pairs.values[0]);
          }
        throw NumericalFailure(no_bound);
      }

      /// Whether a shape is a rigid motion, to a millionth of its kinetic energy: what nothing holds.
      bool is_rigid(const std::vector<double> &shape) const
      {
        const std::vector<std::vector<double>> motions = equilibrium.rigid_motions();
        const auto                             n       = static_cast<Eigen::Index>(masses.size());
        const auto                             root    = Eigen::Map<const Eigen::ArrayXd>(masses.data(), n).sqrt();
        Eigen::MatrixXd                        rigid(n, static_cast<Eigen::Index>(motions.size()));
        for (std::size_t k = 0; k < motions.size(); ++k)
          rigid.col(static_cast<Eigen::Index>(k)) = Eigen::Map<const Eigen::ArrayXd>(motions[k].data(), n) * root;
        const Eigen::VectorXd moved = Eigen::Map<const Eigen::ArrayXd>(shape.data(), n) * root;
        const Eigen::VectorXd left  = moved - rigid * rigid.colPivHouseholderQr().solve(moved);
        return left.squaredNorm() < 1e-6 * moved.squaredNorm();
      }

      Equilibrium       &equilibrium;
      LinearSolverChoice linear_solver;
      SparseRows         stiffness;
      double             shift = 0., round_off = 0.; ///< 1/s^2
    };
  } // namespace

  double modal_assurance(const std::vector<double> &a, const std::vector<double> &b)
  {
    const auto dot = [](const auto &u, const auto &v) { return std::inner_product(u.begin(), u.end(), v.begin(), 0.); };
    const double shared = dot(a, b), squares = dot(a, a) * dot(b, b);
    return squares > 0. ? shared * shared / squares : 0.;
  }

  VibrationModes compute_modes(Equilibrium &equilibrium, const std::size_t n, const LinearSolverChoice linear_solver)
  {
    const std::size_t size = equilibrium.unknowns().size();
    if (3 * n + 1 > size)
      throw InputError("Modes: " + std::to_string(n) + " modes of " + std::to_string(size) +
                       " unknowns were asked for.\nAllowed: up to a third of the unknowns; ask for fewer or refine the "
                       "mesh.");
    VibrationModes result;
    result.n_unknowns = size;
    Spectrum spectrum(equilibrium, linear_solver);
    for (auto &[value, shape] : spectrum.find_lowest(n))
      result.modes.push_back(make_mode(equilibrium, spectrum.masses, value, std::move(shape)));
    result.asymmetry = spectrum.asymmetry;
    std::ranges::sort(result.modes, {},
                      [](const VibrationModes::Mode &m) { return m.is_unstable() ? -m.growth_rate : m.frequency; });
    if (result.modes.size() > n) // where the cut falls into a pair of equal ones, both come
      result.modes.resize(n);
    return result;
  }
} // namespace birdstrike
