#pragma once

#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/orientation.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  enum class SpanEnd
  {
    root,
    tip
  };

  /// An end of the blade's span, root or tip: the sides of the mesh that lie on it, and the axes of that cut, right
  /// angles between them. `span` points into the blade, `chord` from the leading to the trailing edge, `normal` away
  /// from the struck side, as orientation.h says.
  ///
  /// Of a shell the normal is that of the surface of the cells at this end. Forces pass through the edges of the root:
  /// there cells count by what they carry of a tension, the length of their edge times their stiffness, and the span is
  /// square to each edge. The row of the tip moves with the cells behind it: there they count by area, and the chord is
  /// square to the mean way to their centroids.
  ///
  /// Of a built-in solid it is the mean of the cells' third axis, which runs along the mid-surface normal of the shell
  /// of the same part; of a solid from a file the principal axis of the cut's second moment of area of which that
  /// moment is smaller, with the sign of `sign_by_axes` z, y, x. Half an end (symmetry plane y = 0) has the middle and
  /// the axes of the whole.
  struct BladeEnd
  {
    BladeEnd() = default; ///< absent
    /// The sides with these boundary ids; absent where there is none, or where they run all around. `stiffness` of the
    /// cells in tension: of a shell N/m, modulus times thickness, of a solid Pa; empty: all alike.
    template <int dim>
    BladeEnd(const BladeMesh<dim> &mesh, SpanEnd end, const std::vector<unsigned int> &ids,
             const std::vector<double> &stiffness = {});

    /// The same end of another blade of the row, whose points are those of the first turned by R about a centre (m).
    template <int dim>
    BladeEnd of_blade(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &ids, std::uint32_t blade,
                      const Matrix3<double> &R, const Point3 &centre) const;

    bool is_present() const
    {
      return !sides.empty();
    }
    void turn() ///< from now on the normal looks the other way
    {
      normal    = -normal;
      is_turned = !is_turned;
    }

    std::vector<std::size_t>   sides;                     ///< of the mesh's `boundary`
    std::vector<std::uint32_t> nodes;                     ///< on them, owned, sorted
    Point3                     middle   = Point3::Zero(); ///< m, of the line (face)
    Point3                     centroid = Point3::Zero(); ///< m, of its stiffness: a tension there bends nothing
    Point3                     span = Point3::Zero(), chord = Point3::Zero(), normal = Point3::Zero(); ///< unit
    bool                       is_turned = false; ///< the normal is not that of the mesh

  private:
    template <int dim>
    void collect(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &ids, std::uint32_t blade);
  };

  /// Off a boundary edge of a shell, in the plane of its cell: unit.
  Point3 inwards(const SurfaceMesh &mesh, const SurfaceMesh::BoundarySide &edge);

  /// Where the bird aims, m, and its velocity relative to the blade there, m/s; zero without a bird.
  struct Approach
  {
    Point3 place = Point3::Zero(), velocity = Point3::Zero();
  };

  /// Which part of the mesh plays which role.
  struct BladeRoles
  {
    BladeRoles() = default;
    /// Ends by boundary ids; `stiffness` as of a BladeEnd.
    ///
    /// Both normals look to one side of the blade: away from the one that is struck, where the bird aims; without a
    /// bird that of the tip decides, that of the root without a tip. The twist between these places is taken from the
    /// mesh where its cells run through from root to tip (shells, and solids that are built in); else it is taken as
    /// less than a right angle.
    template <int dim>
    BladeRoles(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &root_ids,
               const std::vector<unsigned int> &tip_ids, const Approach &approach,
               const std::vector<double> &stiffness = {});

    void take_row(const MeshParameters::Row &row);

    /// What turns the described blade into that of the row whose line from root to tip is nearest to a point (m).
    Matrix3<double> turn_at(const Point3 &point) const;

    /// Along the chord at a place of the blade with this normal, away from the struck side, and this span, from root to
    /// tip: unit, running on from that of the root however the sections turn in between.
    Point3 chord_at(const Point3 &normal, const Point3 &span) const;

    BladeEnd root, tip; ///< of a row, of the blade that is described

    /// Of a row: what turns the described blade into each, itself first, about a centre (m); empty: one blade.
    std::vector<Matrix3<double>> turns;
    Point3                       centre = Point3::Zero();
  };
} // namespace birdstrike
