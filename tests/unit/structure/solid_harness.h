#pragma once

#include "some_motion.h"

#include "structure/elements/solid/elements.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <functional>
#include <map>
#include <memory>

/// Solid elements without the blade around them: structured meshes, the tangent by finite increments, linear statics
/// and frequencies, central differences.
namespace solid_harness
{
  using namespace birdstrike;

  struct Mesh
  {
    std::vector<Point3>                       nodes;
    std::vector<std::array<std::uint32_t, 8>> cells;
  };

  /// nx x ny x nz bricks of (0,1)^3, mapped; node (i, j, k) is i + (nx + 1) (j + (ny + 1) k).
  inline Mesh make_grid(const std::array<unsigned int, 3> &n, const std::function<Point3(double, double, double)> &map)
  {
    Mesh mesh;
    for (unsigned int k = 0; k <= n[2]; ++k)
      for (unsigned int j = 0; j <= n[1]; ++j)
        for (unsigned int i = 0; i <= n[0]; ++i)
          mesh.nodes.push_back(map(double(i) / n[0], double(j) / n[1], double(k) / n[2]));
    const std::uint32_t row = n[0] + 1, layer = row * (n[1] + 1);
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          {
            const std::uint32_t a = i + row * j + layer * k, b = a + layer;
            mesh.cells.push_back({a, a + 1, a + row, a + row + 1, b, b + 1, b + row, b + row + 1});
          }
    return mesh;
  }

  inline Mesh make_box(const std::array<unsigned int, 3> &n, const Point3 &size)
  {
    return make_grid(n, [&size](const double x, const double y, const double z) {
      return Point3(size[0] * x, size[1] * y, size[2] * z);
    });
  }

  /// MacNeal & Harder (1985): unit cube with eight inner nodes, seven irregular bricks. Nodes 0-7 are the corners.
  inline Mesh make_patch()
  {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
      mesh.nodes.emplace_back(i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0.);
    for (const Point3 &x :
         {Point3(.249, .342, .192), Point3(.826, .288, .288), Point3(.273, .750, .230), Point3(.850, .649, .263),
          Point3(.320, .186, .643), Point3(.677, .305, .683), Point3(.165, .745, .702), Point3(.788, .693, .644)})
      mesh.nodes.push_back(x);
    mesh.cells = {{8, 9, 10, 11, 12, 13, 14, 15}, {0, 8, 2, 10, 4, 12, 6, 14},  {9, 1, 11, 3, 13, 5, 15, 7},
                  {0, 1, 8, 9, 4, 5, 12, 13},     {10, 11, 2, 3, 14, 15, 6, 7}, {0, 1, 2, 3, 8, 9, 10, 11},
                  {12, 13, 14, 15, 4, 5, 6, 7}};
    return mesh;
  }

  inline SolidSection make_section(const double young, const double poisson,
                                   const SolidFormulation formulation = SolidFormulation::one_point)
  {
    SolidSection section;
    section.formulation                 = formulation;
    section.material.elasticity.young   = young;
    section.material.elasticity.poisson = poisson;
    section.material.hardening.law      = HardeningLaw::elastic;
    section.material.density            = 1.;
    section.linear_viscosity            = 0.;
    section.quadratic_viscosity         = 0.;
    return section;
  }

  struct Model
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;

    Mesh                mesh;
    SolidSection        section;
    ThreadPool          pool;
    SolidElements       elements;
    std::vector<double> position;

    Model(const Mesh &mesh, const SolidSection &section, const std::size_t n_threads = 1)
      : mesh(mesh)
      , section(section)
      , pool(n_threads)
      , elements(mesh.nodes, mesh.cells, section, pool)
      , position(3 * mesh.nodes.size())
    {
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        for (int c = 0; c < 3; ++c)
          position[3 * n + c] = mesh.nodes[n][c];
    }

    std::size_t n_dofs() const
    {
      return 3 * mesh.nodes.size();
    }

    /// Moves the nodes by an increment of 3 components each; returns the force of the elements on the nodes.
    Eigen::VectorXd move(const Eigen::VectorXd &increment, const double dt = 1.)
    {
      for (std::size_t d = 0; d < n_dofs(); ++d)
        position[d] += increment[d];
      Eigen::VectorXd force(n_dofs());
      elements.compute_internal_forces(position.data(), increment.data(), dt, force.data());
      return force;
    }

    /// Stiffness of the stress-free state: increments so small (1e-14 of the size) that nothing non-linear is left;
    /// they are given beside the positions, so nothing is lost to cancellation. Nodes that share no element are moved
    /// together.
    SparseMatrix compute_stiffness()
    {
      std::vector<std::vector<std::uint32_t>> neighbors(mesh.nodes.size());
      for (const auto &cell : mesh.cells)
        for (const auto n : cell)
          neighbors[n].insert(neighbors[n].end(), cell.begin(), cell.end());
      std::vector<int> color(mesh.nodes.size(), -1);
      int              n_colors = 0;
      for (std::size_t n = 0; n < color.size(); ++n)
        {
          std::vector<bool> taken(color.size() + 1, false);
          for (const auto m : neighbors[n])
            for (const auto far : neighbors[m])
              if (color[far] >= 0)
                taken[color[far]] = true;
          color[n] = int(std::find(taken.begin(), taken.end(), false) - taken.begin());
          n_colors = std::max(n_colors, color[n] + 1);
        }
      const double                          small = 1e-14 * (mesh.nodes.back() - mesh.nodes.front()).norm();
      std::map<std::pair<int, int>, double> entries;
      for (int k = 0; k < n_colors; ++k)
        for (int c = 0; c < 3; ++c)
          {
            Eigen::VectorXd increment = Eigen::VectorXd::Zero(n_dofs());
            for (std::size_t n = 0; n < color.size(); ++n)
              if (color[n] == k)
                increment[3 * n + c] = small;
            const Eigen::VectorXd force = move(increment);
            for (std::size_t n = 0; n < color.size(); ++n)
              if (color[n] == k)
                for (const auto m : neighbors[n])
                  for (int r = 0; r < 3; ++r)
                    entries[{3 * int(m) + r, 3 * int(n) + c}] = -force[3 * m + r] / small;
            move(-increment);
          }
      std::vector<Eigen::Triplet<double>> triplets;
      for (const auto &[place, value] : entries)
        triplets.emplace_back(place.first, place.second, value);
      const auto   size = static_cast<Eigen::Index>(n_dofs());
      SparseMatrix K(size, size);
      K.setFromTriplets(triplets.begin(), triplets.end());
      return K;
    }

