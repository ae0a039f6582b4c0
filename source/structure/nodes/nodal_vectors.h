#pragma once

#include "structure/nodes/nodal_mechanics.h"

#include <birdstrike/core/simd/registers.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <functional>

// The vectors and the loops over nodes that NodalMechanics is made of; included where its members are defined.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  struct NodalMechanics<n_unknowns>::Vectors
  {
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    explicit Vectors(const NodeSpace &space)
    {
      const auto unknowns = space.unknowns(n_unknowns), coordinates = space.unknowns(3);
      for (Vector *v :
           {&displacement, &velocity, &increment, &force, &contact, &external, &received, &mass, &inverse_mass})
        v->reinit(unknowns);
      reference.reinit(coordinates);
      position.reinit(coordinates);
      node_inverse_mass.reinit(space.unknowns(1));
    }

    Vector displacement, velocity;   ///< m and rad, and per s
    Vector increment;                ///< of the displacement since the last forces
    Vector force, contact, external; ///< N and N m, of elements, of contact, of loads
    Vector received;                 ///< N s, impulse of contact that the kicks have given, for fields
    Vector mass, inverse_mass;       ///< kg and kg m^2; inverse 0 where held
    Vector reference, position;      ///< m, three entries a node
    Vector node_inverse_mass;        ///< 1/kg, an entry a node, 0 where all three are held
  };

  /// Eight entries of node-major arrays; not whole at the end of what is owned, where zeros stand for the rest.
  template <bool is_whole>
  struct Entries
  {
    std::size_t begin, n = 8;

    [[gnu::always_inline]] void read(const double *values, Eight &r) const
    {
      if constexpr (is_whole)
        birdstrike::read(values + begin, r);
      else
        {
          r = Eight{};
          std::memcpy(&r, values + begin, n * sizeof(double));
        }
    }
    [[gnu::always_inline]] void write(const Eight &r, double *values) const
    {
      std::memcpy(values + begin, &r, is_whole ? sizeof r : n * sizeof(double));
    }
  };

  template <unsigned int n_unknowns>
  template <class Body>
  void NodalMechanics<n_unknowns>::for_nodes(const std::size_t n, const Body &body)
  {
    pool.parallel_for(n, grain * chunk, std::cref(body));
  }

  template <unsigned int n_unknowns>
  template <class Term>
  auto NodalMechanics<n_unknowns>::sum_nodes(const Term &term) const -> Sums
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        {
          Sums sums{};
          for (std::size_t n = c * chunk; n < std::min(n_owned, (c + 1) * chunk); ++n)
            term(n, sums);
          partial[c] = sums;
        }
    };
    pool.parallel_for(partial.size(), grain, std::cref(body));
    Sums total{};
    for (const Sums &sums : partial)
      for (std::size_t k = 0; k < total.size(); ++k)
        total[k] += sums[k];
    return total;
  }

  template <unsigned int n_unknowns>
  template <std::size_t n, class Term>
  std::array<std::array<double, n_unknowns>, n> NodalMechanics<n_unknowns>::sum_components(const Term &term) const
  {
    constexpr std::size_t nodes_in_block = block / n_unknowns;
    static_assert(n * n_unknowns <= std::tuple_size_v<Sums>);
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        {
          Eight             sums[3][n] = {};
          const std::size_t last       = n_unknowns * std::min(n_owned, (c + 1) * chunk);
          std::size_t       i          = n_unknowns * c * chunk;
          for (; i + block <= last; i += block)
            for (std::size_t k = 0; k < 3; ++k)
              term(Entries<true>{i + 8 * k}, sums[k]);
          for (std::size_t k = 0; i + 8 * k < last; ++k)
            term(Entries<false>{i + 8 * k, std::min<std::size_t>(8, last - i - 8 * k)}, sums[k]);
          for (std::size_t q = 0; q < n; ++q)
            for (std::size_t j = 0; j < n_unknowns; ++j)
              {
                const auto at  = [&](const std::size_t e) { return sums[e / 8][q][e % 8]; };
                double     sum = at(j);
                for (std::size_t k = 1; k < nodes_in_block; ++k)
                  sum += at(k * n_unknowns + j);
                partial[c][n_unknowns * q + j] = sum;
              }
        }
    };
    pool.parallel_for(partial.size(), grain, std::cref(body));
    std::array<std::array<double, n_unknowns>, n> total{};
    for (const Sums &sums : partial)
      for (std::size_t q = 0; q < n; ++q)
        for (std::size_t i = 0; i < n_unknowns; ++i)
          total[q][i] += sums[n_unknowns * q + i];
    return total;
  }
} // namespace birdstrike
