#pragma once

#include "structure/nodes/node_arrays.h"
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/parameters.h>

#include <memory>

namespace birdstrike
{
  /// A blade of hexahedra: deal.II mesh and DoFs, our own element and nodal loops. Its nodes have three displacements
  /// and move as source/structure/nodes/nodal_mechanics.h says; the elements are those of solid_elements.h.
  ///
  /// The same parameters make the shell and the solid of a part. What differs: clamped ids are faces whose nodes lose
  /// three displacements; pressure acts on the facets of Loads/Pressure boundaries, pushing inwards (on the built-in
  /// face at minus the normal this is the shell's direction); contact sees the skin, closed and one-sided, without any
  /// thickness beyond it; the tip row is the mean of both faces, the root stress that on both faces. Selective mass
  /// scaling (source/structure/nodes/mass_scaling.h) keeps thin layers from ruling the step.
  ///
  /// Elements of a metal that can fail do so (solid_elements.h); what is left keeps a closed skin (eroding_skin.h).
  ///
  /// Not here: spin of the hub, several ranks.
  class SolidBlade : public Blade
  {
  public:
    /// Throws InputError. The pool must outlive the blade.
    SolidBlade(const BladeParameters &parameters, ThreadPool &pool);
    ~SolidBlade() override;

    std::string kind() const override;
    bool        is_deformable() const override;
    StepLimit   step_limit() const override;
    double      largest_stable_step() const override;

    void       kick_internal(double half_step, HalfKick half) override;
    void       kick_contact(double half_step, HalfKick half) override;
    void       drift(double step) override;
    void       compute_internal_forces() override;
    NodeForces clear_contact_forces() override;
    void       set_contact_in_transit(double duration) override;

    FacetsView               facets() const override;
    void                     add_internal_forces(std::span<const NodalForce> forces) override;
    std::array<double, 3>    contact_force() const override;
    EnergyReport             energies() const override;
    MomentumReport           momenta() const override;
    std::size_t              n_elements() const override;
    std::size_t              n_nodes() const override;
    double                   mass() const override;
    BladeCensus              census() const override;
    FieldSnapshot            snapshot() const override;
    std::vector<ProbeValues> probes() const override;
    RootSectionReport        root_section() const override;
    TipDeflection            tip_deflection() const override;
    PeakPlasticStrain        peak_plastic_strain() const override;
    std::optional<SpanLine>  span_line() const override;
    FailureReport            failure() const override;

    NodeArrays nodes(); ///< for initial states and checks

  private:
    struct State;
    std::unique_ptr<State> state;
  };
} // namespace birdstrike
