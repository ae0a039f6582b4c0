#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/fields.h>
#include <birdstrike/core/half_kick.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/core/step_limit.h>
#include <birdstrike/structure/choices.h>
#include <birdstrike/structure/histories.h>
#include <birdstrike/structure/modes.h>
#include <birdstrike/structure/reports.h>
#include <birdstrike/structure/rotor.h>

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace birdstrike
{
  /// How a place of the surface lies, against the undeformed blade.
  struct SurfaceMotion
  {
    Point3          displacement = Point3::Zero();              ///< m
    Matrix3<double> rotation     = Matrix3<double>::Identity(); ///< of the surface there
  };

  /// The struck part, in the verbs of velocity-Verlet. State is synchronous between steps: x^n, v^n, f^n.
  ///
  /// One step dt:  kick(dt/2, first), drift(dt), compute_internal_forces(), kick(dt/2, second), where a kick is
  /// `kick_internal` (elements, loads, damping) and `kick_contact` (what contact added to `clear_contact_forces()`);
  /// the two may be called at different rates (r-RESPA, Tuckerman et al. 1992). `drift` may be called several times
  /// before `compute_internal_forces`, which takes the whole increment since its last call.
  ///
  /// Units are SI. Verbs throw NumericalFailure when the state is lost. Reports are of the whole where half of it is
  /// computed; facets() and snapshot() are what is computed.
  class Blade
  {
  public:
    virtual ~Blade() = default;

    virtual BladeKind kind() const          = 0; ///< never none
    virtual bool      is_deformable() const = 0; ///< false: no internal force, no vote on the step
    virtual StepLimit step_limit() const    = 0;
    /// Its value alone (s), for every step: nothing is searched, no text is written.
    virtual double largest_stable_step() const
    {
      return step_limit().value;
    }

    virtual ElementPrices prices() const ///< of a rigid one: nothing
    {
      return {};
    }

    virtual void kick_internal(double half_step, HalfKick half) = 0;
    virtual void kick_contact(double half_step, HalfKick half)  = 0;
    virtual void drift(double step)                             = 0;
    virtual void compute_internal_forces()                      = 0;
    /// Sets the contact forces to zero and hands them over: contact adds to them.
    virtual NodeForces clear_contact_forces() = 0;

    /// The surface offered to contact; valid for the life of the blade.
    virtual FacetsView facets() const = 0;

    /// At present, of the place of the surface that undeformed lies nearest to this one.
    virtual SurfaceMotion motion_of(const Point3 &) const
    {
      return {};
    }

    /// Of each undeformed facet of a row of blades which it is of, 0 the one that is described; empty: one blade.
    virtual std::vector<std::uint32_t> blades_of_facets() const
    {
      return {};
    }

    /// Forces between nodes of the surface: adds to those of the present compute_internal_forces, which kick_internal
    /// kicks with. Once a step at most.
    virtual void add_internal_forces(std::span<const NodalForce> forces)
    {
      if (!forces.empty())
        throw std::logic_error("A blade of kind '" + blade_kinds().name(kind()) + "' has no internal forces.");
    }

    /// The frame of contact force history: sum of the present contact forces, N.
    virtual std::array<double, 3> contact_force() const = 0;

    /// All that the next step depends on, between steps; reading takes a blade of the same case that has not moved.
    virtual void archive(Archive &archive) = 0;

    virtual EnergyReport   energies() const = 0;
    virtual MomentumReport momenta() const  = 0;

    virtual std::size_t n_elements() const = 0;
    virtual std::size_t n_nodes() const    = 0;
    virtual double      mass() const       = 0; ///< kg; infinite for a fixed rigid body
    virtual BladeCensus census() const     = 0;

    virtual FieldSnapshot            snapshot() const = 0;
    virtual std::vector<ProbeValues> probes() const   = 0;

    /// Section forces at the support; empty lists where nothing is clamped.
    virtual RootSectionReport root_section() const   = 0;
    virtual TipDeflection     tip_deflection() const = 0;
    /// Of each section that has elements (a row: of each blade's); of failed elements too.
    virtual std::vector<PeakPlasticStrain> peak_plastic_strains() const = 0;

    /// Of each blade of a row, by place; empty: one blade.
    virtual std::vector<BladeLoads> loads_of_row() const
    {
      return {};
    }
    virtual std::vector<BladeBalance> balance_of_row() const
    {
      return {};
    }

    virtual FailureReport failure() const
    {
      return {};
    }

    /// Of the hub, where it turns; of the blade it is the motion but for strains. Null where it stands still.
    virtual const Rotor *rotor() const
    {
      return nullptr;
    }

    virtual StaticReport static_report() const ///< of the equilibrium that it started from
    {
      return {};
    }
    /// Static equilibrium with the loads of t = 0 and the spin of the hub; before the first step. What the constructor
    /// has found is kept. Throws NumericalFailure where there is none.
    /// InputError of a rigid surface, as compute_modes.
    virtual StaticReport find_equilibrium();
    /// The lowest n about the present equilibrium, and up to so many more as the unknowns allow.
    virtual VibrationModes compute_modes(std::size_t n, std::size_t n_spare = 0);

    /// What is asked for besides; the blade outlives it. Throws InputError, naming the entry, for what it cannot give.
    virtual BladeHistories make_histories(const HistoryRequests &requests) const;

    /// Nothing for a blade without a clamped root or without a tip row.
    virtual std::optional<SpanLine> span_line() const
    {
      return {};
    }
    /// Unit, from the middle of the sides at the root to that of those at the tip, undeformed. Nothing without both,
    /// and where the two lie at one place.
    virtual std::optional<Point3> span_direction() const
    {
      return {};
    }
  };
} // namespace birdstrike
