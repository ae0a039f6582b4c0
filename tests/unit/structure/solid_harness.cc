#include "solid_harness.h"

#include "matrices.h"
#include "node_groups.h"

#include <algorithm>
#include <map>

namespace solid_harness
{
  Mesh make_grid(const std::array<unsigned int, 3> &n, const std::function<Point3(double, double, double)> &map)
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

  Mesh make_box(const std::array<unsigned int, 3> &n, const Point3 &size)
  {
    return make_grid(n, [&size](const double x, const double y, const double z) {
      return Point3(size[0] * x, size[1] * y, size[2] * z);
    });
  }

  Mesh make_patch()
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

  SolidSection make_section(const double young, const double poisson, const SolidFormulation formulation)
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

  Model::Model(const Mesh &mesh, const SolidSection &section, const std::size_t n_threads)
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

  Model::~Model() = default;

  Eigen::VectorXd Model::move(const Eigen::VectorXd &increment, const double dt)
  {
    for (std::size_t d = 0; d < n_dofs(); ++d)
      position[d] += increment[d];
    Eigen::VectorXd force(n_dofs());
    elements.compute_internal_forces(position.data(), increment.data(), dt, force.data());
    return force;
  }

  namespace
  {
    test::SparseMatrix assemble(Model &model)
    {
      const Mesh                           &mesh      = model.mesh;
      const double                          small     = 1e-14 * (mesh.nodes.back() - mesh.nodes.front()).norm();
      const test::NodeSets                  neighbors = test::find_neighbors(mesh.nodes.size(), mesh.cells);
      std::map<std::pair<int, int>, double> entries;
      for (const auto &group : test::find_groups(neighbors))
        for (int c = 0; c < 3; ++c)
          {
            Eigen::VectorXd increment = Eigen::VectorXd::Zero(model.n_dofs());
            for (const std::size_t n : group)
              increment[3 * n + c] = small;
            const Eigen::VectorXd force = model.move(increment);
            for (const std::size_t n : group)
              for (const std::size_t near : neighbors[n])
                for (int r = 0; r < 3; ++r)
                  entries[{3 * int(near) + r, 3 * int(n) + c}] = -force[3 * near + r] / small;
            model.move(-increment);
          }
      test::Entries triplets;
      for (const auto &[place, value] : entries)
        triplets.emplace_back(place.first, place.second, value);
      return test::make_square(model.n_dofs(), triplets);
    }
  } // namespace

  Eigen::MatrixXd Model::compute_stiffness()
  {
    return assemble(*this);
  }

  Eigen::VectorXd Model::solve(const Eigen::VectorXd &load, const std::vector<bool> &held, const Eigen::VectorXd &given)
  {
    const test::SparseMatrix K = assemble(*this);
    test::Entries            entries;
    Eigen::VectorXd          right = load;
    for (std::size_t d = 0; d < n_dofs(); ++d)
      if (held[d])
        {
          entries.emplace_back(d, d, 1.);
          right[d] = given[d];
        }
    for (int j = 0; j < K.outerSize(); ++j)
      for (test::SparseMatrix::InnerIterator it(K, j); it; ++it)
        if (!held[it.row()])
          {
            if (held[j])
              right[it.row()] -= it.value() * given[j];
            else
              entries.emplace_back(it.row(), j, it.value());
          }
    return test::solve(test::symmetric_part(test::make_square(n_dofs(), entries)), right);
  }
  Eigen::VectorXd Model::solve(const Eigen::VectorXd &load, const std::vector<bool> &held)
  {
    return solve(load, held, Eigen::VectorXd::Zero(n_dofs()));
  }

  std::vector<double> Model::compute_frequencies(const std::vector<bool> &held, const int n)
  {
    std::vector<int> place(n_dofs(), -1);
    int              n_free = 0;
    for (std::size_t d = 0; d < n_dofs(); ++d)
      if (!held[d])
        place[d] = n_free++;
    const std::vector<double> mass = elements.compute_nodal_masses();
    const test::SparseMatrix  K    = assemble(*this);
    test::Entries             entries;
    for (int j = 0; j < K.outerSize(); ++j)
      for (test::SparseMatrix::InnerIterator it(K, j); it; ++it)
        if (place[it.row()] >= 0 && place[j] >= 0)
          entries.emplace_back(place[it.row()], place[j], it.value() / std::sqrt(mass[it.row() / 3] * mass[j / 3]));
    const test::SparseMatrix matrix = test::symmetric_part(test::make_square(n_free, entries));
    Eigen::MatrixXd          start(n_free, 2 * n + 4);
    for (Eigen::Index i = 0; i < start.size(); ++i)
      start.data()[i] = std::sin(1. + 12.9898 * double(i % 7919) + double(i));
    const Eigen::VectorXd values = test::lowest_eigenvalues(matrix, start, 30);
    std::vector<double>   frequencies;
    for (int k = 0; k < n; ++k)
      frequencies.push_back(std::sqrt(values[k]) / (2. * M_PI));
    return frequencies;
  }

  double exact_eigenvalue(Model &model)
  {
    const auto      mass = model.elements.compute_nodal_masses();
    Eigen::VectorXd of_dofs(model.n_dofs());
    for (std::size_t d = 0; d < model.n_dofs(); ++d)
      of_dofs[d] = mass[d / 3];
    return test::largest_eigenvalue(model.compute_stiffness(), of_dofs);
  }

  Motion::Motion(Model &model)
    : model(model)
    , mass(model.elements.compute_nodal_masses())
    , held(model.n_dofs(), false)
    , velocity(Eigen::VectorXd::Zero(model.n_dofs()))
    , force(velocity)
    , increment(velocity)
  {
  }

  void Motion::step(const double dt)
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

  double Motion::kinetic_energy() const
  {
    double sum = 0.;
    for (Eigen::Index d = 0; d < velocity.size(); ++d)
      {
        const double v = held[d] ? 0. : velocity[d] + 0.5 * last_dt * force[d] / mass[d / 3];
        sum += 0.5 * mass[d / 3] * v * v;
      }
    return sum;
  }
  double Motion::total_energy() const
  {
    const auto &e = model.elements;
    return kinetic_energy() + e.elastic_energy() + e.plastic_work() + e.hourglass_energy() + e.viscous_energy();
  }
} // namespace solid_harness
