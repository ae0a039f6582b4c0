#include "simulation/projectile/projectile.h"

#include "simulation/projectile/from_position.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/bird/shape.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/io/aimed_surface.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike
{
  namespace
  {
    /// Spacings between bird and blade at which a bird waits no longer: contact reaches half a one.
    constexpr double reach = 2.;

    std::unique_ptr<BirdParameters> along(const std::array<double, 3> &span, const BirdParameters &bird)
    {
      auto own  = std::make_unique<BirdParameters>(bird);
      own->span = span;
      return own;
    }

    Box extent_of(const PointsView &points)
    {
      Box box;
      for (std::size_t p = 0; p < points.n; ++p)
        {
          const Point3 x(points.position[0][p], points.position[1][p], points.position[2][p]);
          box.add(x.data());
          if (points.plane.exists())
            box.add(Point3(x[0], -x[1], x[2]).data());
        }
      return box;
    }

    /// Whether a particle of one bird is nearer than half of both spacings to one of the other.
    bool are_in_touch(const PointsView &a, const PointsView &b)
    {
      const double near = 0.5 * (a.spacing + b.spacing);
      if (extent_of(a).separation(extent_of(b)) > near)
        return false;
      using Cell         = std::array<long, 3>;
      const auto cell_of = [&](const PointsView &points, const std::size_t p) {
        Cell cell;
        for (unsigned int d = 0; d < 3; ++d)
          cell[d] = std::lround(points.position[d][p] / near);
        return cell;
      };
      std::set<Cell> taken;
      for (std::size_t p = 0; p < a.n; ++p)
        taken.insert(cell_of(a, p));
      for (std::size_t p = 0; p < b.n; ++p)
        if (taken.contains(cell_of(b, p)))
          return true;
      return false;
    }
  } // namespace

  Projectile::Projectile(const BirdCase &parameters, const std::array<double, 3> &span, const TimeParameters &time,
                         ThreadPool &pool)
    : number(parameters.number)
    , own(along(span, parameters.bird))
    , parameters(*own)
    , liquid(parameters.liquid)
    , bird(std::make_unique<Bird>(*own, parameters.liquid, pool))
    , smallest_step(number == 1 ? "bird" : "bird " + std::to_string(number), time.smallest_step)
    , at_start{bird->n_particles(), bird->packing().mass(), bird->energies().kinetic, bird->momenta().momentum}
    , n_at_start(bird->state().size())
  {
  }

  Projectile::Projectile(Projectile &&) noexcept = default;
  Projectile::~Projectile()                      = default;

  void Projectile::place(Blade &blade, const BladeParameters &of_blade, const ContactParameters &contact_parameters)
  {
    contact = std::make_unique<Contact>(contact_parameters);
    if (parameters.position.empty())
      first_touch = place_at_first_touch(*bird, blade, parameters);
    else
      {
        first_touch        = place_at_position(*bird, blade, *own);
        own->aimed_surface = find_aimed_surface(parameters, of_blade);
      }
    contact->hold_patches(blade.facets());
    bird->set_closing_speed(first_touch.closing_speed);
    is_waiting = parameters.arrival > 0.;
    last_touch = parameters.arrival;
    extent     = extent_of(bird->points());
    aim        = compute_aim(*this, blade);
  }

  bool Projectile::wake(const FacetsView &facets, const double step, const double now)
  {
    // what the blade reaches as the bird sees it, now and after two steps: the next one is hardly longer than the last
    const Point3 own(parameters.velocity.data());
    Box          blade;
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t n : facets.nodes[f])
        {
          const Point3 x(facets.position + 3 * n);
          const Point3 then = x + 2. * step * (Point3(facets.velocity + facets.velocity_stride * n) - own);
          blade.add(x.data(), facets.half_thickness[f]);
          blade.add(then.data(), facets.half_thickness[f]);
        }
    if (facets.n_facets > 0 && extent.separation(blade) > reach * bird->points().spacing)
      return false;
    wake(now);
    return true;
  }

  void Projectile::wake(const double now)
  {
    is_waiting = false;
    last_touch = std::max(now, parameters.arrival);
    bird->update_neighbor_list();
    bird->compute_rates();
    contact->begin_at(now);
    log().info("Section '{}': from t = {} on this bird is close enough for contact.", parameters.section,
               format_quantity(now, "s"));
  }

  void Projectile::drift(const double step)
  {
    bird->drift(step);
    if (is_waiting)
      for (unsigned int d = 0; d < 3; ++d)
        {
          extent.low[d] += step * parameters.velocity[d];
          extent.high[d] += step * parameters.velocity[d];
        }
  }

  double Projectile::passing_time() const
  {
    return Shape(parameters).whole_diameter() / first_touch.closing_speed;
  }

  bool Projectile::is_contact_softened() const
  {
    return largest_blade_step <= bird->strike_step();
  }

  EnergyReport Projectile::energies() const
  {
    return bird ? bird->energies() : gone_energy;
  }

  MomentumReport Projectile::momenta() const
  {
    return bird ? bird->momenta() : gone_momentum;
  }

  const ContactReport &Projectile::contact_report() const
  {
    return contact ? contact->report() : gone_contact;
  }

  BirdOfRun Projectile::report(const bool is_one_of_several) const
  {
    BirdOfRun report{number, first_id, bird.get(), at_start, aim, parameters.arrival, {}, n_retired};
    if (is_one_of_several)
      for (unsigned int d = 0; const double impulse : momenta().contact_impulse)
        report.impulse[d++] = -impulse;
    return report;
  }

  void Projectile::drop()
  {
    if (contact)
      gone_contact = contact->report();
    gone_energy         = bird->energies();
    gone_momentum       = bird->momenta();
    gone_energy.retired = gone_energy.total();
    gone_energy.retired_made += gone_energy.elastic + gone_energy.dissipated - gone_energy.internal;
    gone_energy.kinetic = gone_energy.staggering = gone_energy.elastic = gone_energy.dissipated = 0.;
    gone_energy.internal                                                                        = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      {
        gone_momentum.retired[d] += gone_momentum.momentum[d];
        gone_momentum.retired_moment[d] += gone_momentum.angular_momentum[d];
      }
    gone_momentum.momentum = gone_momentum.angular_momentum = {};
    contact.reset();
    bird.reset();
  }

  void require_apart(const std::vector<Projectile> &birds)
  {
    for (std::size_t a = 0; a < birds.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (are_in_touch(birds[a].bird->points(), birds[b].bird->points()))
          throw InputError("Section '" + birds[a].parameters.section + "': this bird starts inside that of section '" +
                           birds[b].parameters.section +
                           "'.\nAim it elsewhere, or let it come later (Arrival time): birds do not meet one another.");
  }

  void add_up(const std::vector<Projectile> &birds, ContactReport &sum)
  {
    auto patches = std::move(sum.patch_pressures);
    sum          = {};
    std::fill(patches.begin(), patches.end(), 0.);
    for (const Projectile &each : birds)
      {
        const ContactReport &one = each.contact_report();
        for (unsigned int d = 0; d < 3; ++d)
          sum.force[d] += one.force[d];
        for (auto energy :
             {&ContactReport::stored_energy, &ContactReport::dissipation_power, &ContactReport::dissipated_energy,
              &ContactReport::released_energy, &ContactReport::staggering, &ContactReport::dissipation_fall})
          sum.*energy += one.*energy;
        for (auto largest : {&ContactReport::largest_frequency, &ContactReport::penetration,
                             &ContactReport::max_penetration, &ContactReport::max_penetration_over_spacing})
          sum.*largest = larger(sum.*largest, one.*largest);
        for (auto count : {&ContactReport::calls, &ContactReport::skipped, &ContactReport::searches,
                           &ContactReport::reused, &ContactReport::pairs_listed, &ContactReport::pairs_tested,
                           &ContactReport::points_near, &ContactReport::points_active, &ContactReport::touches})
          sum.*count += one.*count;
        sum.n_touching += one.n_touching;
        patches.resize(std::max(patches.size(), one.patch_pressures.size()), 0.);
        for (std::size_t k = 0; k < one.patch_pressures.size(); ++k)
          patches[k] += one.patch_pressures[k];
      }
    sum.patch_pressures = std::move(patches);
  }
} // namespace birdstrike
