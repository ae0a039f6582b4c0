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
  class ThreadPool;

  /// One macro step of whatever parts a scene has: velocity-Verlet with both parts synchronous at its ends.
  ///
  /// The bird with its contact, or the blade, may take several steps within it (r-RESPA by impulses; Tuckerman, Berne
  /// and Martyna 1992): contact acts on both parts in the same kicks, so that their impulses are equal and opposite
  /// whatever the ratio. Parts are named, not owned; an absent part costs nothing.
  class Stepper
  {
  public:
    struct Parts
    {
      Bird       *bird    = nullptr;
      Blade      *blade   = nullptr;
      Contact    *contact = nullptr;
      ThreadPool *pool    = nullptr;
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
    void kick_bird_and_contact(double half_step, HalfKick half);
    void step_blade(double step);
    void compute_blade_forces();
    void compute_bird_forces(double step);

    Parts    parts;
    Timings &timings;
    Counts   done;
    struct Sections
    {
      std::size_t bird_rates, bird_motion, blade_forces, blade_motion, contact;
    } sections;
  };
} // namespace birdstrike
