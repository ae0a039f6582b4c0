#include "structure/implicit/modes.h"
#include "structure/implicit/krylov_schur.h"
#include "structure/implicit/lobpcg.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    constexpr double relative_shift = 1e-9; // of the mean of K_ii/M_ii: below all modes that are not of a free body

    /// Takes the symmetric part; returns |K - K^T| over |K|.
    double make_symmetric(SparseRows &k)
    {
      double difference = 0., norm = 0.;
      for (std::size_t row = 0; row < k.size(); ++row)
        for (std::size_t e = k.begin[row]; e < k.begin[row + 1]; ++e)
          {
            norm += k.value[e] * k.value[e];
            const std::uint32_t column = k.column[e];
            if (column <= row)
              continue;
            double &mirrored = k.at(column, static_cast<std::uint32_t>(row));
            difference += 2. * (k.value[e] - mirrored) * (k.value[e] - mirrored);
            k.value[e] = mirrored = 0.5 * (k.value[e] + mirrored);
          }
      return std::sqrt(difference / norm);
    }

    VibrationModes::Mode make_mode(const Equilibrium &equilibrium, const std::vector<double> &masses,
                                   const double value, std::vector<double> shape)
    {
      VibrationModes::Mode  mode;
      std::array<double, 3> moving{}, all{};
      double                modal = 0.;
      mode.frequency              = std::copysign(std::sqrt(std::abs(value)), value) / (2. * std::numbers::pi);
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
    const std::vector<double> masses    = equilibrium.masses();
    SparseRows                stiffness = equilibrium.compute_elastic_tangent();
    VibrationModes            result;
    result.n_unknowns = size;
    result.asymmetry  = make_symmetric(stiffness);
    double mean       = 0.;
    for (std::uint32_t k = 0; k < size; ++k)
      mean += stiffness.at(k, k) / (masses[k] * static_cast<double>(size));
    const double shift = -relative_shift * mean;
    for (std::uint32_t k = 0; k < size; ++k)
      stiffness.at(k, k) -= shift * masses[k];
    Eigenpairs pairs =
      takes_multigrid(linear_solver, size)
        ? find_by_lobpcg(Multigrid(std::move(stiffness), equilibrium.unknowns(), equilibrium.rigid_motions()), masses,
                         n)
        : find_by_krylov_schur(stiffness, masses, n);
    for (std::size_t k = 0; k < pairs.values.size(); ++k)
      result.modes.push_back(make_mode(equilibrium, masses, pairs.values[k] + shift, std::move(pairs.vectors[k])));
    std::sort(result.modes.begin(), result.modes.end(),
              [](const auto &a, const auto &b) { return a.frequency < b.frequency; });
    if (result.modes.size() > n) // where the cut falls into a pair of equal ones, both come
      result.modes.resize(n);
    return result;
  }
} // namespace birdstrike
