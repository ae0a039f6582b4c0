#pragma once

#include "simulation/projectile/projectile.h"
#include <birdstrike/contact/report.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/report/balance.h>
#include <birdstrike/structure/histories.h>
#include <birdstrike/time_control/schedule.h>
#include <birdstrike/time_control/smallest_step.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;
  class Blade;
  class SelfContact;
  class PatchForces;

  /// Which parts exist, and where they are when the clock starts. A part that the case lacks is never built: a rigid
  /// target has no finite elements, a blade alone no particles, a bird alone no contact.
  ///
  /// The flight before first touch is not computed but skipped in closed form: the bird is moved along its velocity,
  /// relative to the blade where it aims,
  /// until its first particle touches, and the clock starts there.
  struct Scene
  {
    ThreadPool                   pool;
    std::unique_ptr<Blade>       blade;
    std::vector<Projectile>      birds;             ///< with their contacts, if there is a blade
    std::unique_ptr<SelfContact> self_contact;      ///< of a deformable blade
    BladeHistories               histories;         ///< that the case asks for
    PatchForces                 *patches = nullptr; ///< of these, if there is contact

    /// @throws InputError for a case without parts, a bird that misses the blade or starts inside it.
    explicit Scene(const CaseParameters &parameters);
    ~Scene();

    /// The next macro step: the parts' votes with the scale factors of the case; none for an absent part.
    ///
    /// While there is contact, the blade's step is no longer than the touches of a full layer of particles allow its
    /// nodes (Contact::node_step_limit): several bird steps within one of a light blade would move it by strains that
    /// its elements do not see until the step ends.
    ///
    /// The bird's step grows by at most 2 % from step to step, and starts as if the whole bird were in the shocked
    /// state of first touch: Verlet's energy holds for a constant step, and a step that shrinks by a third while the
    /// shock builds up loses sum F^2 (dt_old^2 - dt_new^2)/(8 m), measured as 0.8 % of the bird's energy.
    ///
    /// @throws NumericalFailure for a step that collapses (Time/Smallest step).
    Schedule plan(double remaining);

    /// Within the macro step of the latest plan: how many blade steps what `n_steps` of `step` (s) are left for now
    /// takes. More where elements have become stiffer than they bear.
    /// @throws NumericalFailure as `plan` where the step collapses.
    unsigned int divide_blade_steps(double step, unsigned int n_steps);

    /// Birds that wait and are near now (s since the clock started) are computed from now on.
    void wake_birds(double now);

    bool        has_bird() const;         ///< that is computed, or waits
    bool        has_contact() const;      ///< of such a bird
    std::size_t n_particles_here() const; ///< of birds that are computed now
    double      flight_time() const;      ///< s, skipped before the first touch of any bird

    /// What all contacts have done in their last calls, those that have gone too. add_up_contacts() is to be called
    /// after each.
    const ContactReport &contact_report() const;
    void                 add_up_contacts();

    /// The latest plan; a scene that has just been built has made its first.
    const Schedule &last_plan() const;

    /// Energies and momenta of the whole scene, of birds that have gone too.
    SystemState state() const;

    /// Where the blade's surface may be from `now` on within `horizon` (s) at its present nodal velocities.
    Box compute_reach_of_blade(double now, double horizon) const;

    /// All parts, and what the next plan depends on. A bird that the archived scene has dropped is dropped here.
    void archive(Archive &archive);

    /// Lists made so far: of neighbours, of contact pairs, of points through the thickness, of facets left. Only a step
    /// that makes one may ask for memory, if it is longer than any before.
    std::uint64_t n_list_changes() const;

  private:
    const CaseParameters &parameters;
    Schedule              latest;
    double                largest_bird_step;                                                 // s, for the next plan
    double                largest_step_in_contact = std::numeric_limits<double>::infinity(); // s, of the blade
    SmallestStep          smallest_blade_step;
    const char           *advice_on_crushed_elements;
    double                seen_from_hub = 0.; // J, see SystemState
    ContactReport         all_contacts;       // of several birds

    void place_birds();
    void limit_multirate();
    template <class Predicate>
    double limit_of_layers(const Predicate &counts) const; ///< s, of the blade

    std::optional<StepVote> vote_of_birds(double remaining);
    double                  limit_in_contact(double bird_step) const; ///< s, of the blade
    void                    watch_patches();
  };
} // namespace birdstrike
