#pragma once

#include <birdstrike/blade/reports.h>
#include <birdstrike/blade/shell_elements.h>
#include <birdstrike/blade/supports.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// The clamped edge as a beam section: which nodes and elements it has, and the frame in which forces are reported.
  class RootSection
  {
  public:
    RootSection(const SurfaceMesh &mesh, const std::vector<unsigned int> &root_ids);

    /// From the nodal forces [n_nodes][6] that elements exert (N, N m) at positions [n_nodes][3], and the layer
    /// stresses.
    RootSectionReport compute_report(const double *force, const double *position, const ShellElements &elements) const;

  private:
    struct Element
    {
      std::size_t index;
      double      chord_position; ///< m from the origin
      Point3      span;           ///< unit, in the element's plane, from its root edge inwards
    };
    std::vector<std::uint32_t> nodes;
    std::vector<Element>       elements_at_root; ///< by chord position
    Point3                     origin, span, chord, normal;
  };

  /// The tip row: mid-chord and both corners.
  class TipRow
  {
  public:
    TipRow(const SurfaceMesh &mesh, const std::vector<unsigned int> &tip_ids);
    bool          is_present() const;
    TipDeflection compute_deflection(const double *displacement) const; ///< [n_nodes][6]

  private:
    std::vector<std::uint32_t>   corners; ///< none, or leading and trailing
    std::array<std::uint32_t, 2> middle{};
    std::array<double, 2>        share{};
    Point3                       normal;
  };
} // namespace birdstrike