    /// Displacements under nodal loads; held dofs keep the given values.
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given)
    {
      const SparseMatrix                  K = compute_stiffness();
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd                     right = load;
      for (std::size_t d = 0; d < n_dofs(); ++d)
        if (held[d])
          {
            entries.emplace_back(d, d, 1.);
            right[d] = given[d];
          }
      for (int j = 0; j < K.outerSize(); ++j)
        for (SparseMatrix::InnerIterator it(K, j); it; ++it)
          if (!held[it.row()])
            {
              if (held[j])
                right[it.row()] -= it.value() * given[j];
              else
                entries.emplace_back(it.row(), j, it.value());
            }
      SparseMatrix matrix(K.rows(), K.cols());
      matrix.setFromTriplets(entries.begin(), entries.end());
      const SparseMatrix                  symmetric = 0.5 * (matrix + SparseMatrix(matrix.transpose()));
      Eigen::SimplicialLDLT<SparseMatrix> solver(symmetric);
      return solver.solve(right);
    }
    Eigen::VectorXd solve(const Eigen::VectorXd &load, const std::vector<bool> &held)
    {
      return solve(load, held, Eigen::VectorXd::Zero(n_dofs()));
    }

    /// Lowest natural frequencies (Hz) with lumped masses, by subspace iteration.
    std::vector<double> compute_frequencies(const std::vector<bool> &held, const int n)
    {
      std::vector<int> place(n_dofs(), -1);
      int              n_free = 0;
      for (std::size_t d = 0; d < n_dofs(); ++d)
        if (!held[d])
          place[d] = n_free++;
      const std::vector<double>           mass = elements.compute_nodal_masses();
      const SparseMatrix                  K    = compute_stiffness();
      std::vector<Eigen::Triplet<double>> entries;
      for (int j = 0; j < K.outerSize(); ++j)
        for (SparseMatrix::InnerIterator it(K, j); it; ++it)
          if (place[it.row()] >= 0 && place[j] >= 0)
            entries.emplace_back(place[it.row()], place[j], it.value() / std::sqrt(mass[it.row() / 3] * mass[j / 3]));
      SparseMatrix matrix(n_free, n_free);
      matrix.setFromTriplets(entries.begin(), entries.end());
      const SparseMatrix                  symmetric = 0.5 * (matrix + SparseMatrix(matrix.transpose()));
      Eigen::SimplicialLDLT<SparseMatrix> solver(symmetric);
      Eigen::MatrixXd                     X(n_free, 2 * n + 4);
      for (Eigen::Index i = 0; i < X.size(); ++i)
        X.data()[i] = std::sin(1. + 12.9898 * double(i % 7919) + double(i));
      Eigen::VectorXd values;
      for (int iteration = 0; iteration < 30; ++iteration)
        {
          X = Eigen::HouseholderQR<Eigen::MatrixXd>(solver.solve(X)).householderQ() *
              Eigen::MatrixXd::Identity(n_free, X.cols());
          const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(X.transpose() * (symmetric * X));
          X      = X * modes.eigenvectors();
          values = modes.eigenvalues();
        }
      std::vector<double> frequencies;
      for (int k = 0; k < n; ++k)
        frequencies.push_back(std::sqrt(values[k]) / (2. * M_PI));
      return frequencies;
    }
  };

  /// Central differences with lumped masses, velocities at half steps; some components held.
  struct Motion
  {
    Model              &model;
    std::vector<double> mass;
    std::vector<bool>   held;
    Eigen::VectorXd     velocity, force, increment;
    double              last_dt = 0., initial_energy = 0.;

    explicit Motion(Model &model)
      : model(model)
      , mass(model.elements.compute_nodal_masses())
      , held(model.n_dofs(), false)
      , velocity(Eigen::VectorXd::Zero(model.n_dofs()))
      , force(velocity)
      , increment(velocity)
    {
    }

    void step(const double dt)
    {
      for (Eigen::Index d = 0; d < velocity.size(); ++d)
        {
          velocity[d]  = held[d] ? 0. : velocity[d] + 0.5 * (dt + last_dt) * force[d] / mass[d / 3];
          increment[d] = velocity[d] * dt;
          model.position[d] += increment[d];
        }
      last_dt = dt;
      model.elements.compute_internal_forces(model.position.data(), increment.data(), dt, force.data());
    }

    /// At the whole step.
    double kinetic_energy() const
    {
      double sum = 0.;
      for (Eigen::Index d = 0; d < velocity.size(); ++d)
        {
          const double v = held[d] ? 0. : velocity[d] + 0.5 * last_dt * force[d] / mass[d / 3];
          sum += 0.5 * mass[d / 3] * v * v;
        }
      return sum;
    }
    double total_energy() const
    {
      const auto &e = model.elements;
      return kinetic_energy() + e.elastic_energy() + e.plastic_work() + e.hourglass_energy() + e.viscous_energy();
    }
  };

} // namespace solid_harness
