#include "solid_frequencies.h"

#include "matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike::test
{
  namespace
  {
    /// The nodes that share a cell with each node, itself included.
    std::vector<std::set<std::uint32_t>> neighbours_of_nodes(const FieldSnapshot &snapshot)
    {
      std::vector<std::set<std::uint32_t>> neighbours(snapshot.points.size() / 3);
      const unsigned int                   n_corners = 1u << snapshot.dim;
      for (std::size_t cell = 0; cell < snapshot.cells.size(); cell += n_corners)
        for (unsigned int a = 0; a < n_corners; ++a)
          neighbours[snapshot.cells[cell + a]].insert(&snapshot.cells[cell], &snapshot.cells[cell] + n_corners);
      return neighbours;
    }

    /// Groups of nodes none of which share a neighbour: what answers to a motion of a whole group tells them apart.
    std::vector<std::vector<std::uint32_t>> group_apart(const std::vector<std::set<std::uint32_t>> &neighbours)
    {
      std::vector<unsigned int>               colour(neighbours.size());
      std::vector<std::vector<std::uint32_t>> groups;
      for (std::uint32_t n = 0; n < neighbours.size(); ++n)
        {
          std::set<unsigned int> taken;
          for (const std::uint32_t m : neighbours[n])
            for (const std::uint32_t other : neighbours[m])
              if (other < n)
                taken.insert(colour[other]);
          unsigned int free = 0;
          while (taken.count(free) > 0)
            ++free;
          colour[n] = free;
          groups.resize(std::max<std::size_t>(groups.size(), free + 1));
          groups[free].push_back(n);
        }
      return groups;
    }

    /// M^{-1/2} K M^{-1/2} over the free unknowns, K by moving groups of nodes with the blade's own verbs; `number`
    /// gives the row of an unknown, -1 where it is held. Shells must lie in a plane z = const: the rotation about their
    /// normal, which has no stiffness, is left out.
    template <class AnyBlade>
    SparseMatrix scaled_stiffness(AnyBlade &blade, std::vector<Eigen::Index> &number)
    {
      const auto         nodes      = blade.nodes();
      const auto         neighbours = neighbours_of_nodes(blade.snapshot());
      const unsigned int n_unknowns = nodes.n_unknowns;
      Eigen::Index       n_free     = 0;
      for (std::size_t i = 0; i < n_unknowns * nodes.n; ++i)
        number.push_back(nodes.inverse_mass[i] > 0. && i % n_unknowns != 5 ? n_free++ : -1);

      // the lowest mode stands 1e-9 below the stiffness of a brick's thickness: nonlinear terms of the step must vanish
      const double step = 1e-10;
      Entries      entries;
      const auto   move = [&](const std::vector<std::uint32_t> &group, unsigned int c, double v) {
        for (const std::uint32_t n : group)
          nodes.velocity[n_unknowns * n + c] = number[n_unknowns * n + c] < 0 ? 0. : v;
        blade.drift(step);
        blade.compute_internal_forces();
        for (const std::uint32_t n : group)
          nodes.velocity[n_unknowns * n + c] = 0.;
      };
      for (const auto &group : group_apart(neighbours))
        for (unsigned int c = 0; c < n_unknowns; ++c)
          {
            move(group, c, 1.);
            for (const std::uint32_t n : group)
              for (const std::uint32_t m : neighbours[n])
                for (unsigned int d = 0; d < n_unknowns; ++d)
                  if (const std::size_t row = n_unknowns * m + d, column = n_unknowns * n + c;
                      number[row] >= 0 && number[column] >= 0)
                    entries.emplace_back(number[row], number[column],
                                         -nodes.force[row] / step / std::sqrt(nodes.mass[row] * nodes.mass[column]));
            move(group, c, -1.);
          }
      return make_square(n_free, entries);
    }

    std::vector<double> frequencies_of(const Eigen::VectorXd &eigenvalues, const unsigned int n)
    {
      std::vector<double> frequencies; // Hz
      for (unsigned int k = 0; k < n; ++k)
        frequencies.push_back(std::sqrt(eigenvalues[k]) / (2. * M_PI));
      return frequencies;
    }
  } // namespace

  template <class AnyBlade>
  std::vector<double> natural_frequencies(AnyBlade &blade, const unsigned int n_modes)
  {
    std::vector<Eigen::Index> number;
    const SparseMatrix        matrix = scaled_stiffness(blade, number), transpose = matrix.transpose();
    EXPECT_LT((matrix - transpose).norm(), 1e-7 * matrix.norm());
    Eigen::MatrixXd modes(matrix.rows(), n_modes + 6);
    for (Eigen::Index i = 0; i < modes.rows(); ++i)
      for (Eigen::Index k = 0; k < modes.cols(); ++k)
        modes(i, k) = std::sin(1. + 0.7 * i * (k + 1) + 0.01 * i * i);
    return frequencies_of(lowest_eigenvalues(symmetric_part(matrix), modes, 25), n_modes);
  }

  template std::vector<double> natural_frequencies(ShellBlade &, unsigned int);
  template std::vector<double> natural_frequencies(SolidBlade &, unsigned int);

  std::vector<double> scaled_frequencies(SolidBlade &blade, const unsigned int n_modes)
  {
    std::vector<Eigen::Index> number;
    const SparseMatrix        matrix   = scaled_stiffness(blade, number);
    const auto                nodes    = blade.nodes();
    const FieldSnapshot       snapshot = blade.snapshot();
    const double              k =
      blade.mass() / double(blade.n_elements()) / 16. * (blade.census().mass_scaling.largest_factor - 1.);
    Entries entries;
    for (std::size_t i = 0; i < 3 * nodes.n; ++i)
      if (number[i] >= 0)
        entries.emplace_back(number[i], number[i], 1.);
    for (std::size_t cell = 0; cell < snapshot.cells.size(); cell += 8)
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const std::size_t ends[2] = {3 * snapshot.cells[cell + v] + c, 3 * snapshot.cells[cell + v + 4] + c};
            for (const std::size_t i : ends)
              for (const std::size_t j : ends)
                if (number[i] >= 0 && number[j] >= 0)
                  entries.emplace_back(number[i], number[j],
                                       (i == j ? k : -k) / std::sqrt(nodes.mass[i] * nodes.mass[j]));
          }
    Eigen::MatrixXd modes(matrix.rows(), n_modes + 6);
    for (Eigen::Index i = 0; i < modes.size(); ++i)
      modes.data()[i] = std::sin(1. + 12.9898 * double(i % 7919) + double(i));
    const SparseMatrix mass = make_square(matrix.rows(), entries);
    return frequencies_of(lowest_eigenvalues(symmetric_part(matrix), mass, modes, 20), n_modes);
  }
} // namespace birdstrike::test
