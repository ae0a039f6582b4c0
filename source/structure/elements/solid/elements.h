#pragma once

#include "structure/elements/stored_energy.h"
#include "structure/elements/thickness_points.h"
#include <birdstrike/core/number.h>
#include <birdstrike/core/step_limit.h>
#include <birdstrike/core/thread_pool.h>
#include <birdstrike/material/metal.h>
#include <birdstrike/structure/choices.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace birdstrike
{
  /// What all solid elements of a blade share.
  struct SolidSection
  {
    SolidFormulation formulation = SolidFormulation::one_point;
    Metal            material;
    ThicknessRule    rule                = ThicknessRule::gauss; ///< of solid_shell, as n_points
    unsigned int     n_points            = 5;                    ///< through the thickness: 3, 5 or 7
    double           linear_viscosity    = 0.06;                 ///< b1 of rho l c b1, -
    double           quadratic_viscosity = 1.2;                  ///< b2, in compression only, -
  };

  /// State of one element for output.
  struct SolidState
  {
    std::array<double, 6> stress;             ///< xx, yy, zz, xy, yz, zx, Pa, global axes, mean of the element
    double                plastic_strain;     ///< equivalent, mean of the element, -
    double                max_plastic_strain; ///< largest of its points, -
    double                volume;             ///< m^3
  };

  /// Selective mass scaling of one element: `factor` (>= 1) times the inertia against differences along `axis` of its
  /// reference cube, 0, 1 or 2.
  struct MassScale
  {
    unsigned int axis   = 2;
    double       factor = 1.;
  };

  /// All 8-node bricks of a blade: their strain increments, stresses, internal forces and energies.
  ///
  /// Strains are taken on the midpoint geometry x - dx/2, forces on the end geometry; stresses are rotated by Hughes &
  /// Winget (1980). The law is Jaumann's rate of Kirchhoff's stress tau = J sigma with the moduli of small strain (Hill
  /// 1958),
  ///   tau' - w tau + tau w = C : d,   power over the volume at rest:  tau : d = d/dt (tau : C^{-1} : tau / 2),
  /// the second since C is isotropic: whatever the path, work is what is stored and no cycle makes energy. Of Cauchy's
  /// stress neither holds (2 % of the energy made or lost by a cycle of 10 % stretch and shear; an undamped cantilever
  /// made ten times its own in a hundred periods). Path-dependent it stays (Simo & Pister 1984): a cycle of elastic
  /// strain e leaves a stress of the order E e^3 (stabilisation: 0.3 E e^2). The flow stress is one of Kirchhoff's
  /// stress too; J - 1 is elastic, 0.2 % where titanium yields in tension. What is reported is Cauchy's. The theory
  /// stands in solid_one_point.h and solid_b_bar.h, plasticity in solid_law.h and solid_flow.h.
  ///
  /// Where the metal can fail (material/failure.h), a point with D >= 1 carries nothing from then on, and an element
  /// whose stated share of points has failed, or which has collapsed, neither (solid_erosion.h). Other metals pay
  /// nothing for it.
  ///
  /// Not here: mass of nodes, supports, loads, time. Throws InputError for a degenerate element or an impossible
  /// section, NumericalFailure when an element is turned inside out (unless Failure::smallest_step erodes it) or a
  /// force is not finite.
  class SolidElements
  {
  public:
    /// Nodes of a cell in lexicographic order (deal.II's): 0 (0,0,0), 1 (1,0,0), 2 (0,1,0), 3 (1,1,0), 4..7 the same at
    /// z = 1; positive volume. The pool must outlive this.
    SolidElements(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 8>> cells,
                  const SolidSection &section, ThreadPool &pool);
    ~SolidElements();
    SolidElements(SolidElements &&) noexcept;

    /// position [n_nodes][3] at t^{n+1} (m); increment [n_nodes][3] of displacement (m) since the last call, which took
    /// dt (s); force [n_nodes][3] is overwritten with what the elements exert on the nodes, -f_int (N).
    void compute_internal_forces(const double *position, const double *increment, double dt, double *force);

    /// The largest dt for which central differences are stable: 2/omega_max by a bound on the largest eigenvalue of
    /// every element, shortened by the bulk viscosity, for nodal masses that are not smaller than those of
    /// compute_nodal_masses. No safety factor.
    StepLimit step_limit() const;
    double    largest_stable_step() const; ///< s, the value of the same without its words: nothing is searched
    /// Masses (kg) that the nodes really carry, [n_nodes]: the bound then allows for shares other than an eighth.
    void use_nodal_masses(std::span<const double> mass);
    /// Scales masses, [n_elements]: the bound then counts with element masses of v.M v = sum over the four edges along
    /// the axis of  m (|v_a|^2 + |v_b|^2) + k |v_b - v_a|^2,  m = edge_mass, k = m (factor - 1)/2, which whoever owns
    /// the nodes adds up (ColumnMass). Throws InputError for an impossible scale.
    void scale_masses(std::span<const MassScale> scale);
    /// The smallest factor for each element and its axis with which its bound allows `step` (s); where none does, the
    /// one that allows most.
    std::vector<double> compute_mass_factors(std::span<const unsigned int> axis, double step) const;
    /// The step (s) that all elements allow at best, with the largest factors that help.
    double compute_reachable_step(std::span<const unsigned int> axis) const;
    double edge_mass(std::size_t element) const; ///< kg, that each node carries for it at least
    /// An eighth of each element's mass to each of its nodes (kg), [n_nodes].
    std::vector<double> compute_nodal_masses() const;

    /// Energies (J). Stored ones are those of the present stresses (StoredEnergy): elastic of the mean and of points,
    /// hourglass of the stabilisation, which with one layer is the energy of bending, no error. Plastic and viscous:
    /// cumulative, by their own rates; what the stabilisation dissipates is plastic work. `work` is that of the nodal
    /// forces, trapezoidal in time: what it differs from the sum of the others (and the eroded energy) is an error.
    StoredEnergy::Sums stored_energy() const; ///< elastic, hourglass
    double             elastic_energy() const;
    double             plastic_work() const;
    double             hourglass_energy() const;
    double             work() const;
    double             viscous_energy() const; ///< of the bulk viscosity
    /// What elements and points stored, of both of the first kinds, when they failed; it has left these.
    double eroded_energy() const;

    /// Failed elements carry nothing and have no vote on the step; their nodes keep their masses. Once failed, always.
    std::size_t n_failed() const;
    std::size_t n_collapsed() const; ///< of these, those taken away by Failure::smallest_step
    bool        is_failed(std::size_t element) const;
    double      failed_mass() const;               ///< kg
    bool        is_free(std::size_t node) const;   ///< all its elements have failed
    double      damage(std::size_t element) const; ///< largest D of its points; 1 and more: such a point failed

    std::size_t n_elements() const;
    std::size_t n_promoted() const; ///< elements that hold points through the thickness; all that are no solid-shells
    std::size_t bytes() const;      ///< counted, of all that these elements hold
    SolidState  state(std::size_t element) const;
    /// xx, yy, zz, xy, yz, zx (Pa) in global axes at a corner (0..7): the mean and what varies within the element.
    std::array<double, 6> corner_stress(std::size_t element, unsigned corner) const;

    struct MaxPlasticStrain
    {
      double      value   = 0.;
      std::size_t element = 0;
    };
    MaxPlasticStrain max_plastic_strain() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace birdstrike
