#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/timing.h>
#include <birdstrike/time_control/schedule.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  class ContactWatch;
  struct Scene;

  /// One macro step of whatever parts a scene has: velocity-Verlet with both parts synchronous at its ends. Each verb
  /// is timed under its own name.
  ///
  /// The bird may take several steps within it, or the blade (r-RESPA; Tuckerman, Berne and Martyna 1992): what the
  /// slower part's own forces do comes in impulses at the ends of the macro step, contact acts in every step of the
  /// faster one, on both sides at once. Between its impulses a bird moves by what contact does to it. (Contact once a
  /// step of the bird rings what is faster in the blade, or comes late if it is spread over the blade's steps.)
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
      std::uint64_t particle_steps_waited = 0; ///< of birds that waited while others were computed
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

    /// Once the scene has dropped its last bird: from then on the blade runs alone.
    void end_contact();

    const Counts &counts() const;
    Seconds       seconds() const;

    void archive(Archive &archive);

  private:
    void advance_with_several_bird_steps(const Schedule &schedule);

    // The verbs, of one step or half step (s) each.
    void kick_bird(double half_step, HalfKick half, double contact_half);
    void kick_bird_by_contact(double half_step, HalfKick half);
    void kick_blade(double half_step, HalfKick half);
    void kick_blade_by_contact(double half_step, HalfKick half);
    void drift_bird(double step);
    void drift_blade(double step);
    void update_neighbor_list();
    void compute_blade_forces(double step);
    void compute_contact_forces(double step);
    void compute_bird_rates();

    template <class Verb>
    void each_bird(std::size_t section, const Verb &verb); ///< verb(projectile), of those that are computed now
    template <class Part, class Verb>
    void timed(const Part &part, std::size_t section, const Verb &verb); ///< verb(*part), unless there is no such part

    Scene        &scene;
    Timings      &timings;
    ContactWatch *watch;
    Counts        done;

    std::vector<double> weights; ///< [nodes], of the touches of several birds
    struct Sections
    {
      std::size_t bird_kick, blade_kick, contact_kick, bird_drift, blade_drift, list, blade_forces, self_contact,
        contact, rates;
    } sections;
  };
} // namespace birdstrike
