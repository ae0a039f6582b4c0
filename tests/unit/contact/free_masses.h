#pragma once

#include <birdstrike/contact/contact.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace birdstrike::test
{
  inline constexpr double g = 1.5e-3; // offset of a 1 mm point from a plate of 2 mm
  inline constexpr double h = 0.5e-3; // offset of a 1 mm point from a skin
  inline constexpr double k = 1e6;    // N/m, rho c^2 V^(1/3) of a 1 mm point

  inline ContactParameters without_damper()
  {
    ContactParameters parameters;
    parameters.damping_scale = 0.;
    return parameters;
  }

  /// Free points and free (or held) nodes without internal forces, advanced by velocity-Verlet; books contact works and
  /// the kinetic energy of neighbouring half steps, so that a linear spring closes the balance exactly.
  struct FreeMasses
  {
    struct Point
    {
      Point3 position, velocity{0., 0., 0.};
      double mass = 1e-6, density = 1000., sound_speed = 1000.;
    };
    struct Node
    {
      Point3 position, velocity{0., 0., 0.};
      double inverse_mass = 0.;
    };

    std::vector<Node>                         node;
    std::vector<std::array<std::uint32_t, 4>> facet;
    std::vector<std::array<std::int32_t, 4>>  neighbor;
    std::vector<double>                       half_thickness;
    double                                    spacing = 1e-3, hugoniot_slope = 0.;
    bool                                      two_sided       = true;
    std::uint64_t                             points_revision = 1, facets_revision = 0;
    SymmetryPlane                             plane;

    /// Facets of a structured patch of nx x ny cells; map(i, j) gives a node.
    template <class Map>
    void add_patch(const unsigned int nx, const unsigned int ny, const double thickness, const Map &map)
    {
      const auto first       = static_cast<std::uint32_t>(node.size()),
                 first_facet = static_cast<std::uint32_t>(facet.size());
      for (unsigned int j = 0; j <= ny; ++j)
        for (unsigned int i = 0; i <= nx; ++i)
          node.push_back({map(i, j)});
      for (unsigned int j = 0; j < ny; ++j)
        for (unsigned int i = 0; i < nx; ++i)
          {
            const std::uint32_t n  = first + j * (nx + 1) + i;
            const std::int32_t  f  = static_cast<std::int32_t>(first_facet + j * nx + i),
                               row = static_cast<std::int32_t>(nx);
            facet.push_back({n, n + 1, n + nx + 2, n + nx + 1});
            neighbor.push_back(
              {j > 0 ? f - row : -1, i + 1 < nx ? f + 1 : -1, j + 1 < ny ? f + row : -1, i > 0 ? f - 1 : -1});
            half_thickness.push_back(0.5 * thickness);
          }
    }

    /// A flat patch in z = height, cells of side `cell`, lower corner (x0, y0).
    void add_plate(const unsigned int nx, const unsigned int ny, const double cell, const double thickness,
                   const Point3 &corner = Point3(0., 0., 0.))
    {
      add_patch(nx, ny, thickness, [&](const unsigned int i, const unsigned int j) {
        return Point3(corner + Point3(i * cell, j * cell, 0.));
      });
    }

    /// Takes a facet away; its neighbours there have a free edge.
    void remove_facet(const std::int32_t gone)
    {
      facet.erase(facet.begin() + gone);
      neighbor.erase(neighbor.begin() + gone);
      half_thickness.erase(half_thickness.begin() + gone);
      for (auto &neighbors : neighbor)
        for (std::int32_t &other : neighbors)
          other = other == gone ? FacetsView::free_edge : other > gone ? other - 1 : other;
      ++facets_revision;
    }

    void add_point(const Point &p)
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          x[d].push_back(p.position[d]);
          v[d].push_back(p.velocity[d]);
          point_force[d].push_back(0.);
        }
      mass.push_back(p.mass);
      density.push_back(p.density);
      sound_speed.push_back(p.sound_speed);
      id.push_back(static_cast<std::uint32_t>(id.size()));
    }

    PointsView points() const
    {
      PointsView view;
      view.n = id.size();
      for (unsigned int d = 0; d < 3; ++d)
        {
          view.position[d] = x[d].data();
          view.velocity[d] = v[d].data();
        }
      view.mass        = mass.data();
      view.density     = density.data();
      view.sound_speed = sound_speed.data();
      view.id          = id.data();
      view.n_ids       = id.size();
      view.spacing     = spacing;
      if (!id.empty())
        {
          view.undeformed_density     = density.front();
          view.undeformed_sound_speed = sound_speed.front();
        }
      view.hugoniot_slope = hugoniot_slope;
      view.revision       = points_revision;
      view.plane          = plane;
      return view;
    }

    FacetsView facets()
    {
      node_position.resize(3 * node.size());
      node_velocity.resize(6 * node.size());
      inverse_mass.resize(node.size());
      for (std::size_t n = 0; n < node.size(); ++n)
        {
          inverse_mass[n] = node[n].inverse_mass;
          for (unsigned int d = 0; d < 3; ++d)
            {
              node_position[3 * n + d] = node[n].position[d];
              node_velocity[6 * n + d] = node[n].velocity[d];
            }
        }
      FacetsView view;
      view.n_nodes         = node.size();
      view.position        = node_position.data();
      view.velocity        = node_velocity.data();
      view.inverse_mass    = inverse_mass.data();
      view.velocity_stride = 6; // as a shell has it: translations first
      view.n_facets        = facet.size();
      view.nodes           = facet.data();
      view.neighbor        = neighbor.data();
      view.half_thickness  = half_thickness.data();
      view.two_sided       = two_sided;
      view.revision        = facets_revision;
      view.plane           = plane;
      return view;
    }

    void compute_contact(Contact &contact, const double step, ThreadPool &pool)
    {
      for (auto &component : point_force)
        std::fill(component.begin(), component.end(), 0.);
      node_force.assign(6 * node.size(), 0.);
      contact.add_forces(
        points(), facets(), step,
        {{{point_force[0].data(), point_force[1].data(), point_force[2].data()}}, {node_force.data(), 6}}, pool);
    }

    Point3 force_on_point(const std::size_t i) const
    {
      return {point_force[0][i], point_force[1][i], point_force[2][i]};
    }
    Point3 force_on_node(const std::size_t n) const
    {
      return {node_force[6 * n], node_force[6 * n + 1], node_force[6 * n + 2]};
    }
    Point3 position(const std::size_t i) const
    {
      return {x[0][i], x[1][i], x[2][i]};
    }
    Point3 velocity(const std::size_t i) const
    {
      return {v[0][i], v[1][i], v[2][i]};
    }
    void place(const std::size_t i, const Point3 &p)
    {
      for (unsigned int d = 0; d < 3; ++d)
        x[d][i] = p[d];
    }
    /// Moves it there within one step, at the velocity of that drift.
    void fly_to(const std::size_t i, const Point3 &p, const double step)
    {
      for (unsigned int d = 0; d < 3; ++d)
        v[d][i] = (p[d] - x[d][i]) / step;
      place(i, p);
    }

    /// One step from forces that are up to date.
    void advance(Contact &contact, const double step, ThreadPool &pool)
    {
      kick(0.5 * step, true);
      for (std::size_t i = 0; i < id.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          x[d][i] += step * v[d][i];
      for (Node &n : node)
        n.position += step * n.velocity;
      compute_contact(contact, step, pool);
      kick(0.5 * step, false);
    }

    Point3 momentum() const
    {
      Point3 sum(0., 0., 0.);
      for (std::size_t i = 0; i < id.size(); ++i)
        sum += mass[i] * velocity(i);
      for (const Node &n : node)
        if (n.inverse_mass > 0.)
          sum += n.velocity / n.inverse_mass;
      return sum;
    }

    double contact_work = 0.; ///< J, on points and nodes

    std::array<std::vector<double>, 3> x, v, point_force;
    std::vector<double>                mass, density, sound_speed;
    std::vector<std::uint32_t>         id;
    std::vector<double>                node_position, node_velocity, node_force, inverse_mass;

  private:
    void kick(const double half_step, const bool is_first)
    {
      const auto kick_one = [&](Point3 velocity, const Point3 &force, const double inverse) {
        const Point3 after = velocity + half_step * inverse * force;
        contact_work += half_step * force.dot(is_first ? after : velocity);
        return after;
      };
      for (std::size_t i = 0; i < id.size(); ++i)
        {
          const Point3 after = kick_one(velocity(i), force_on_point(i), 1. / mass[i]);
          for (unsigned int d = 0; d < 3; ++d)
            v[d][i] = after[d];
        }
      for (std::size_t n = 0; n < node.size(); ++n)
        node[n].velocity = kick_one(node[n].velocity, force_on_node(n), node[n].inverse_mass);
    }
  };

  /// Two by two cells of 10 mm, 2 mm thick, fixed, middle node at (10, 10) mm.
  inline FreeMasses plate_of_four()
  {
    FreeMasses scene;
    scene.add_plate(2, 2, 0.01, 2e-3);
    return scene;
  }
} // namespace birdstrike::test
