#pragma once

#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/timing.h>
#include <birdstrike/time_control/schedule.h>

#include <cstdint>

namespace birdstrike
{
  class Bird;
  class Blade;
  class Contact;
  class ContactWatch;
  class SelfContact;
  class ThreadPool;

  /// One macro step of whatever parts a scene has: velocity-Verlet with both parts synchronous at its ends.
  ///
  /// The bird with its contact may take several steps within it (r-RESPA by impulses; Tuckerman, Berne and Martyna
  /// 1992), or the blade. What the bird takes in two half kicks at the ends of its step, a blade of several steps takes
  /// evenly in those that follow: an impulse would ring modes of the blade that are faster than the macro step. (Bricks
  /// of 2.1 mm under a bird of 5 mm particles: impulses leave 68 J in the bulk viscosity within 1 ms, a single rate 1
  /// J.) The two are equal and opposite, whatever the ratio; what is under way between them counts as the blade's.
  /// Parts are named, not owned; an absent part costs nothing.
  class Stepper
  {
  public:
    struct Parts
    {
      Bird         *bird         = nullptr;
      Blade        *blade        = nullptr;
      Contact      *contact      = nullptr;
      ThreadPool   *pool         = nullptr;
      ContactWatch *watch        = nullptr; ///< told of every evaluation of contact
      SelfContact  *self_contact = nullptr; ///< of the blade
    };
    struct Counts
    {
      std::uint64_t bird           = 0; ///< bird steps
      std::uint64_t blade          = 0; ///< blade steps
      std::uint64_t particle_steps = 0;
      std::uint64_t element_steps  = 0;
      /// What a single rate would have done more.
      std::uint64_t particle_steps_not_done = 0, element_steps_not_done = 0;
    };

    Stepper(const Parts &parts, Timings &timings);

    /// Forces at the present state, so that a first kick has them.
    void compute_initial_forces(double step);

    void advance(const Schedule &schedule);

    /// The bird has gone: from now on the blade runs on alone.
    void drop_bird();

    const Counts &counts() const;

  private:
    void advance_with_sub_cycled_blade(const Schedule &schedule);
    void advance_with_sub_cycled_bird(const Schedule &schedule);
    void kick_bird(double half_step, HalfKick half);
    void kick_contact(double half_step, HalfKick half);
    void set_in_transit(double duration);
    void deliver();                                                  ///< what is in transit, at once
    void step_blade(double step, double contact_half, bool is_last); ///< the last one is not finished
    void finish_blade_step(double step);
    void compute_blade_forces(double step);
    void compute_bird_forces(double step);

    Parts    parts;
    Timings &timings;
    Counts   done;
    double   in_transit = 0.; ///< s, for which the contact forces have still to act on the blade
    struct Sections
    {
      std::size_t bird_rates, bird_motion, blade_forces, blade_motion, contact;
    } sections;
  };
} // namespace birdstrike
