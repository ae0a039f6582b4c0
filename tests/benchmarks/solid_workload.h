#pragma once

#include "structure/elements/solid/elements.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace birdstrike::benchmarks
{
  struct SolidCase
  {
    SolidFormulation formulation = SolidFormulation::one_point;
    bool             is_plastic  = false;
  };

  /// A plate of about n bricks in four layers (edges of 2 mm, Ti-6Al-4V with linear hardening) that is stretched and
  /// bent.
  ///
  /// Elastic: forth and back by 1e-6 of strain. Plastic: after 2 % of strain, further by 2e-5 a step, of which a third
  /// is bending: every element yields in every step.
  struct SolidWorkload
  {
    SolidWorkload(const std::size_t n, const std::size_t n_threads, const SolidCase &what)
      : pool(n_threads)
      , is_plastic(what.is_plastic)
      , n_span(static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / n_layers)))
      , n_chord(n / n_layers / n_span)
      , elements(make_nodes(), make_cells(), make_section(what), pool)
    {
      const std::vector<Point3> nodes = make_nodes();
      force.resize(3 * nodes.size());
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
      for (std::size_t d = 0; d < position.size(); ++d)
        position[d] += increment[d];
      elements.compute_internal_forces(position.data(), increment.data(), 0.3e-6, force.data());
      if (!is_plastic)
        for (double &du : increment)
          du = -du;
    }

    std::size_t n() const
    {
      return elements.n_elements();
    }

    static constexpr double      edge     = 2e-3; ///< m
    static constexpr std::size_t n_layers = 4;

    ThreadPool          pool;
    bool                is_plastic;
    std::size_t         n_span, n_chord;
    SolidElements       elements;
    std::vector<double> position, increment, force;

  private:
    static SolidSection make_section(const SolidCase &what)
    {
      SolidSection section;
      section.formulation                = what.formulation;
      section.material.hardening.law     = HardeningLaw::linear;
      section.material.hardening.modulus = 1.25e9;
      return section;
    }

    std::vector<Point3> make_nodes() const
    {
      std::vector<Point3> nodes;
      for (std::size_t k = 0; k <= n_layers; ++k)
        for (std::size_t j = 0; j <= n_chord; ++j)
          for (std::size_t i = 0; i <= n_span; ++i)
            nodes.push_back(edge * Point3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
      return nodes;
    }

    std::vector<std::array<std::uint32_t, 8>> make_cells() const
    {
      // layers of one column after each other, as a swept mesh has them
      const auto row = static_cast<std::uint32_t>(n_span + 1), layer = row * static_cast<std::uint32_t>(n_chord + 1);
      std::vector<std::array<std::uint32_t, 8>> cells;
      for (std::uint32_t j = 0; j < n_chord; ++j)
        for (std::uint32_t i = 0; i < n_span; ++i)
          for (std::uint32_t k = 0; k < n_layers; ++k)
            {
              const std::uint32_t a = i + row * j + layer * k, b = a + layer;
              cells.push_back({a, a + 1, a + row, a + row + 1, b, b + 1, b + row, b + row + 1});
            }
      return cells;
    }

    /// u_x = (strain + curvature z) x, z from the middle, and the deflection that goes with it.
    void set_increment(const std::vector<Point3> &nodes, const double strain)
    {
      const double half = 0.5 * edge * n_layers, curvature = strain / 3. / half, length = edge * n_span;
      increment.clear();
      for (const Point3 &x : nodes)
        {
          // bending to and fro along the plate keeps the deflection small
          const double phase = 8. * M_PI * x[0] / length, slope = std::sin(phase) * length / (8. * M_PI);
          increment.insert(increment.end(), {strain * x[0] + curvature * (x[2] - half) * slope, 0.,
                                             curvature * std::cos(phase) * std::pow(length / (8. * M_PI), 2)});
        }
    }
  };
} // namespace birdstrike::benchmarks
