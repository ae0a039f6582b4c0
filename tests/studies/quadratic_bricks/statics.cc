#include "study.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <cmath>

namespace birdstrike::studies
{
  namespace
  {
    using SparseMatrix = Eigen::SparseMatrix<double>;

    std::vector<double> flatten(const std::vector<Point3> &nodes)
    {
      std::vector<double> x;
      for (const Point3 &p : nodes)
        x.insert(x.end(), {p[0], p[1], p[2]});
      return x;
    }

    /// K u at the given place, in `force`: increments so small that nothing non-linear is left, taken back afterwards.
    void apply_stiffness(Part &part, const double *position, const std::vector<double> &u, std::vector<double> &force)
    {
      double largest = 0.;
      for (const double v : u)
        largest = std::max(largest, std::abs(v));
      const double        scale = 1e-12 / largest;
      std::vector<double> increment(u);
      for (double &v : increment)
        v *= scale;
      part.compute_internal_forces(position, increment.data(), 1., force.data());
      std::vector<double> back(increment), unused(force.size());
      for (double &v : back)
        v = -v;
      part.compute_internal_forces(position, back.data(), 1., unused.data());
      for (double &f : force)
        f /= -scale;
    }

    /// The unknowns of one component at the nodes whose grid place is `phase` modulo the reach of an element: no two of
    /// them meet in a row.
    struct Group
    {
      std::array<unsigned int, 3> phase;
      unsigned int                component;
    };

    std::vector<Group> make_groups(const Part &part)
    {
      const unsigned int period = 2 * part.degree + 1;
      std::vector<Group> groups;
      for (unsigned int k = 0; k < std::min(period, part.n_grid[2]); ++k)
        for (unsigned int j = 0; j < std::min(period, part.n_grid[1]); ++j)
          for (unsigned int i = 0; i < std::min(period, part.n_grid[0]); ++i)
            for (unsigned int c = 0; c < part.n_unknowns; ++c)
              groups.push_back({{i, j, k}, c});
      return groups;
    }

    struct Grid
    {
      const Part                &part;
      std::vector<std::uint32_t> node_at;

      explicit Grid(const Part &part) : part(part), node_at(part.nodes.size())
      {
        for (std::uint32_t n = 0; n < part.nodes.size(); ++n)
          node_at[index(part.grid[n])] = n;
      }
      std::size_t index(const std::array<unsigned int, 3> &g) const
      {
        return g[0] + part.n_grid[0] * (g[1] + std::size_t(part.n_grid[1]) * g[2]);
      }
      /// Calls f with every node within reach.
      template <class Function>
      void for_neighbours(const std::array<unsigned int, 3> &g, const Function &f) const
      {
        std::array<unsigned int, 3> low, high, m;
        for (int c = 0; c < 3; ++c)
          {
            low[c]  = g[c] < part.degree ? 0 : g[c] - part.degree;
            high[c] = std::min(g[c] + part.degree, part.n_grid[c] - 1);
          }
        for (m[2] = low[2]; m[2] <= high[2]; ++m[2])
          for (m[1] = low[1]; m[1] <= high[1]; ++m[1])
            for (m[0] = low[0]; m[0] <= high[0]; ++m[0])
              f(node_at[index(m)]);
      }
    };

