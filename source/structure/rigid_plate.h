#pragma once

#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/parameters.h>

#include <vector>

namespace birdstrike
{
  /// A surface that does not deform: a rectangle of one facet, or the facets of a mesh. No finite element and no
  /// DoFHandler is built. It is fixed, or free to move along its normal with a given mass (a body in a frictionless
  /// guide):
  ///   M dw/dt = F_contact . n;  what the guide or the ground takes is booked as impulse on the supports.
  /// Halved by y = 0, it computes with the half y >= 0 and half the mass, and reports the whole.
  class RigidPlate : public Blade
  {
  public:
    explicit RigidPlate(const BladeParameters &parameters);

    BladeKind kind() const override;
    bool      is_deformable() const override;
    StepLimit step_limit() const override;

    void       kick_internal(double half_step, HalfKick half) override;
    void       kick_contact(double half_step, HalfKick half) override;
    void       drift(double step) override;
    void       compute_internal_forces() override;
    NodeForces clear_contact_forces() override;

    void                     archive(Archive &archive) override;
    FacetsView               facets() const override;
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
    TipDeflection            tip_deflection() const override; ///< displacement along the normal, positive with the bird
    std::vector<PeakPlasticStrain> peak_plastic_strains() const override;

    double speed() const; ///< m/s along the normal

  private:
    void   move(); ///< its nodes, to the present displacement and speed
    Point3 centre() const;

    SurfaceMesh make_rectangle(const BladeParameters::Rigid &parameters) const;
    void        take_mesh(SurfaceMesh mesh);
    Point3      total_force() const; ///< N, of contact on what is computed

    SymmetryPlane         plane;
    SurfaceMesh           surface;
    std::vector<double>   reference, position, velocity, force; ///< [n][3]
    std::vector<double>   inverse_mass, half_thickness;
    std::array<double, 3> normal;
    bool                  is_free;
    bool                  is_turned = false;   ///< the bird flies against the normal
    double                plate_mass;          ///< kg, if free, of what is computed
    double                normal_speed   = 0.; ///< m/s
    double                displacement   = 0.; ///< m along the normal
    double                second_impulse = 0.; ///< N s, of the last second half kick
    double                last_half      = 0.; ///< s, of the last half kick
    EnergyReport          energy;
    MomentumReport        momentum;
  };
} // namespace birdstrike
