#pragma once

#include "structure/elements/solid/group.h"

#include <optional>

namespace birdstrike
{
  /// State of one element for output.
  struct SolidState
  {
    std::array<double, 6> stress;             ///< xx, yy, zz, xy, yz, zx, Pa, global axes, mean of the element
    double                plastic_strain;     ///< equivalent, mean of the element, -
    double                max_plastic_strain; ///< largest of its points, -
    double                volume;             ///< m^3
  };

  /// State at the middle of a face.
  struct SolidFaceState
  {
    std::array<double, 6> stress;         ///< as SolidState's
    double                plastic_strain; ///< equivalent, of the points nearest to the face, -
  };

  /// Selective mass scaling of one element: `factor` (>= 1) times the inertia against differences along `axis` of its
  /// reference cube, 0, 1 or 2.
  struct MassScale
  {
    unsigned int axis   = 2;
    double       factor = 1.;
  };

  /// All 8-node bricks of a blade.
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
  /// stands in one_point.h and b_bar.h, plasticity in law.h and flow.h.
  class SolidElements : public Elements<SolidGroup>
  {
  public:
    /// Nodes of a cell in lexicographic order (deal.II's): 0 (0,0,0), 1 (1,0,0), 2 (0,1,0), 3 (1,1,0), 4..7 the same at
    /// z = 1; positive volume. The pool must outlive this.
    SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                  const Sections<SolidSection> &sections, ThreadPool &pool);

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

    double elastic_energy() const;   ///< J, of the mean and of points
    double hourglass_energy() const; ///< J, of the stabilisation, and at corners (corner_volume.h)

    SolidState state(std::size_t element) const;
    /// xx, yy, zz, xy, yz, zx (Pa) in global axes at a corner (0..7): the mean and what varies within the element.
    std::array<double, 6> corner_stress(std::size_t element, unsigned corner) const;
    /// At the middle of a face. Where the stress across it is `given` (0 on a free one), that of the brick, which is a
    /// mean over it and beside a clamp hundreds of MPa, is replaced and the others are kept, whose moment and force
    /// balance those of the section beyond,
    ///   s + (given - s_nn) n n.
    /// What is linear through a brick overshoots at a face when it yields (by half in a brick that bends fully
    /// plastic): the stress is taken back to what the points nearest to the face carry (SolidGroup::compute_strength),
    /// as plane stress is, with the stress across as it is,
    ///   s_nn 1 + f (s - s_nn 1),   f = q_points/q.
    SolidFaceState face_state(std::size_t element, const SolidFace &face, std::optional<double> given = {}) const;

  private:
    class Trial; ///< of factors

    SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                  const std::vector<std::uint8_t> &axes, const Sections<SolidSection> &sections, ThreadPool &pool);
  };
} // namespace birdstrike
