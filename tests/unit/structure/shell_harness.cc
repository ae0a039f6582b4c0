#include "shell_harness.h"

#include "matrices.h"
#include "node_groups.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace shell_harness
{
  const char *name_of(const ShellFormulation formulation)
  {
    return formulation == ShellFormulation::one_point_physical ? "physical"
           : formulation == ShellFormulation::belytschko_tsay  ? "Belytschko-Tsay"
                                                               : "fully integrated";
  }

  Mesh make_grid(const unsigned int nx, const unsigned int ny, const std::function<Point3(double, double)> &map)
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

  Mesh make_patch()
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

  ShellSection make_section(const double young, const double poisson, const ShellFormulation formulation)
  {
    ShellSection section;
    section.formulation                 = formulation;
    section.material.elasticity.young   = young;
    section.material.elasticity.poisson = poisson;
    section.material.hardening.law      = HardeningLaw::elastic;
    section.material.density            = 1.;
    return section;
  }

  Mesh warped_mesh(const unsigned int nx, const unsigned int ny)
  {
    return make_grid(nx, ny, [](const double x, const double y) {
      return Point3(x + 0.1 * y * y, y + 0.07 * std::sin(3. * x), 0.3 * x * y + 0.1 * x * x);
    });
  }

  ShellSection titanium(const HardeningLaw law, const double hardening, const ShellFormulation formulation)
  {
    ShellSection section;
    section.formulation                = formulation;
    section.material.hardening.law     = law;
    section.material.hardening.modulus = hardening;
    return section;
  }

  Model::Model(const Mesh &mesh, const double thickness, const ShellSection &section, const std::size_t n_threads)
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

  Model::~Model() = default;

  Eigen::VectorXd Model::move(const Eigen::VectorXd &increment, const double dt)
  {
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      for (int c = 0; c < 3; ++c)
        position[3 * n + c] += increment[6 * n + c];
    Eigen::VectorXd force(n_dofs());
    elements.compute_internal_forces(position.data(), increment.data(), dt, force.data());
    return force;
  }

  Eigen::MatrixXd Model::compute_stiffness()
  {
    const double         small     = 1e-14 * (mesh.nodes.back() - mesh.nodes.front()).norm();
    const test::NodeSets neighbors = test::find_neighbors(mesh.nodes.size(), mesh.cells);
    Eigen::MatrixXd      K         = Eigen::MatrixXd::Zero(n_dofs(), n_dofs());
    for (const auto &group : test::find_groups(neighbors))
      for (std::size_t c = 0; c < 6; ++c)
        {
          Eigen::VectorXd increment = Eigen::VectorXd::Zero(n_dofs());
          for (const std::size_t n : group)
            increment[6 * n + c] = small;
          const Eigen::VectorXd force = move(increment);
          for (const std::size_t n : group)
            for (const std::size_t near : neighbors[n])
              K.block<6, 1>(6 * near, 6 * n + c) = -force.segment<6>(6 * near) / small;
          increment *= -1.;
          move(increment);
        }
    return K;
  }

  Eigen::VectorXd Model::solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given)
  {
    Eigen::MatrixXd K       = compute_stiffness();
    double          largest = 0.;
    for (std::size_t d = 0; d < n_dofs(); ++d)
      if (d % 6 >= 3)
        largest = std::max(largest, K(d, d));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      {
        auto            block = K.block<3, 3>(6 * n + 3, 6 * n + 3);
        Eigen::Matrix3d left  = 0.5 * (block + block.transpose()); // of the rotations that are not held
        for (int c = 0; c < 3; ++c)
          if (held[6 * n + 3 + c])
            {
              left.row(c).setZero();
              left.col(c).setZero();
              left(c, c) = largest;
            }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(left);
        if (modes.eigenvalues()[0] < 1e-6 * largest) // else in a fold, where no rotation is free
          block += largest * modes.eigenvectors().col(0) * modes.eigenvectors().col(0).transpose();
      }
    test::Entries   entries;
    Eigen::VectorXd right = load;
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
    return test::solve(test::make_square(n_dofs(), entries), right);
  }
  Eigen::VectorXd Model::solve(const Eigen::VectorXd &load, const std::vector<bool> &held)
  {
    return solve(load, held, Eigen::VectorXd::Zero(n_dofs()));
  }

  double exact_eigenvalue(Model &model)
  {
    const auto      mass = model.elements.compute_nodal_masses(), inertia = model.elements.compute_rotary_inertias();
    Eigen::VectorXd of_dofs(model.n_dofs());
    for (std::size_t d = 0; d < model.n_dofs(); ++d)
      of_dofs[d] = d % 6 < 3 ? mass[d / 6] : inertia[d / 6];
    return test::largest_eigenvalue(model.compute_stiffness(), of_dofs);
  }
} // namespace shell_harness
