#pragma once

#include "simulation/projectile/aim.h"
#include "simulation/projectile/first_touch.h"
#include <birdstrike/contact/report.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/box.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/energy_report.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/run_view.h>
#include <birdstrike/time_control/smallest_step.h>

#include <cmath>
#include <memory>
#include <vector>

namespace birdstrike
{
  class Bird;
  class Blade;
  class Contact;
  class ThreadPool;

  /// One bird of a scene, its contact with the blade, and what is left of both when they have gone.
  ///
  /// A bird that arrives later waits: it flies on at its velocity, undeformed, and neither forces nor rates are
  /// computed, until something of the blade is near enough to be met in the next step.
  ///
  /// Birds do not meet one another: each is a body of its own, of its own liquid and particles.
  class Projectile
  {
  public:
    /// `span`: of the blade, unit.
    Projectile(const BirdCase &parameters, const std::array<double, 3> &span, const TimeParameters &time,
               ThreadPool &pool);
    Projectile(Projectile &&) noexcept;
    ~Projectile();

    const unsigned int number; ///< 1: section Bird

  private:
    std::unique_ptr<BirdParameters> own; // with the span, and what follows from a position

  public:
    const BirdParameters    &parameters;
    const EosParameters     &liquid;
    std::unique_ptr<Bird>    bird;    ///< none once it has gone
    std::unique_ptr<Contact> contact; ///< none once it has gone, or without a blade
    FirstTouch               first_touch;
    SmallestStep             smallest_step;
    StrikeAim                aim;
    std::size_t              first_id = 0; ///< of its particles in files

    // What reports ask for.
    BirdAtStart   at_start;
    std::size_t   n_at_start = 0; ///< particles that are computed
    std::size_t   n_retired = 0, n_dropped = 0;
    double        largest_blade_step = INFINITY; ///< s, that touches of a full layer of particles allow the nodes
    double        last_touch         = 0.;       ///< s
    double        time_gone          = -1.;      ///< s
    unsigned long n_steps_with       = 0;
    double        reachable_impulse  = 0.; ///< N s, of the particles left when its phase ended

    /// Puts it at the first touch of the blade, which it waits for if that comes later, or at its position, and gives
    /// it a contact.
    void place(Blade &blade, const BladeParameters &of_blade, const ContactParameters &contact);

    bool is_to_come() const ///< a later bird that has struck nothing yet
    {
      return parameters.arrival > 0. && contact && contact_report().peak_force == 0.;
    }
    bool is_here() const ///< and not waiting: it is computed
    {
      return bird != nullptr && !is_waiting;
    }
    double passing_time() const; ///< s, in which it closes in by its own diameter

    /// Whether the blade is so light that contact is softened for the step with which particles meet it.
    bool is_contact_softened() const;

    bool waits() const
    {
      return is_waiting;
    }

    /// Waits no longer if the blade is so near, or anyway; `step` (s): the longest that the next one may be, `now` (s
    /// since the clock started). Returns whether it has been woken.
    bool wake(const FacetsView &facets, double step, double now);
    void wake(double now);

    void drift(double step); ///< s

    EnergyReport         energies() const;
    MomentumReport       momenta() const;
    const ContactReport &contact_report() const;
    BirdOfRun            report(bool is_one_of_several) const;

    /// Bird and contact are released; their last reports stay.
    void drop();

    void archive(Archive &archive, const Blade *blade);

  private:
    bool           is_waiting = false;
    Box            extent; // m, of a bird that waits
    EnergyReport   gone_energy;
    MomentumReport gone_momentum;
    ContactReport  gone_contact;
  };

  /// Throws InputError, naming both, where one bird starts inside another.
  void require_apart(const std::vector<Projectile> &birds);

  /// What all contacts did together, into `sum`, which keeps its memory.
  void add_up(const std::vector<Projectile> &birds, ContactReport &sum);
} // namespace birdstrike
