#pragma once

#include "some_motion.h"

#include "structure/elements/shell/elements.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <functional>
#include <memory>

/// Shell elements without the blade around them: structured meshes, the tangent by finite increments, linear statics.
namespace shell_harness
{
  using namespace birdstrike;

  /// Those that hold for warped elements and any mesh, and all.
  inline constexpr ShellFormulation covariant_formulations[] = {ShellFormulation::one_point_physical,
                                                                ShellFormulation::fully_integrated};
  inline constexpr ShellFormulation all_formulations[]       = {
          ShellFormulation::one_point_physical, ShellFormulation::belytschko_tsay, ShellFormulation::fully_integrated};

  inline const char *name_of(const ShellFormulation formulation)
  {
    return formulation == ShellFormulation::one_point_physical ? "physical"
           : formulation == ShellFormulation::belytschko_tsay  ? "Belytschko-Tsay"
                                                               : "fully integrated";
  }

  struct Mesh
  {
    std::vector<Point3>                       nodes;
    std::vector<std::array<std::uint32_t, 4>> cells;
  };

  /// nx x ny quadrilaterals of (0,1)^2, mapped; node (i, j) is i + (nx + 1) j, normals along dx x dy.
  inline Mesh make_grid(const unsigned int nx, const unsigned int ny, const std::function<Point3(double, double)> &map)
  {
    Mesh mesh;
    for (unsigned int j = 0; j <= ny; ++j)
      for (unsigned int i = 0; i <= nx; ++i)
        mesh.nodes.push_back(map(double(i) / nx, double(j) / ny));
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        {
          const std::uint32_t a = i + (nx + 1) * j;
          mesh.cells.push_back({a, a + 1, a + nx + 2, a + nx + 1});
        }
    return mesh;
  }

  /// MacNeal & Harder (1985): plate 0.24 x 0.12 with four inner nodes, five irregular elements. Nodes 0-3 are corners.
  inline Mesh make_patch()
  {
    return {{{0., 0., 0.},
             {.24, 0., 0.},
             {.24, .12, 0.},
             {0., .12, 0.},
             {.04, .02, 0.},
             {.18, .03, 0.},
             {.16, .08, 0.},
             {.08, .08, 0.}},
            {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};
  }

  inline ShellSection make_section(const double young, const double poisson,
                                   const ShellFormulation formulation = ShellFormulation::one_point_physical)
  {
    ShellSection section;
    section.formulation                 = formulation;
    section.material.elasticity.young   = young;
    section.material.elasticity.poisson = poisson;
    section.material.hardening.law      = HardeningLaw::elastic;
    section.material.density            = 1.;
    return section;
  }

  inline Mesh warped_mesh(const unsigned int nx, const unsigned int ny)
  {
    return make_grid(nx, ny, [](const double x, const double y) {
      return Point3(x + 0.1 * y * y, y + 0.07 * std::sin(3. * x), 0.3 * x * y + 0.1 * x * x);
    });
  }

  inline ShellSection titanium(const HardeningLaw law, const double hardening = 0.,
                               const ShellFormulation formulation = ShellFormulation::one_point_physical)
  {
    ShellSection section;
    section.formulation                = formulation;
    section.material.hardening.law     = law;
    section.material.hardening.modulus = hardening;
    return section;
  }

  struct Model
  {
    Mesh                mesh;
    ShellSection        section;
    double              thickness;
    ThreadPool          pool;
    ShellElements       elements;
    std::vector<double> position;

    Model(const Mesh &mesh, const double thickness, const ShellSection &section, const std::size_t n_threads = 1)
      : mesh(mesh)
      , section(section)
      , thickness(thickness)
      , pool(n_threads)
      , elements(mesh.nodes, mesh.cells, std::vector<double>(mesh.cells.size(), thickness), section, pool)
      , position(3 * mesh.nodes.size())
    {
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        for (int c = 0; c < 3; ++c)
          position[3 * n + c] = mesh.nodes[n][c];
    }

    std::size_t n_dofs() const
    {
      return 6 * mesh.nodes.size();
    }

    /// Moves the nodes by an increment of 6 components each; returns the force of the elements on the nodes.
    Eigen::VectorXd move(const Eigen::VectorXd &increment, const double dt = 1.)
    {
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        for (int c = 0; c < 3; ++c)
          position[3 * n + c] += increment[6 * n + c];
      Eigen::VectorXd force(n_dofs());
      elements.compute_internal_forces(position.data(), increment.data(), dt, force.data());
      return force;
    }

    /// Stiffness of the stress-free state: increments so small (1e-14 of the size) that nothing non-linear is left;
    /// they are given beside the positions, so nothing is lost to cancellation.
    Eigen::MatrixXd compute_stiffness()
    {
      const double    small = 1e-14 * (mesh.nodes.back() - mesh.nodes.front()).norm();
      Eigen::MatrixXd K(n_dofs(), n_dofs());
      for (std::size_t d = 0; d < n_dofs(); ++d)
        {
          Eigen::VectorXd       increment = Eigen::VectorXd::Unit(n_dofs(), d) * small;
          const Eigen::VectorXd force     = move(increment);
          K.col(d)                        = -force / small;
          increment *= -1.;
          move(increment);
        }
      return K;
    }

    /// Displacements under nodal loads; held dofs keep the given values. Free drilling gets a stiffness that nothing
    /// feels, since drilling neither takes nor makes force.
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given)
    {
      Eigen::MatrixXd K       = compute_stiffness();
      double          largest = 0.;
      for (std::size_t d = 0; d < n_dofs(); ++d)
        if (d % 6 >= 3)
          largest = std::max(largest, K(d, d));
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        {
          auto                                                 block = K.block<3, 3>(6 * n + 3, 6 * n + 3);
          const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(0.5 * (block + block.transpose()));
          block += largest * modes.eigenvectors().col(0) * modes.eigenvectors().col(0).transpose();
        }
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd                     right = load;
      for (std::size_t i = 0; i < n_dofs(); ++i)
        {
          if (held[i])
            {
              entries.emplace_back(i, i, 1.);
              right[i] = given[i];
              continue;
            }
          for (std::size_t j = 0; j < n_dofs(); ++j)
            {
              const double k = 0.5 * (K(i, j) + K(j, i));
              if (held[j])
                right[i] -= k * given[j];
              else if (k != 0.)
                entries.emplace_back(i, j, k);
            }
        }
      Eigen::SparseMatrix<double> matrix(n_dofs(), n_dofs());
      matrix.setFromTriplets(entries.begin(), entries.end());
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
      return solver.solve(right);
    }
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held)
    {
      return solve(load, held, Eigen::VectorXd::Zero(n_dofs()));
    }
  };

  /// Largest omega^2 (1/s^2) of the assembled elements with lumped masses, all nodes free.
  inline double exact_eigenvalue(Model &model)
  {
    Eigen::MatrixXd K    = model.compute_stiffness();
    K                    = 0.5 * (K + K.transpose()).eval();
    const auto      mass = model.elements.compute_nodal_masses(), inertia = model.elements.compute_rotary_inertias();
    Eigen::VectorXd scale(model.n_dofs());
    for (std::size_t d = 0; d < model.n_dofs(); ++d)
      scale[d] = 1. / std::sqrt(d % 6 < 3 ? mass[d / 6] : inertia[d / 6]);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * K * scale.asDiagonal())
      .eigenvalues()
      .maxCoeff();
  }
} // namespace shell_harness
