#include "matrices.h"
#include "solid_harness.h"

#include "structure/nodes/column_mass.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace node_columns_test
{
  using namespace solid_harness;

  namespace
  {
    VolumeMesh make_volume(const Mesh &mesh)
    {
      VolumeMesh volume;
      for (const Point3 &x : mesh.nodes)
        volume.nodes.push_back({{x[0], x[1], x[2]}});
      volume.cells = mesh.cells;
      std::map<std::set<std::uint32_t>, std::array<std::size_t, 2>> first; // face: cell, side
      volume.neighbors.assign(mesh.cells.size(), {{-1, -1, -1, -1, -1, -1}});
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        for (unsigned int side = 0; side < 6; ++side)
          {
            const auto nodes           = volume.side_nodes(cell, side);
            const auto [place, is_new] = first.insert({{nodes.begin(), nodes.end()}, {cell, side}});
            if (is_new)
              continue;
            const auto [other, its_side]      = place->second;
            volume.neighbors[cell][side]      = static_cast<std::int32_t>(other);
            volume.neighbors[other][its_side] = static_cast<std::int32_t>(cell);
          }
      return volume;
    }

    /// The same cell with its axes turned by one of twelve rotations of a cube: new axis k runs along old axis
    /// (k + shift) % 3, two of them backwards.
    std::array<std::uint32_t, 8> turn(const std::array<std::uint32_t, 8> &cell, const unsigned int shift,
                                      const unsigned int forwards)
    {
      std::array<std::uint32_t, 8> turned;
      for (unsigned int v = 0; v < 8; ++v)
        {
          unsigned int old = 0;
          for (unsigned int k = 0; k < 3; ++k)
            old |= ((v >> k & 1) ^ (forwards < 3 && k != forwards)) << (k + shift) % 3;
          turned[v] = cell[old];
        }
      return turned;
    }

    /// A bent plate of n_layers thin layers; cells know nothing of each other's axes, nodes are shuffled. `original`
    /// gives the number that a node had in the grid.
    VolumeMesh make_shuffled_plate(const unsigned int n_layers, std::vector<std::uint32_t> &original)
    {
      Mesh                       mesh = make_grid({4, 3, n_layers}, [](const double x, const double y, const double z) {
        return Point3(4. * x + 0.2 * y * y, 3. * y, 0.3 * z * (1. + x) + 0.2 * x * x);
      });
      std::mt19937               random(3);
      std::vector<std::uint32_t> number(mesh.nodes.size());
      std::iota(number.begin(), number.end(), 0u);
      std::shuffle(number.begin(), number.end(), random);
      Mesh shuffled = mesh;
      original.resize(number.size());
      for (std::size_t n = 0; n < number.size(); ++n)
        {
          shuffled.nodes[number[n]] = mesh.nodes[n];
          original[number[n]]       = static_cast<std::uint32_t>(n);
        }
      for (auto &cell : shuffled.cells)
        {
          for (auto &node : cell)
            node = number[node];
          cell = turn(cell, random() % 3, random() % 4);
        }
      return make_volume(shuffled);
    }
  } // namespace

  TEST(NodeColumns, AreFoundWhateverTheCellsCallTheirAxes)
  {
    for (const unsigned int n_layers : {1u, 2u, 5u})
      {
        std::vector<std::uint32_t> original;
        const VolumeMesh           mesh = make_shuffled_plate(n_layers, original);
        const NodeColumns          columns(mesh);
        ASSERT_EQ(columns.begin.size(), 5u * 4u + 1u);
        for (std::size_t c = 0; c + 1 < columns.begin.size(); ++c)
          {
            ASSERT_EQ(columns.begin[c + 1] - columns.begin[c], n_layers + 1);
            const int step =
              int(original[columns.nodes[columns.begin[c] + 1]]) - int(original[columns.nodes[columns.begin[c]]]);
            EXPECT_EQ(std::abs(step), 20) << "one layer of the grid up or down";
            for (std::size_t p = columns.begin[c]; p < columns.begin[c + 1]; ++p)
              {
                EXPECT_EQ(int(original[columns.nodes[p]]),
                          int(original[columns.nodes[columns.begin[c]]]) + step * int(p - columns.begin[c]));
                EXPECT_EQ(columns.place[columns.nodes[p]], p);
              }
          }
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
          for (unsigned int edge = 0; edge < 4; ++edge)
            {
              const auto  p    = columns.edge_place(mesh, cell, edge);
              const auto &have = mesh.cells[cell];
              EXPECT_TRUE(std::count(have.begin(), have.end(), columns.nodes[p]) &&
                          std::count(have.begin(), have.end(), columns.nodes[p + 1]));
            }
      }
  }

  TEST(NodeColumns, RefuseMeshesWithoutLayers)
  {
    const auto expect_refused = [](const Mesh &mesh, const std::string &why) {
      try
        {
          const NodeColumns columns(make_volume(mesh));
          FAIL() << why;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find("Mass scaling/Method"), std::string::npos);
          EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
        }
    };
    expect_refused(make_patch(), "different directions of thickness"); // seven bricks around a cube
    // thirty thin slices that close to a ring
    Mesh ring = make_grid({30, 1, 1}, [](const double x, const double y, const double z) {
      return Point3((2. + y) * std::cos(2. * M_PI * x), -(2. + y) * std::sin(2. * M_PI * x), z);
    });
    for (auto &cell : ring.cells)
      for (auto &node : cell)
        node -= node % 31 == 30 ? 30 : 0;
    for (std::size_t n = ring.nodes.size(); n-- > 0;)
      if (n % 31 == 30)
        {
          ring.nodes.erase(ring.nodes.begin() + n);
          for (auto &cell : ring.cells)
            for (auto &node : cell)
              node -= node > n;
        }
    expect_refused(ring, "close to a ring");
  }

  // Against a dense solve: a = M_s^{-1} f on the free unknowns, f_eff = m a there, and on held ones what the support
  // must take. Sums: the couplings pass forces on and make none.
  TEST(ColumnMass, GivesEffectiveForcesOfTheScaledMatrix)
  {
    std::vector<std::uint32_t> original;
    const VolumeMesh           mesh = make_shuffled_plate(4, original);
    const NodeColumns          columns(mesh);
    const std::size_t          n     = mesh.nodes.size();
    const auto                 value = [](const std::size_t k) { return std::sin(1. + 2.7 * double(k)); };
    std::vector<double>        mass(3 * n), inverse(3 * n), coupling(n, 0.), force(3 * n), external(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
      {
        mass[i]     = 1.5 + value(i / 3);
        inverse[i]  = value(7 * i) > 0.6 ? 0. : 1. / mass[i];
        force[i]    = value(2 * i);
        external[i] = value(5 * i + 3);
      }
    for (std::size_t c = 0; c + 1 < columns.begin.size(); ++c)
      for (std::size_t p = columns.begin[c]; p + 1 < columns.begin[c + 1]; ++p)
        coupling[p] = std::max(0., 20. * value(3 * p + 1));
    Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n); // couplings alone
    for (std::size_t p = 0; p + 1 < n; ++p)
      {
        const auto i = columns.nodes[p], j = columns.nodes[p + 1];
        L(i, i) += coupling[p];
        L(j, j) += coupling[p];
        L(i, j) -= coupling[p];
        L(j, i) -= coupling[p];
      }

    std::vector<double> results[2];
    for (const unsigned int n_threads : {1u, 2u})
      {
        ThreadPool pool(n_threads);
        ColumnMass matrix(columns, coupling, inverse.data(), mesh.nodes.size(), pool);
        auto      &effective = results[n_threads - 1];
        effective.assign(3 * n, 1e300);
        matrix.compute_effective_forces(force.data(), external.data(), effective.data());
        const double form     = matrix.sum_edges([&](const std::size_t i, const std::size_t j) {
          return (force[j] - force[i]) * (external[j] - external[i]);
        });
        double       expected = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            Eigen::VectorXd right(n), u(n), w(n);
            Eigen::MatrixXd M = L;
            for (std::size_t k = 0; k < n; ++k)
              {
                const std::size_t i = 3 * k + c;
                right[k]            = inverse[i] > 0. ? force[i] + external[i] : 0.;
                u[k]                = force[i];
                w[k]                = external[i];
                M(k, k) += mass[i];
                if (inverse[i] == 0.)
                  {
                    M.row(k).setZero();
                    M.col(k).setZero();
                    M(k, k) = 1.;
                  }
              }
            expected += u.dot(L * w);
            const Eigen::VectorXd a = test::solve(M, right), carried = L * a;
            double                sum = 0.;
            for (std::size_t k = 0; k < n; ++k)
              {
                EXPECT_NEAR(effective[3 * k + c], force[3 * k + c] - carried[k], 1e-12);
                if (inverse[3 * k + c] > 0.)
                  {
                    EXPECT_NEAR((effective[3 * k + c] + external[3 * k + c]) / mass[3 * k + c], a[k], 1e-12);
                  }
                sum += effective[3 * k + c] - force[3 * k + c];
              }
            EXPECT_NEAR(sum, 0., 1e-12);
          }
        EXPECT_NEAR(form, expected, 1e-10);
      }
    EXPECT_EQ(results[0], results[1]);
  }

  // At any rotation x x M_s v has the added part that the differences carry, and v x M_s v none.
  TEST(ColumnMass, AngularMomentumOfADifferenceDoesNotDependOnTheOrigin)
  {
    std::vector<std::uint32_t> original;
    const VolumeMesh           mesh = make_shuffled_plate(2, original);
    const NodeColumns          columns(mesh);
    const std::size_t          n = mesh.nodes.size();
    ThreadPool                 pool;
    const std::vector<double>  ones(3 * n, 1.);
    std::vector<double>        coupling(n, 0.), x(3 * n), shifted(3 * n), v(3 * n);
    for (std::size_t p = 0; p < n; ++p)
      coupling[p] = (p + 1) % 3 == 0 ? 0. : 0.5 + 0.1 * double(p % 7);
    const Point3 spin(1., -2., 0.5);
    double       inertia = 0.;
    for (std::size_t k = 0; k < n; ++k)
      {
        const Point3 turning = spin.cross(mesh.node(k));
        for (unsigned int c = 0; c < 3; ++c)
          {
            x[3 * k + c]       = mesh.node(k)[c];
            shifted[3 * k + c] = x[3 * k + c] + 10. * (c + 1.);
            v[3 * k + c]       = turning[c] + 7.;
          }
      }
    const ColumnMass matrix(columns, coupling, ones.data(), mesh.nodes.size(), pool);
    const auto h = matrix.angular_momentum(x.data(), v.data()), far = matrix.angular_momentum(shifted.data(), v.data());
    for (std::size_t p = 0; p + 1 < n; ++p)
      inertia += coupling[p] * spin.cross(mesh.node(columns.nodes[p + 1]) - mesh.node(columns.nodes[p])).squaredNorm();
    EXPECT_NEAR(spin[0] * h[0] + spin[1] * h[1] + spin[2] * h[2], inertia, 1e-12 * inertia); // w.h = 2 T
    for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(far[d], h[d], 1e-12);
        EXPECT_NEAR(matrix.angular_momentum(x.data(), x.data())[d], 0., 1e-13);
      }
  }
} // namespace node_columns_test
