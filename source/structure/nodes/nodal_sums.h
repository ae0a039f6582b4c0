#pragma once

#include "structure/nodes/nodal_mechanics.h"

#include <algorithm>
#include <functional>

// The loops over nodes that NodalMechanics is made of; included where its members are defined.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  template <class Body>
  void NodalMechanics<n_unknowns>::for_nodes(const Body &body)
  {
    pool.parallel_for(n_nodes, grain * chunk, std::cref(body));
  }

  template <unsigned int n_unknowns>
  template <class Term>
  auto NodalMechanics<n_unknowns>::sum_nodes(const Term &term) const -> Sums
  {
    const auto body = [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        {
          Sums sums{};
          for (std::size_t n = c * chunk; n < std::min(n_nodes, (c + 1) * chunk); ++n)
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
          Eight sums[3][n] = {};
          for (std::size_t i = n_unknowns * c * chunk; i < std::min(n_padded, n_unknowns * (c + 1) * chunk); i += block)
            for (std::size_t k = 0; k < 3; ++k)
              term(i + 8 * k, sums[k]);
          for (std::size_t q = 0; q < n; ++q)
            for (std::size_t i = 0; i < n_unknowns; ++i)
              {
                const auto at  = [&](const std::size_t j) { return sums[j / 8][q][j % 8]; };
                double     sum = at(i);
                for (std::size_t k = 1; k < nodes_in_block; ++k)
                  sum += at(k * n_unknowns + i);
                partial[c][n_unknowns * q + i] = sum;
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
