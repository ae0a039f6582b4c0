#pragma once

#include <birdstrike/blade/blade.h>
#include <birdstrike/blade/parameters.h>
#include <birdstrike/core/thread_pool.h>

#include <memory>

namespace birdstrike
{
  /// A blade of quadrilateral shells: deal.II mesh, DoFs and vectors, our own element and nodal loops.
  ///
  ///   m dv/dt = f_elements + f_loads + f_contact - alpha m v,   held unknowns: v = 0.
  /// Damping acts as the factor exp(-alpha dt/2) in every internal half kick (unconditionally stable); its work is
  /// booked as dissipated. Held unknowns book the impulse they take. Kinetic energy is reported as
  ///   m |v^n|^2 / 2 - (|J_i|^2 + |J_c|^2) / (2 m),   J the impulses of the last second half kicks,
  /// the product of neighbouring half-step velocities, which closes against trapezoidal work (Belytschko et al.,
  /// "Nonlinear Finite Elements", 2014, box 6.1).
  ///
  /// Not here: erosion, spin of the hub, several ranks.
  class ShellBlade : public Blade
  {
  public:
    /// Throws InputError. The pool must outlive the blade.
    ShellBlade(const BladeParameters &parameters, ThreadPool &pool);
    ~ShellBlade() override;

    std::string kind() const override;
    bool        is_deformable() const override;
    StepLimit   step_limit() const override;
    double      largest_stable_step() const override;

    void kick_internal(double half_step, HalfKick half) override;
    void kick_contact(double half_step, HalfKick half) override;
    void drift(double step) override;
    void compute_internal_forces() override;
    void clear_contact_forces() override;

    FacetsView               facets() override;
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

    /// Raw nodal arrays, node-major, for initial states and checks. Velocities may be set between steps.
    struct Nodes
    {
      std::size_t   n;
      const double *reference;    ///< [n][3], m
      const double *position;     ///< [n][3], m
      const double *displacement; ///< [n][6], m and summed rotation increments, rad
      double       *velocity;     ///< [n][6], m/s, rad/s
      const double *force;        ///< [n][6], of elements, N and N m
      const double *mass;         ///< [n][6], kg and kg m^2, of held unknowns too
      const double *inverse_mass; ///< [n][6], 0 where held
    };
    Nodes nodes();

  private:
    struct State;
    std::unique_ptr<State> state;
  };
} // namespace birdstrike
