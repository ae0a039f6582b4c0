#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/mesh/node_columns.h>

#include <array>
#include <span>

namespace birdstrike
{
  /// A mass matrix with more inertia against what happens within the columns of a layered body (NodeColumns), and no
  /// more against their translation:
  ///
  ///   v.M_s v = sum_n m_n |v_n|^2 + sum_edges k_e |v_above - v_below|^2,   k_e the coupling of an edge (kg),
  ///
  /// selective mass scaling in the form of Cocchetti, Pagani & Perego (2013) and, for several layers, Confalonieri,
  /// Ghisi & Perego (2015). Per component it is a tridiagonal matrix for each column. The same for all
  /// components and directions: total mass and momentum are those of the nodes, and angular momentum x x M_s v changes
  /// by the moments of forces alone (v x M_s v = 0), at any rotation. Held unknowns are rows that do not move.
  ///
  /// Rather than accelerations, which kicks would need a second path for, it gives effective forces
  ///   f_eff = f + q_above - q_below,   q_e = k_e (a_above - a_below) what an edge carries,   a = M_s^{-1} f:
  /// f_eff/m is the acceleration a, their sum is that of f, and on a held unknown f_eff is what its support takes. With
  /// a = f_eff/m (0 where held) the q_e of a column solve a tridiagonal system of their own, one smaller than M_s.
  ///
  /// Arrays are node-major with three components. Results do not depend on the number of threads.
  class ColumnMass
  {
  public:
    /// `coupling` (kg) by place in the columns, not negative, without meaning at the last place of each; `inverse_mass`
    /// [n_nodes][3] (1/kg), 0 where held. The pool must outlive this.
    /// Sums leave out the edges whose first node is no owned one, less than `n_owned`.
    ColumnMass(const NodeColumns &columns, std::vector<double> coupling, const double *inverse_mass,
               std::size_t n_owned, ThreadPool &pool);

    /// effective + external kicks by m^{-1} as force + external do by M_s^{-1}; `external` may be null.
    void compute_effective_forces(const double *force, const double *external, double *effective);

    /// sum of k_e term(i, j) over the edges and the three components, i and j the entries of the edge's two nodes.
    template <class Term>
    double sum_edges(const Term &term) const
    {
      return pool.ordered_sum(coupling.size(), [&](const std::size_t begin, const std::size_t end) {
        double sum = 0.;
        for (std::size_t p = begin; p < end; ++p)
          if (is_booked(p))
            for (unsigned int c = 0; c < 3; ++c)
              sum += coupling[p] * term(3 * std::size_t(nodes[p]) + c, 3 * std::size_t(nodes[p + 1]) + c);
        return sum;
      });
    }

    /// sum k_e (x_above - x_below) x (v_above - v_below), what M_s adds to the angular momentum of the nodes (N m s).
    std::array<double, 3> angular_momentum(const double *position, const double *velocity) const;

    std::size_t bytes() const;

  private:
    /// Of L D L^T for the forces that the edges of a column carry, by place and component (the fourth is not used): l
    /// below the diagonal, towards the edge below, and 1/d; 0 where nothing couples. And 1/m of the place's node.
    struct alignas(32) Factor
    {
      double lower[4], inverse_pivot[4], inverse_mass[4];
    };
    struct alignas(32) Work
    {
      double right[4], force[4];
    };

    bool is_booked(const std::size_t place) const
    {
      return coupling[place] > 0. && nodes[place] < n_owned;
    }
    template <class External>
    void compute_column(std::size_t column, const double *force, double *effective, const External &external);

    static constexpr std::size_t columns_per_chunk = 512;

    ThreadPool                &pool;
    std::size_t                n_owned;
    std::vector<std::uint32_t> nodes, begin;
    std::vector<double>        coupling;
    AlignedVector<Factor>      factors; ///< [n_nodes]
    AlignedVector<Work>        work;    ///< [n_nodes]
  };
} // namespace birdstrike
