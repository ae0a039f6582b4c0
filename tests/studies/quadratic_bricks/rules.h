#pragma once

#include <array>

namespace birdstrike::studies
{
  /// Points of a rule on [-1, 1], and there the quadratic Lagrange polynomials of the nodes -1, 0, 1 and their slopes.
  template <int n_points>
  struct Rule
  {
    static constexpr int                        n = n_points;
    std::array<double, n_points>                weight{};
    std::array<std::array<double, 3>, n_points> value{}, slope{};
    /// The points are the nodes: values are copies.
    bool is_collocated = false;

    constexpr Rule(const std::array<double, n_points> &points, const std::array<double, n_points> &weights)
      : weight(weights)
    {
      for (int q = 0; q < n_points; ++q)
        {
          const double x = points[q];
          value[q]       = {0.5 * x * (x - 1.), 1. - x * x, 0.5 * x * (x + 1.)};
          slope[q]       = {x - 0.5, -2. * x, x + 0.5};
        }
      is_collocated = n_points == 3 && points[0] == -1. && points[1] == 0. && points[n_points - 1] == 1.;
    }
  };

  inline constexpr Rule<2> gauss_2{{-0.57735026918962576451, 0.57735026918962576451}, {1., 1.}};
  inline constexpr Rule<3> gauss_3{{-0.77459666924148337704, 0., 0.77459666924148337704}, {5. / 9., 8. / 9., 5. / 9.}};
  inline constexpr Rule<5> gauss_5{
    {-0.90617984593866399280, -0.53846931010568309104, 0., 0.53846931010568309104, 0.90617984593866399280},
    {0.23692688505618908751, 0.47862867049936646804, 128. / 225., 0.47862867049936646804, 0.23692688505618908751}};
  inline constexpr Rule<3> lobatto_3{{-1., 0., 1.}, {1. / 3., 4. / 3., 1. / 3.}};
} // namespace birdstrike::studies