    /// M^{-1/2} K M^{-1/2} over the unknowns with a row in `row` (-1: held).
    SparseMatrix make_scaled_stiffness(Part &part, const std::vector<int> &row, const int n_rows)
    {
      const Grid                          grid(part);
      const unsigned int                  period = 2 * part.degree + 1, n_u = part.n_unknowns;
      const std::vector<double>           position = flatten(part.nodes);
      std::vector<double>                 u(part.mass.size()), force(u.size());
      std::vector<Eigen::Triplet<double>> entries;
      for (const Group &group : make_groups(part))
        {
          const auto is_in = [&](const std::array<unsigned int, 3> &g) {
            return g[0] % period == group.phase[0] && g[1] % period == group.phase[1] &&
                   g[2] % period == group.phase[2];
          };
          for (std::size_t n = 0; n < part.nodes.size(); ++n)
            for (unsigned int c = 0; c < n_u; ++c)
              u[n_u * n + c] = is_in(part.grid[n]) && c == group.component ? 1. : 0.;
          apply_stiffness(part, position.data(), u, force);
          for (std::size_t n = 0; n < part.nodes.size(); ++n)
            if (const std::size_t column = n_u * n + group.component; is_in(part.grid[n]) && row[column] >= 0)
              grid.for_neighbours(part.grid[n], [&](const std::uint32_t m) {
                for (unsigned int c = 0; c < n_u; ++c)
                  if (const std::size_t r = n_u * m + c; row[r] >= 0)
                    entries.emplace_back(row[r], row[column], force[r] / std::sqrt(part.mass[r] * part.mass[column]));
              });
        }
      SparseMatrix matrix(n_rows, n_rows);
      matrix.setFromTriplets(entries.begin(), entries.end());
      return 0.5 * (matrix + SparseMatrix(matrix.transpose()));
    }
  } // namespace

  std::vector<double> compute_frequencies(Part &part, const unsigned int n_modes)
  {
    std::vector<int> row(part.mass.size(), -1);
    int              n_free = 0;
    for (std::size_t n = 0; n < part.nodes.size(); ++n)
      for (unsigned int c = 0; c < part.n_unknowns; ++c)
        if (part.grid[n][0] > 0 && (part.n_unknowns == 3 || (c >= 2 && c <= 4)))
          row[part.n_unknowns * n + c] = n_free++;
    const SparseMatrix                        matrix = make_scaled_stiffness(part, row, n_free);
    const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
    Eigen::MatrixXd                           modes(n_free, n_modes + 6);
    for (Eigen::Index i = 0; i < modes.size(); ++i)
      modes.data()[i] = std::sin(1. + 12.9898 * double(i % 7919) + double(i));
    Eigen::VectorXd values;
    for (int iteration = 0; iteration < 20; ++iteration)
      {
        const Eigen::MatrixXd better = solver.solve(modes);
        const Eigen::MatrixXd basis =
          better.householderQr().householderQ() * Eigen::MatrixXd::Identity(better.rows(), better.cols());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(basis.transpose() * (matrix * basis));
        modes  = basis * small.eigenvectors();
        values = small.eigenvalues();
      }
    std::vector<double> frequencies;
    for (unsigned int k = 0; k < n_modes; ++k)
      frequencies.push_back(std::sqrt(std::max(values[k], 0.)) / (2. * M_PI));
    return frequencies;
  }

  unsigned int count_free_modes(Part &part)
  {
    std::vector<int> row(part.mass.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<int>(i);
    const Eigen::MatrixXd matrix = make_scaled_stiffness(part, row, static_cast<int>(row.size()));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    unsigned int                                         n = 0;
    for (const double value : solver.eigenvalues())
      n += value < 1e-9 * solver.eigenvalues()[matrix.rows() - 1];
    return n;
  }

  double compute_stable_step(Part &part, const double *position, const unsigned int n_iterations,
                             std::vector<double> &mode)
  {
    if (mode.empty())
      for (std::size_t i = 0; i < part.mass.size(); ++i)
        mode.push_back(std::sin(1. + 12.9898 * double(i % 7919) + double(i)));
    std::vector<double> force(mode.size());
    double              square = 0.;
    for (unsigned int k = 0; k < n_iterations; ++k)
      {
        apply_stiffness(part, position, mode, force);
        double work = 0., inertia = 0., norm = 0.;
        for (std::size_t i = 0; i < mode.size(); ++i)
          {
            work += mode[i] * force[i];
            inertia += part.mass[i] * mode[i] * mode[i];
            mode[i] = force[i] / part.mass[i];
            norm += part.mass[i] * mode[i] * mode[i];
          }
        square = work / inertia;
        for (double &v : mode)
          v /= std::sqrt(norm);
      }
    return 2. / std::sqrt(square);
  }
} // namespace birdstrike::studies
