#pragma once

#include "structure/nodes/nodal_mechanics.h"
#include "structure/row_of_blades.h"
#include "structure/shell_kind.h"
#include "structure/solid_kind.h"
#include <birdstrike/structure/blade.h>

#include <algorithm>

namespace birdstrike
{
  /// A blade of finite elements: deal.II mesh and DoFs, our own element and nodal loops. Its nodes move as
  /// source/structure/nodes/nodal_mechanics.h says, which explains damping, held unknowns and the kinetic energy; the
  /// elements are those of source/structure/elements. What shells and bricks do differently stands in `Kind`, ShellKind
  /// or SolidKind.
  ///
  /// Elements of a metal that can fail do so (elements/erosion.h); what is left keeps the surface that contact meets,
  /// and nothing presses on what has failed.
  ///
  /// A hub that turns: the blade starts in the static equilibrium of its tension, what is held follows the rotation
  /// exactly, and root and tip are reported as somebody on the hub sees them; probes and fields are in fixed axes.
  ///
  /// Not here: several ranks.
  template <class Kind>
  class DeformableBlade final : public Blade
  {
  public:
    /// Throws InputError. The pool must outlive the blade.
    DeformableBlade(const BladeParameters &parameters, ThreadPool &pool);

    StepLimit step_limit() const override
    {
      return elements.step_limit();
    }
    double largest_stable_step() const override
    {
      return elements.largest_stable_step();
    }
    ElementPrices prices() const override
    {
      return elements.prices();
    }
    void kick_internal(const double half_step, const HalfKick half) override
    {
      motion.kick_internal(half_step, half);
    }
    void kick_contact(const double half_step, const HalfKick half) override
    {
      motion.kick_contact(half_step, half);
    }
    void drift(const double step) override
    {
      motion.drift(step);
    }
    void       compute_internal_forces() override;
    NodeForces clear_contact_forces() override
    {
      return motion.clear_contact_forces();
    }
    void          archive(Archive &archive) override;
    FacetsView    facets() const override;
    SurfaceMotion motion_of(const Point3 &place) const override;

    std::vector<std::uint32_t> blades_of_facets() const override
    {
      return mesh.surface().blades;
    }
    void add_internal_forces(const std::span<const NodalForce> forces) override
    {
      motion.add_internal_forces(forces);
    }
    std::array<double, 3> contact_force() const override
    {
      return plane.whole(motion.contact_force());
    }

    BladeKind kind() const override
    {
      return Kind::kind;
    }
    bool is_deformable() const override
    {
      return true;
    }
    std::size_t n_elements() const override
    {
      return plane.whole(mesh.n_owned_cells);
    }
    std::size_t n_nodes() const override
    {
      const auto &on_plane = mesh.symmetry_nodes; // ascending, owned ones first
      const auto  owned    = std::lower_bound(on_plane.begin(), on_plane.end(), mesh.space.n_owned());
      return plane.whole(mesh.space.n_owned(), owned - on_plane.begin());
    }
    double mass() const override
    {
      return plane.whole(lumped.total);
    }
    EnergyReport   energies() const override;
    MomentumReport momenta() const override
    {
      return plane.whole(motion.momenta());
    }
    BladeCensus              census() const override;
    FieldSnapshot            snapshot() const override;
    std::vector<ProbeValues> probes() const override
    {
      return motion.probes();
    }
    BladeHistories                 make_histories(const HistoryRequests &requests) const override;
    RootSectionReport              root_section() const override;
    TipDeflection                  tip_deflection() const override;
    std::vector<BladeLoads>        loads_of_row() const override;
    std::vector<BladeBalance>      balance_of_row() const override;
    std::vector<PeakPlasticStrain> peak_plastic_strains() const override;
    FailureReport                  failure() const override;
    std::optional<SpanLine>        span_line() const override;
    std::optional<Point3>          span_direction() const override;

    const Rotor *rotor() const override
    {
      return hub.turns() ? &hub : nullptr;
    }
    StaticReport static_report() const override
    {
      return prestress;
    }

    StaticReport   find_equilibrium() override;
    VibrationModes compute_modes(std::size_t n, std::size_t n_spare = 0) override;

    NodeArrays nodes() ///< for initial states and checks
    {
      return motion.arrays();
    }

  private:
    void  update_failed();          ///< after elements have failed
    Field contact_pressure() const; ///< of the whole surface, Pa
    void  count_sections(BladeCensus &census) const;

    SymmetryPlane                    plane;
    std::vector<unsigned int>        row; ///< places of the blades, pieces of the mesh
    typename Kind::Mesh              mesh;
    Rotor                            hub;
    Supports                         supports;
    SectionTable                     sections;
    std::vector<unsigned int>        n_layers; ///< of bricks, by section; see Kind
    typename Kind::Mesh::Mass        lumped;
    typename Kind::Elements          elements;
    PressedFacets                    pressed;
    NodalMechanics<Kind::n_unknowns> motion;
    std::vector<double>              stiffness; ///< of the elements in tension along the span of the root
    BladeRoles                       roles;
    typename Kind::Root              root;
    TipRow                           tip;
    RowOfBlades<Kind>                members;
    typename Kind::Surface           surface;
    MassScalingReport                scaling;
    bool                             can_fail;
    Warnings                         probe_warnings;
    std::size_t                      n_failed = 0; ///< elements, as the surface knows them
    BladeParameters::Spin            implicit;     ///< how equilibrium and modes are solved for
    StaticReport                     prestress;
  };

  using ShellBlade = DeformableBlade<ShellKind>;
  using SolidBlade = DeformableBlade<SolidKind>;
} // namespace birdstrike
