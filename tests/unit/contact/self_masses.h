#pragma once

#include "free_masses.h"

#include <birdstrike/contact/self_contact.h>

#include <cmath>
#include <map>
#include <vector>

namespace birdstrike::test
{
  /// Bodies that only translate, each carrying some patches of nodes and facets, or (body -1) nodes that are free; and
  /// their contact with one another as one surface. Velocity-Verlet; works are booked as parts book them.
  struct SelfMasses
  {
    struct Body
    {
      double mass = 0.;
      Point3 velocity{0., 0., 0.};
    };

    FreeMasses        masses;
    std::vector<int>  body_of_node;
    std::vector<Body> body;
    SelfContact       contact;
    double            work = 0.; ///< J, of contact on everything

    explicit SelfMasses(const double damping_ratio = SelfContact::default_damping_ratio) : contact(damping_ratio)
    {
    }

    /// The nodes added since the last call become a body (`mass` shared evenly), or free nodes of that mass together.
    void close_body(const double mass, const Point3 &velocity, const bool is_free = false)
    {
      const std::size_t begin = body_of_node.size(), n = masses.node.size() - begin;
      for (std::size_t k = begin; k < masses.node.size(); ++k)
        {
          masses.node[k].inverse_mass = static_cast<double>(n) / mass;
          masses.node[k].velocity     = velocity;
          body_of_node.push_back(is_free ? -1 : static_cast<int>(body.size()));
        }
      if (!is_free)
        body.push_back({mass, velocity});
    }

    void compute(const double step)
    {
      contact.update(masses.facets(), step);
    }

    void advance(const double step)
    {
      kick(0.5 * step, true);
      for (FreeMasses::Node &n : masses.node)
        n.position += step * n.velocity;
      compute(step);
      kick(0.5 * step, false);
    }

    double kinetic() const
    {
      double sum = 0.;
      for (const Body &b : body)
        sum += 0.5 * b.mass * b.velocity.squaredNorm();
      for (std::size_t n = 0; n < masses.node.size(); ++n)
        if (body_of_node[n] < 0)
          sum += 0.5 * masses.node[n].velocity.squaredNorm() / masses.node[n].inverse_mass;
      return sum;
    }

    double height(const std::size_t first, const std::size_t last, const bool lowest) const
    {
      double z = masses.node[first].position[2];
      for (std::size_t n = first; n < last; ++n)
        z = lowest ? std::min(z, masses.node[n].position[2]) : std::max(z, masses.node[n].position[2]);
      return z;
    }

    Point3 force_sum(Point3 *moment = nullptr) const
    {
      Point3 sum(0., 0., 0.);
      for (const NodalForce &f : contact.forces())
        {
          const Point3 force(f.force.data());
          sum += force;
          if (moment)
            *moment += masses.node[f.node].position.cross(force);
        }
      return sum;
    }

    double largest_force() const
    {
      double largest = 0.;
      for (const NodalForce &f : contact.forces())
        largest = std::max(largest, Point3(f.force.data()).norm());
      return largest;
    }

  private:
    void kick(const double half, const bool is_first)
    {
      std::vector<Point3> on_body(body.size(), Point3(0., 0., 0.));
      std::vector<Point3> before;
      for (const FreeMasses::Node &n : masses.node)
        before.push_back(n.velocity);
      for (const NodalForce &f : contact.forces())
        {
          const Point3 force(f.force.data());
          if (const int b = body_of_node[f.node]; b >= 0)
            on_body[static_cast<std::size_t>(b)] += force;
          else
            masses.node[f.node].velocity += half * masses.node[f.node].inverse_mass * force;
        }
      for (std::size_t b = 0; b < body.size(); ++b)
        body[b].velocity += half / body[b].mass * on_body[b];
      for (std::size_t n = 0; n < masses.node.size(); ++n)
        if (const int b = body_of_node[n]; b >= 0)
          masses.node[n].velocity = body[static_cast<std::size_t>(b)].velocity;
      for (const NodalForce &f : contact.forces())
        work += half * Point3(f.force.data()).dot(is_first ? masses.node[f.node].velocity : before[f.node]);
    }
  };
} // namespace birdstrike::test
