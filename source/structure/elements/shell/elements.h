#pragma once

#include "structure/elements/shell/group.h"

namespace birdstrike
{
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

  /// State at a height of an element, in global axes; means over the points in the plane.
  struct ShellPointState
  {
    std::array<double, 6> stress;         ///< xx, yy, zz, xy, yz, zx, Pa (Cauchy); transverse shear: the section's mean
    double                plastic_strain; ///< equivalent
    double                volume_strain;  ///< ln of the volume's ratio, elastic; of plies, which keep their height, 0
  };

  enum class ShellLayer
  {
    bottom, ///< z = -t/2 (Lobatto) or the outermost point there (Gauss)
    middle,
    top
  };

  /// All shell elements of a blade.
  ///
  /// Reissner-Mindlin kinematics, 3 displacements and 3 global rotation increments a node, finite rotations; the theory
  /// stands in kernel.h, of full integration in full_integration.h. Strains are taken on the midpoint geometry x -
  /// dx/2, forces on the end geometry. The stiffness against drilling is zero; the moment on a node has no component
  /// along the director there (not so with Belytschko-Tsay), and the rotation about it has no effect.
  class ShellElements : public Elements<ShellGroup>
  {
  public:
    /// Cells are counter-clockwise about the positive normal; thickness (m) per cell. The pool must outlive this.
    ShellElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                  const std::vector<double> &thickness, const Sections<ShellSection> &sections, ThreadPool &pool);

    /// Nodes on a symmetry plane with the given normal: their directors begin in the plane, as they would with the
    /// other half of the shell in place. May be called for several planes, before the first step.
    void add_symmetry_plane(std::span<const std::uint32_t> nodes, const Point3 &plane_normal);

    /// Rotary inertia (kg m^2) per node, a quarter of m max(t^2/12, A/8) of each element at rest: bending never sets
    /// the step.
    std::vector<double> compute_rotary_inertias() const;

    double elastic_energy() const; ///< J
    double hourglass_energy() const;

    Point3 director(const std::uint32_t node) const ///< ShellNodes::director
    {
      return nodes.director(node);
    }

    ShellState state(std::size_t element) const;
    /// sxx, syy, sxy (Pa) in the element frame; the mean of the points in the plane. Of metals at the outermost
    /// (middle) point of the rule through the thickness, whether it has yielded or not; of plies at the face.
    std::array<double, 3> layer_stress(std::size_t element, ShellLayer layer) const;
    /// sxx, syy, szz, sxy, syz, szx (Pa) in global axes.
    std::array<double, 6> global_layer_stress(std::size_t element, ShellLayer layer) const;
    /// Normal stress (Pa) of the bottom and of the top layer, as layer_stress, along a direction without its part out
    /// of the element's plane; zero of a failed element.
    std::array<double, 2>  outer_stresses_along(std::size_t element, const Point3 &direction) const;
    const ThicknessPoints &thickness_points(std::size_t element) const; ///< of metals
    /// Where the state nearest to a layer (2 z/t) is known: of metals the height of an integration point, of plies the
    /// layer itself.
    double nearest_height(std::size_t element, double layer) const;
    /// The state at such a height.
    ShellPointState point_state(std::size_t element, double height) const;
    const Laminate *laminate(std::size_t element) const; ///< none of metals
    /// Of a laminate, shares of the thickness in which each mode of PlyDamage has begun; of metals nothing.
    std::array<double, 4> failed_shares(std::size_t element) const;
    /// kg, of its plies whose fibres have begun to fail, and of others whose matrix has.
    std::array<double, 2> failed_ply_mass(std::size_t element) const;
    /// The largest of the points in the plane.
    double layer_plastic_strain(std::size_t element, ShellLayer layer) const;
  };
} // namespace birdstrike
