#pragma once

#include "structure/elements/shell/elements.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace birdstrike::benchmarks
{
  struct ShellCase
  {
    ShellFormulation formulation = ShellFormulation::one_point_physical;
    unsigned int     n_points    = 5;
    bool             is_plastic  = false;
  };

  /// A plate of about n square elements (5 x 5 x 4.27 mm, Ti-6Al-4V with linear hardening) that is stretched and bent.
  ///
  /// Elastic: forth and back by 1e-6 of strain. Plastic: after 2 % of strain, further by 2e-5 a step (as at 30/s in a
  /// step of 0.7 us), of which a third is bending with a wave length of 16 elements: every point of every element
  /// yields in every step.
  struct ShellWorkload
  {
    ShellWorkload(const std::size_t n, const std::size_t n_threads, const ShellCase &what)
      : pool(n_threads)
      , is_plastic(what.is_plastic)
      , n_span(static_cast<std::size_t>(std::sqrt(static_cast<double>(n))))
      , n_chord(n / n_span)
      , elements(make_nodes(), make_cells(), std::vector<double>(n_span * n_chord, thickness), make_section(what), pool)
    {
      const std::vector<Point3> nodes = make_nodes();
      force.resize(6 * nodes.size());
      for (const Point3 &x : nodes)
        position.insert(position.end(), {x[0], x[1], x[2]});
      if (is_plastic)
        for (int k = 0; k < 20; ++k)
          {
            set_increment(nodes, 1e-3);
            step();
          }
      set_increment(nodes, is_plastic ? 2e-5 : 1e-6);
    }

    /// Moves the nodes (about 1 ns an element) and computes the forces.
    void step()
    {
      for (std::size_t n = 0; n < position.size() / 3; ++n)
        for (std::size_t d = 0; d < 3; ++d)
          position[3 * n + d] += increment[6 * n + d];
      elements.compute_internal_forces(position.data(), increment.data(), 0.7e-6, force.data());
      if (!is_plastic)
        for (double &du : increment)
          du = -du;
    }

    std::size_t n() const
    {
      return elements.n_elements();
    }

    static constexpr double edge = 5e-3, thickness = 4.27e-3; ///< m

    ThreadPool          pool;
    bool                is_plastic;
    std::size_t         n_span, n_chord;
    ShellElements       elements;
    std::vector<double> position, increment, force;

  private:
    static ShellSection make_section(const ShellCase &what)
    {
      ShellSection section;
      section.formulation                = what.formulation;
      section.n_points                   = what.n_points;
      section.material.hardening.law     = HardeningLaw::linear;
      section.material.hardening.modulus = 1.25e9;
      return section;
    }

    std::vector<Point3> make_nodes() const
    {
      std::vector<Point3> nodes;
      for (std::size_t j = 0; j <= n_chord; ++j)
        for (std::size_t i = 0; i <= n_span; ++i)
          nodes.emplace_back(edge * static_cast<double>(i), edge * static_cast<double>(j), 0.);
      return nodes;
    }

    std::vector<std::array<std::uint32_t, 4>> make_cells() const
    {
      std::vector<std::array<std::uint32_t, 4>> cells;
      for (std::size_t j = 0; j < n_chord; ++j)
        for (std::size_t i = 0; i < n_span; ++i)
          {
            const auto a = static_cast<std::uint32_t>(i + (n_span + 1) * j), row = static_cast<std::uint32_t>(n_span);
            cells.push_back({a, a + 1, a + row + 2, a + row + 1});
          }
      return cells;
    }

    /// u_x = strain x, w = curvature/k^2 (1 - cos kx) with directors that stay normal.
    void set_increment(const std::vector<Point3> &nodes, const double strain)
    {
      const double k = 2. * std::numbers::pi / (16. * edge), curvature = strain / 3. / (0.5 * thickness);
      increment.clear();
      for (const Point3 &x : nodes)
        increment.insert(increment.end(), {strain * x[0], 0., curvature / (k * k) * (1. - std::cos(k * x[0])), 0.,
                                           -curvature / k * std::sin(k * x[0]), 0.});
    }
  };
} // namespace birdstrike::benchmarks
