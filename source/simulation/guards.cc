#include "simulation/guards.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace birdstrike
{
  namespace
  {
    constexpr double jet_ratio = 10., shock_ratio = 2.; // of v_0 and of c

    /// Of n entities with position(i, d) and velocity(i, d); id(i) of it.
    template <class Position, class Velocity, class Id>
    Mover find_fastest(const char *const kind, const std::size_t n, const Position &position, const Velocity &velocity,
                       const Id &id)
    {
      std::size_t fastest = 0;
      double      most    = -1.;
      for (std::size_t i = 0; i < n; ++i)
        {
          double square = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            square += velocity(i, d) * velocity(i, d) + 0. * position(i, d);
          if (!(square <= most)) // NaN, too
            {
              fastest = i;
              most    = square;
              if (!std::isfinite(square))
                break;
            }
        }
      if (n == 0)
        return {};
      return {{kind, id(fastest), {{position(fastest, 0), position(fastest, 1), position(fastest, 2)}}},
              std::sqrt(most)};
    }

    Mover find_fastest_node(const Scene &scene)
    {
      if (!scene.blade)
        return {};
      const FacetsView nodes = scene.blade->facets();
      if (!nodes.velocity)
        return {};
      return find_fastest(
        "node", nodes.n_nodes, [&](const std::size_t i, const unsigned int d) { return nodes.position[3 * i + d]; },
        [&](const std::size_t i, const unsigned int d) { return nodes.velocity[nodes.velocity_stride * i + d]; },
        [](const std::size_t i) { return i; });
    }

    Mover find_fastest_particle(const Scene &scene)
    {
      Mover fastest;
      for (const Projectile &each : scene.birds)
        {
          if (!each.bird)
            continue;
          const PointsView points = each.bird->points();
          const Mover      own    = find_fastest(
                    "particle", points.n, [&](const std::size_t i, const unsigned int d) { return points.position[d][i]; },
                    [&](const std::size_t i, const unsigned int d) { return points.velocity[d][i]; },
                    [&](const std::size_t i) { return each.first_id + points.id[i]; });
          if (own.where.kind && (!fastest.where.kind || !(own.speed <= fastest.speed)))
            fastest = own;
          if (!std::isfinite(fastest.speed))
            break;
        }
      return fastest;
    }

    void require_slow(const Mover &mover, const double limit)
    {
      if (!mover.where.kind || mover.speed <= limit)
        return;
      const std::string kind = mover.where.kind;
      FailureFacts      facts{std::isfinite(mover.speed) ? "A " + kind + " has run away"
                                                         : "The motion of a " + kind + " is no number",
                         "speed", mover.speed, "m/s", limit};
      facts.where   = mover.where;
      facts.details = "The limit is ten times the largest speed at first contact, and twice the speed of waves.";
      facts.advice  = "Reduce Time/Step scale and Time/Bird step scale, and check the last fields there.";
      throw NumericalFailure(std::move(facts));
    }

    /// The number of an element that has these nodes; none: -1. At most once in a run.
    long find_element(const FieldSnapshot &blade, const std::array<std::uint32_t, 4> &nodes)
    {
      const auto number = std::ranges::find(blade.fields, std::string("element"), &Field::name);
      if (number == blade.fields.end())
        return -1;
      const std::size_t n_corners = std::size_t(1) << blade.dim;
      for (std::size_t cell = 0; cell < number->values.size(); ++cell)
        {
          const auto corner = blade.cells.begin() + static_cast<std::ptrdiff_t>(cell * n_corners);
          const auto end    = corner + static_cast<std::ptrdiff_t>(n_corners);
          if (std::ranges::all_of(nodes, [&](const std::uint32_t n) { return std::find(corner, end, n) != end; }))
            return std::lround(number->values[cell]);
        }
      return -1;
    }
  } // namespace

  Mover find_fastest(const Scene &scene)
  {
    const Mover node = find_fastest_node(scene), particle = find_fastest_particle(scene);
    return particle.where.kind && !(particle.speed <= node.speed) && std::isfinite(node.speed) ? particle : node;
  }

  void name_fastest(const Scene &scene, NumericalFailure &failure)
  {
    if (failure.facts().where.kind)
      return;
    const Mover fastest = find_fastest(scene);
    failure.add_entity(fastest.where, fmt::format("the fastest, {:.4g} m/s", fastest.speed));
  }

  Guards::Guards(const CaseParameters &parameters, const Scene &scene)
    : largest_penetration(parameters.contact.largest_penetration)
    , initial_speed(std::max(find_fastest_node(scene).speed, find_fastest_particle(scene).speed))
  {
    for (const Projectile &each : scene.birds)
      {
        const PointsView points = each.bird->points();
        liquid_sound_speed =
          std::max(liquid_sound_speed, *std::max_element(points.sound_speed, points.sound_speed + points.n));
        shock_slope = std::max(shock_slope, points.hugoniot_slope);
      }
    if (scene.blade && scene.blade->is_deformable())
      for (const auto &[number, of_section] : parameters.blade.by_section())
        {
          const double young = of_section.is_laminate() ? of_section.laminate.largest_young()
                                                        : of_section.material.metal().elasticity.young;
          metal_sound_speed  = std::max(metal_sound_speed, std::sqrt(young / of_section.density()));
        }
  }

  void Guards::check_motion(const Scene &scene, const double kinetic_energy) const
  {
    double speed = initial_speed;
    if (scene.blade && scene.blade->is_deformable())
      speed = std::max(speed, std::sqrt(2. * kinetic_energy / scene.blade->mass()));
    const double shock = liquid_sound_speed + shock_slope * speed;
    require_slow(find_fastest_particle(scene), jet_ratio * speed + shock_ratio * shock);
    if (scene.blade && scene.blade->is_deformable())
      require_slow(find_fastest_node(scene), jet_ratio * speed + shock_ratio * std::max(metal_sound_speed, shock));
  }

  void Guards::check_penetration(const Scene &scene) const
  {
    for (const Projectile &each : scene.birds)
      if (each.is_here() && each.contact)
        check_penetration(each, *scene.blade);
  }

  void Guards::check_penetration(const Projectile &projectile, const Blade &blade) const
  {
    const ContactReport &report = projectile.contact->report();
    const PointsView     points = projectile.bird->points();
    if (report.penetration <= largest_penetration * points.spacing)
      return;
    const std::uint32_t i = report.deepest_point;
    FailureFacts        facts{"A particle is stuck in the blade, or has come through it",
                       "penetration over particle spacing",
                       report.penetration / points.spacing,
                       "-",
                       largest_penetration,
                       "Contact/Largest penetration"};
    facts.where        = {"particle",
                          projectile.first_id + points.id[i],
                          {{points.position[0][i], points.position[1][i], points.position[2][i]}}};
    const auto element = find_element(blade.snapshot(), blade.facets().nodes[report.deepest_facet]);
    facts.details =
      element < 0
        ? fmt::format("It is {:.3g} m below the surface, of facet {}.", report.penetration, report.deepest_facet)
        : fmt::format("It is {:.3g} m below the surface, of element {}.", report.penetration, element);
    facts.advice = "Reduce Time/Bird step scale, refine the blade there, or raise Contact/Stiffness scale.";
    throw NumericalFailure(std::move(facts));
  }
} // namespace birdstrike
