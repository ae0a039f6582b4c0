#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/timing.h>
#include <birdstrike/time_control/schedule.h>

#include <cstdint>

namespace birdstrike
{
  class ContactWatch;
  struct Scene;

  /// One macro step of whatever parts a scene has: velocity-Verlet with both parts synchronous at its ends. Each verb
  /// is timed under its own name.
  ///
  /// The bird with its contact may take several steps within it (r-RESPA by impulses; Tuckerman, Berne and Martyna
  /// 1992), or the blade. What the bird takes in two half kicks at the ends of its step, a blade of several steps takes
  /// evenly in those that follow: an impulse would ring modes of the blade that are faster than the macro step. (Bricks
  /// of 2.1 mm under a bird of 5 mm particles: impulses leave 68 J in the bulk viscosity within 1 ms, a single rate 1
  /// J.) The two are equal and opposite, whatever the ratio; what is under way between them counts as the blade's.
  /// A part that the scene lacks costs nothing.
  class Stepper
  {
  public:
    struct Counts
    {
      std::uint64_t bird           = 0; ///< bird steps
      std::uint64_t blade          = 0; ///< blade steps
      std::uint64_t particle_steps = 0;
      /// What a single rate would have done more.
      std::uint64_t particle_steps_not_done = 0, blade_not_done = 0;
    };
    /// Run time, s.
    struct Seconds
    {
      double bird = 0., blade = 0., contact = 0.;
    };

    /// Scene and timings must outlive the stepper; a `watch` is told of every evaluation of contact.
    Stepper(Scene &scene, Timings &timings, ContactWatch *watch = nullptr);

    /// Forces at the present state, so that a first kick has them.
    void compute_initial_forces(double step);

    void advance(const Schedule &schedule);

    /// Before the scene drops its bird: the blade gets what is in transit, and from then on runs alone.
    void drop_bird();

    const Counts &counts() const;
    Seconds       seconds() const;

    void archive(Archive &archive);

  private:
    void advance_with_several_blade_steps(const Schedule &schedule);
    void advance_with_several_bird_steps(const Schedule &schedule);

    // The verbs, of one step or half step (s) each.
    void kick_bird(double half_step, HalfKick half);
    void kick_blade(double half_step, HalfKick half);
    void kick_blade_by_contact(double half_step, HalfKick half);
    void drift_bird(double step);
    void drift_blade(double step);
    void update_neighbor_list();
    void compute_blade_forces(double step);
    void compute_contact_forces(double step);
    void compute_bird_rates();

    void deliver();                       ///< what is in transit, at once
    void set_in_transit(double duration); ///< s

    template <class Part, class Verb>
    void timed(const Part &part, std::size_t section, const Verb &verb); ///< verb(*part), unless there is no such part

    Scene        &scene;
    Timings      &timings;
    ContactWatch *watch;
    Counts        done;
    double        in_transit = 0.; ///< s, for which the contact forces have still to act on the blade
    struct Sections
    {
      std::size_t bird_kick, blade_kick, contact_kick, bird_drift, blade_drift, list, blade_forces, self_contact,
        contact, rates;
    } sections;
  };
} // namespace birdstrike
