#pragma once

#include <birdstrike/core/symmetry_plane.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/roles.h>

#include <functional>
#include <vector>

namespace birdstrike
{
  /// Force and moment that pass through a section across the span.
  ///
  /// The cut runs along sides of elements: it divides those whose centroid lies beyond the station from the others.
  /// What the elements beyond exert on its nodes is, since the forces of an element on its nodes are in balance, the
  /// negative of all element forces f, m on the nodes beyond the cut (LS-DYNA sums the first over a set of nodes and a
  /// set of elements, *DATABASE_CROSS_SECTION_SET). The force of an element is that at its middle, half an element
  /// beyond; what acts on the cut's own nodes, loads and inertia, is the negative of the element forces there. Of it a
  /// share w belongs to what lies beyond, by the sizes of the elements of a node that are left:
  ///   F = - sum w f,   M = - sum w ((x - c) x f + m)   over nodes beyond, w = 1, and nodes of the cut,
  /// about the present centroid c of the cut, that of what it carries of a tension: sides count by length (area)
  /// times stiffness, the mean of the elements on both sides. So a tension through it has no moment, and
  /// F = contact and loads beyond less d/dt of the momentum beyond, of the cut's nodes their shares. At station 0 the
  /// cut is the root, F and M what the blade exerts on its support (RootSectionReport).
  struct SectionForces
  {
    Point3          force, moment; ///< N, N m, global axes, of the whole
    Matrix3<double> axes;          ///< span, chord and normal in the rows

    double normal() const ///< N, along the span, tension positive
    {
      return force.dot(axes.row(0));
    }
    double bending() const ///< N m, about normal x span; positive stretches the struck face
    {
      return -moment.dot(axes.row(2).cross(axes.row(0)));
    }
  };

  /// Where it is cut. The axes are those of the undeformed blade at the cut (histories/axes.h), span along the line
  /// from root to tip, turned by the rotation that fits the motion of the nodes of all elements at the cut best
  /// (Kabsch, Acta Crystallographica A32, 1976); at station 0 they are those of the root and stay.
  template <int dim>
  class SectionCut
  {
  public:
    /// `station`: share of the span, 0 <= station < 1; `stiffness` of the elements as of BladeRoles. Throws InputError
    /// where nothing lies beyond.
    SectionCut(const BladeMesh<dim> &mesh, const BladeRoles &roles, double station, SymmetryPlane plane,
               const std::vector<double> &stiffness = {});

    /// Whether a node has lost all its elements; whether an element has failed.
    using IsFree = std::function<bool(std::uint32_t)>;

    /// From element forces, at the root from forces on the support, [n_nodes][n_unknowns], at positions [n_nodes][3].
    /// Nodes that fly free are no part of the section: neither its centroid nor its axes follow them (of fewer than
    /// three left the axes are those at rest).
    SectionForces compute(const double *force, const double *position, IsFree is_free = {},
                          IsFree is_failed = {}) const;

    bool is_root() const
    {
      return cut.empty();
    }

    double span_position() const ///< m from the root, of the cut
    {
      return distance;
    }

  private:
    void find_cut(const BladeMesh<dim> &mesh, const std::vector<bool> &is_beyond, const std::vector<double> &stiffness);
    void find_shares(const BladeMesh<dim> &mesh, const std::vector<bool> &is_beyond);
    Matrix3<double> fit_rotation(const double *position, const IsFree &is_free) const;

    /// An element at a node of the cut, by its place there, and what of it is the node's (m^2 or m^3).
    struct Share
    {
      std::size_t   place;
      std::uint32_t cell;
      double        size;
      bool          is_beyond;
    };
    std::vector<double> weights_of_cut(const IsFree &is_failed) const;

    struct Weighted
    {
      std::uint32_t node;
      double        weight;
    };
    SymmetryPlane              plane;
    std::vector<std::uint32_t> beyond;    ///< nodes without the cut's; at the root its own
    std::vector<Share>         shares;    ///< of the nodes of the cut
    std::vector<Weighted>      cut;       ///< by what their sides carry; sum 1; none at the root
    std::vector<std::uint32_t> attached;  ///< nodes of the elements at the cut
    std::vector<Point3>        reference; ///< m, of these
    Point3                     centroid;  ///< m, at rest
    Matrix3<double>            axes;      ///< at rest
    double                     distance = 0.;
  };
} // namespace birdstrike
