#pragma once

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
  /// What all elements of a blade share.
  struct ShellSection
  {
    ShellFormulation formulation = ShellFormulation::one_point_physical;
    ThicknessRule    rule        = ThicknessRule::gauss;
    unsigned int     n_points    = 5; ///< through the thickness: 3, 5 or 7
    Metal            material;
    double           hourglass_coefficient = 0.05;    ///< Belytschko-Tsay: membrane, w and theta alike
    double           shear_factor          = 5. / 6.; ///< Reissner's kappa
    bool             has_thinning          = true;    ///< the thickness follows the plane-stress strain
  };

  /// State of one element for output, in its frame (axes in the columns of `axes`, third the normal). With several
  /// points in the plane: means, and the largest plastic strain.
  struct ShellState
  {
    Matrix3<double>       axes;
    std::array<double, 3> membrane_force; ///< N_xx, N_yy, N_xy, N/m
    std::array<double, 3> moment;         ///< M_xx, M_yy, M_xy, N (per length)
    std::array<double, 2> shear_force;    ///< Q_x, Q_y, N/m
    double                thickness;      ///< m
    double                max_plastic_strain;
  };

  enum class ShellLayer
  {
    bottom, ///< z = -t/2 (Lobatto) or the outermost point there (Gauss)
    middle,
    top
  };

  /// All shell elements of a blade: their strain increments, stresses, internal forces and energies.
  ///
  /// Reissner-Mindlin kinematics, 3 displacements and 3 global rotation increments a node, finite rotations; the theory
  /// stands in shell_kernel.h, of full integration in shell_full_integration.h. Strains are taken on the midpoint
  /// geometry x - dx/2, forces on the end geometry. The stiffness against drilling is zero; the moment on a node has no
  /// component along the averaged normal there (not so with Belytschko-Tsay), and the rotation about it has no effect.
  ///
  /// Where the metal can fail (material/failure.h), a point with D >= 1 carries nothing from then on, and an element
  /// whose stated share of points has failed, or which has collapsed, neither (shell_failure.h, erosion.h). Other
  /// metals pay nothing for it.
  ///
  /// Not here: mass, supports, loads, time. Throws InputError for a degenerate element or an impossible section,
  /// NumericalFailure when an element collapses (unless Failure::smallest_step erodes it) or a force is not finite.
  class ShellElements
  {
  public:
    /// Cells are counter-clockwise about the positive normal; thickness (m) per cell. The pool must outlive this.
    ShellElements(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 4>> cells,
                  std::vector<double> thickness, const ShellSection &section, ThreadPool &pool);
    ~ShellElements();
    ShellElements(ShellElements &&) noexcept;

    /// Nodes on a symmetry plane with the given normal: their averaged normal stays in the plane, as it would with the
    /// other half of the shell in place. May be called for several planes, before the first step.
    void add_symmetry_plane(std::span<const std::uint32_t> nodes, const Point3 &plane_normal);

    /// position [n_nodes][3] at t^{n+1} (m); increment [n_nodes][6] of displacement (m) and rotation (rad) since the
    /// last call; force [n_nodes][6] is overwritten with what the elements exert on the nodes, -f_int (N, N m).
    void compute_internal_forces(const double *position, const double *increment, double dt, double *force);

    /// 2/omega_max by a bound on the largest eigenvalue of every element, for nodal masses and inertias that are not
    /// smaller than those of the two functions below. No safety factor.
    StepLimit step_limit() const;
    double    largest_stable_step() const; ///< s, the value of the same without its words: nothing is searched
    /// Masses (kg) that the nodes really carry, [n_nodes]: the bound then allows for shares other than a quarter.
    void use_nodal_masses(std::span<const double> mass);
    /// A quarter of each element's mass to each of its nodes (kg), [n_nodes].
    std::vector<double> compute_nodal_masses() const;
    /// Rotary inertia (kg m^2) per node, a quarter of m max(t^2/12, A/8) of each element: bending never sets the step.
    std::vector<double> compute_rotary_inertias() const;

    /// Energies (J). Elastic: of the present stresses (StoredEnergy). Plastic and hourglass: cumulative, by their own
    /// rates; hourglass energy is all work on the stabilisation, stored or taken by its limits. `work` is that of the
    /// nodal forces, trapezoidal in time: what it differs from the sum of the others (and the eroded energy) is an
    /// error.
    double elastic_energy() const;
    double plastic_work() const;
    double hourglass_energy() const;
    double work() const;
    /// Elastic energy, and what of the hourglass energy was elastic, that points and elements had when they failed; it
    /// has left the other three.
    double eroded_energy() const;

    /// Failed elements carry nothing and have no vote on the step; their nodes keep their masses. Once failed, always.
    std::size_t n_failed() const;
    std::size_t n_collapsed() const; ///< of these, those taken away by Failure::smallest_step
    bool        is_failed(std::size_t element) const;
    double      failed_mass() const;               ///< kg
    bool        is_free(std::size_t node) const;   ///< all its elements have failed
    double      damage(std::size_t element) const; ///< largest D of its points; 1 and more: such a point failed

    std::size_t n_elements() const;
    std::size_t n_promoted() const; ///< elements that store points because an outer fibre met the yield stress
    std::size_t bytes() const;      ///< counted, of all that these elements hold
    ShellState  state(std::size_t element) const;
    /// sxx, syy, sxy (Pa) in the element frame; the mean of the points in the plane.
    std::array<double, 3> layer_stress(std::size_t element, ShellLayer layer) const;
    /// sxx, syy, szz, sxy, syz, szx (Pa) in global axes.
    std::array<double, 6> global_layer_stress(std::size_t element, ShellLayer layer) const;
    /// Normal stress (Pa) of the bottom and of the top layer along a direction without its part out of the element's
    /// plane; zero of a failed element.
    std::array<double, 2> outer_stresses_along(std::size_t element, const Point3 &direction) const;
    /// The largest of the points in the plane.
    double layer_plastic_strain(std::size_t element, ShellLayer layer) const;

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
