#pragma once

#include "structure/elements/solid/elements.h"
#include "structure/probes/sections.h"
#include <birdstrike/mesh/cell_mesh.h>

#include <vector>

namespace birdstrike
{
  /// The faces of a solid at one end of its span, root or tip, and the axes of that cut.
  ///
  /// `normal` runs through the thickness. Of a built-in part it is the mean of the cells' third axis, which runs along
  /// the mid-surface normal of the shell of the same part; of a file the principal axis of the cut's second moment of
  /// area of which that moment is smaller, with the sign of `sign_by_axes` z, y, x. Half a cut (symmetry plane y = 0)
  /// has the axes of the whole.
  struct EndFaces
  {
    EndFaces(const VolumeMesh &mesh, const std::vector<unsigned int> &ids);

    bool is_present() const
    {
      return !faces.empty();
    }

    std::vector<std::size_t> faces; ///< of VolumeMesh::boundary; empty where there is no single end
    Point3                   centroid = Point3::Zero(), outward = Point3::Zero(), normal = Point3::Zero(); ///< m; unit

    /// The other boundary faces that meet this end: those that look along minus and plus the normal (within 60
    /// degrees), in this order. Edges of finite thickness are in neither.
    std::array<std::vector<std::size_t>, 2> find_adjoining(const VolumeMesh                &mesh,
                                                           const std::vector<unsigned int> &ids) const;
  };

  /// The clamped faces of a solid as a section: forces from their nodes, stresses at the middle of the skin facets that
  /// adjoin them, half an element from the root as in the shell. What is linear through a brick overshoots at the face
  /// when it yields (by half in a brick that bends fully plastic): the deviator is taken back to the static flow stress
  /// at the brick's mean plastic strain.
  class SolidRootSection
  {
  public:
    SolidRootSection(const VolumeMesh &mesh, const std::vector<unsigned int> &root_ids);

    /// From now on the normal looks the other way.
    void turn();

    /// From the nodal forces [n_nodes][3] that elements exert (N) at positions [n_nodes][3] (m), and the stresses of
    /// the corners. A facet on the top without a counterpart is paired with the nearest below.
    RootSectionReport compute_report(const double *force, const double *position, const SolidElements &elements) const;

    std::size_t count_failed(const SolidElements &elements) const; ///< of the elements whose stress it reports

    const SectionFrame &section() const
    {
      return frame;
    }

  private:
    struct Facet
    {
      std::uint32_t                cell;
      std::array<std::uint32_t, 4> nodes;          ///< counter-clockwise about the outward normal
      std::array<unsigned int, 4>  corners;        ///< the same, of the cell
      double                       chord_position; ///< m from the middle of the section
    };
    std::vector<Facet> make_facets(const VolumeMesh &mesh, const std::vector<std::size_t> &faces) const;
    double             stress(const Facet &facet, const double *position, const SolidElements &elements) const;

    SectionFrame                      frame;
    std::array<std::vector<Facet>, 2> facets; ///< bottom and top, as many, by chord position
  };

  /// The tip of a solid on both faces.
  TipRow make_tip_row(const VolumeMesh &mesh, const std::vector<unsigned int> &tip_ids);
} // namespace birdstrike
