#pragma once

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/material/metal.h>

#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"

#include <cmath>
#include <memory>

/// A bird on a plate with contact, shells and bricks of two sections and all formulations in a prescribed motion beyond
/// yield and failure, in numbers that fill no register.
namespace archive_width
{
  using namespace birdstrike;

  /// A part with its own stepping.
  struct Part
  {
    virtual ~Part()                      = default;
    virtual void step(unsigned int k)    = 0;
    virtual void archive(Archive &state) = 0;
  };

  /// Particles of 6 mm on a fixed plate of 7 x 7 facets.
  class BirdOnPlate : public Part
  {
  public:
    explicit BirdOnPlate(ThreadPool &pool) : pool(pool), bird(parameters(), EosParameters(), pool), contact({})
    {
      for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i)
          position.insert(position.end(), {edge * (i - 0.5 * n), edge * (j - 0.5 * n), 0.});
      for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i)
          {
            const std::uint32_t a = i + (n + 1) * j;
            nodes.push_back({a, a + 1, a + n + 2, a + n + 1});
            const auto f = static_cast<std::int32_t>(i + n * j);
            neighbors.push_back({j > 0 ? f - static_cast<std::int32_t>(n) : -1, i + 1 < n ? f + 1 : -1,
                                 j + 1 < n ? f + static_cast<std::int32_t>(n) : -1, i > 0 ? f - 1 : -1});
          }
      still.assign(position.size(), 0.);
      force.assign(position.size(), 0.);
      half_thickness.assign(nodes.size(), 0.001);
      double lowest = INFINITY;
      bird.set_state([&](Point3 &x, Point3 &, double &) { lowest = std::min(lowest, x[2]); });
      bird.set_state([&](Point3 &x, Point3 &, double &) { x[2] += 0.0045 - lowest; });
      exchange();
    }
    void step(unsigned int) override
    {
      bird.kick(0.5 * dt, HalfKick::first);
      bird.drift(dt);
      exchange();
      bird.kick(0.5 * dt, HalfKick::second);
    }
    void archive(Archive &state) override
    {
      bird.archive(state);
      contact.archive(state, bird.points(), facets());
    }

  private:
    static constexpr std::uint32_t n    = 7;
    static constexpr double        edge = 0.01, dt = 5e-7; // m, s

    static BirdParameters parameters()
    {
      BirdParameters of;
      of.spacing        = 0.006;
      of.velocity       = {{10., 5., -177.}};
      of.aim_point      = {{0., 0., 0.}};
      of.pair_precision = PairPrecision::as_double; // round-off of floats would hide what is wrong by less
      return of;
    }
    FacetsView facets() const
    {
      FacetsView view;
      view.n_nodes        = position.size() / 3;
      view.position       = position.data();
      view.velocity       = still.data();
      view.inverse_mass   = still.data();
      view.n_facets       = nodes.size();
      view.nodes          = nodes.data();
      view.neighbor       = neighbors.data();
      view.half_thickness = half_thickness.data();
      return view;
    }
    void exchange()
    {
      contact.add_forces(bird.points(), facets(), dt, {bird.clear_contact_forces(), {force.data(), 3}}, pool);
      bird.compute_rates();
    }

    ThreadPool                               &pool;
    Bird                                      bird;
    Contact                                   contact;
    std::vector<double>                       position, still, force, half_thickness;
    std::vector<std::array<std::uint32_t, 4>> nodes;
    std::vector<std::array<std::int32_t, 4>>  neighbors;
  };

  inline Metal make_metal(const bool can_fail)
  {
    Metal metal;
    metal.hardening.yield = 500e6;
    if (can_fail)
      metal.failure.law = FailureLaw::plastic_strain;
    metal.failure.plastic_strain = 0.022;
    return metal;
  }

  /// Elements whose nodes are pulled and bent, most at one end: at n_before some are elastic, some have yielded and
  /// some have failed; more do afterwards.
  template <class Elements, unsigned int n_unknowns>
  class Pulled : public Part
  {
  public:
    Pulled(const char *name, std::vector<Point3> nodes, Elements all)
      : name(name), reference(std::move(nodes)), elements(std::move(all)), force(n_unknowns * reference.size())
    {
      for (const Point3 &x : reference)
        position.insert(position.end(), {x[0], x[1], x[2]});
    }
    void step(const unsigned int k) override
    {
      std::vector<double> increment(n_unknowns * reference.size(), 0.);
      for (std::size_t node = 0; node < reference.size(); ++node)
        {
          const Point3 &x    = reference[node];
          const double  ramp = rate * x[0] * x[0] / length, slope = 4. * rate * x[0] / length;
          const double  stir = 0.1 * std::sin(1. + 7. * double(node) + k);
          const Point3  du(ramp * (1. + 0.2 * stir) - slope * x[2], 0.3 * ramp, 2. * ramp);
          for (int d = 0; d < 3; ++d)
            {
              increment[n_unknowns * node + d] = du[d];
              position[3 * node + d] += du[d];
            }
          if constexpr (n_unknowns == 6)
            increment[6 * node + 4] = -slope * (1. + stir);
        }
      elements.compute_internal_forces(position.data(), increment.data(), 1e-7, force.data());
    }
    void archive(Archive &state) override
    {
      const auto group = state.group(name);
      state.list("position", position);
      state.list("force", force);
      elements.archive(state, position.data());
    }

  private:
    static constexpr double length = 0.05, rate = 4e-4;

    const char         *name;
    std::vector<Point3> reference;
    Elements            elements;
    std::vector<double> position, force;
  };

  constexpr std::uint32_t nx = 7, ny = 3; // 21 elements

  /// Every third element yields later: two groups.
  template <class Section>
  Sections<Section> make_sections(const Section &section)
  {
    Section strong = section;
    strong.material.hardening.yield *= 1.2;
    std::vector<std::uint32_t> of_element;
    for (std::uint32_t e = 0; e < nx * ny; ++e)
      of_element.push_back(e % 3 == 0 ? 1 : 0);
    return {{section, strong}, of_element};
  }

  inline std::vector<Point3> make_layer(const double z)
  {
    std::vector<Point3> nodes;
    for (std::uint32_t j = 0; j <= ny; ++j)
      for (std::uint32_t i = 0; i <= nx; ++i)
        nodes.emplace_back(0.05 * i / nx, 0.02 * j / ny, z);
    return nodes;
  }

  inline std::unique_ptr<Part> make_shells(const char *name, const ShellFormulation formulation, const bool can_fail,
                                           ThreadPool &pool)
  {
    ShellSection section;
    section.formulation = formulation;
    section.material    = make_metal(can_fail);
    std::vector<std::array<std::uint32_t, 4>> cells;
    for (std::uint32_t j = 0; j < ny; ++j)
      for (std::uint32_t i = 0; i < nx; ++i)
        {
          const std::uint32_t a = i + (nx + 1) * j;
          cells.push_back({a, a + 1, a + nx + 2, a + nx + 1});
        }
    auto nodes = make_layer(0.);
    for (Point3 &x : nodes) // folded at right angles: a director for each sheet
      if (const double past = x[0] - nodes[nx / 2][0]; past > 0.)
        x += past * Point3(-1., 0., 1.);
    std::vector<double> thickness(cells.size(), 0.003);
    return std::make_unique<Pulled<ShellElements, 6>>(
      name, nodes, ShellElements(nodes, cells, thickness, make_sections(section), pool));
  }

  inline std::unique_ptr<Part> make_bricks(const char *name, const SolidFormulation formulation, const bool can_fail,
                                           ThreadPool &pool)
  {
    SolidSection section;
    section.formulation = formulation;
    section.material    = make_metal(can_fail);
    auto       nodes    = make_layer(0.);
    const auto top      = make_layer(0.003);
    const auto n_layer  = static_cast<std::uint32_t>(top.size());
    nodes.insert(nodes.end(), top.begin(), top.end());
    std::vector<std::array<std::uint32_t, 8>> cells;
    for (std::uint32_t j = 0; j < ny; ++j)
      for (std::uint32_t i = 0; i < nx; ++i)
        {
          const std::uint32_t a = i + (nx + 1) * j, b = a + n_layer;
          cells.push_back({a, a + 1, a + nx + 1, a + nx + 2, b, b + 1, b + nx + 1, b + nx + 2});
        }
    return std::make_unique<Pulled<SolidElements, 3>>(name, nodes,
                                                      SolidElements(nodes, cells, make_sections(section), pool));
  }

  struct Parts
  {
    ThreadPool                         pool{1};
    std::vector<std::unique_ptr<Part>> all;

    Parts()
    {
      all.push_back(std::make_unique<BirdOnPlate>(pool));
      all.push_back(make_shells("physical shells", ShellFormulation::one_point_physical, true, pool));
      all.push_back(make_shells("Belytschko-Tsay shells", ShellFormulation::belytschko_tsay, false, pool));
      all.push_back(make_shells("fully integrated shells", ShellFormulation::fully_integrated, true, pool));
      all.push_back(make_bricks("one-point bricks", SolidFormulation::one_point, true, pool));
      all.push_back(make_bricks("B-bar bricks", SolidFormulation::b_bar, true, pool));
      all.push_back(make_bricks("solid-shells", SolidFormulation::solid_shell, false, pool));
    }
    void advance(const unsigned int from, const unsigned int n)
    {
      for (unsigned int k = from; k < from + n; ++k)
        for (auto &part : all)
          part->step(k);
    }
    void archive(Archive &state)
    {
      for (auto &part : all)
        part->archive(state);
    }
    ArchivedState write()
    {
      ArchivedState state;
      Archive       archive = Archive::writing(state);
      this->archive(archive);
      return state;
    }
  };
} // namespace archive_width
