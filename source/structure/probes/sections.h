#pragma once

#include "structure/elements/shell/elements.h"
#include "structure/nodes/supports.h"
#include <birdstrike/core/function_ref.h>
#include <birdstrike/structure/reports.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace birdstrike
{
  /// The clamped section as that of a beam: its nodes, and the frame in which forces are reported (RootSectionReport).
  struct SectionFrame
  {
    std::vector<std::uint32_t> nodes;
    Point3 origin = Point3::Zero(), span = Point3::Zero(), chord = Point3::Zero(), normal = Point3::Zero();

    /// Makes `normal` a unit vector, `span` one perpendicular to it, `chord` perpendicular to both (orientation.h).
    void make_orthonormal();

    /// Force and moment of the nodal forces [n_nodes][n_unknowns] (N, N m) that elements exert at positions
    /// [n_nodes][3] (m).
    RootSectionReport compute_forces(const double *force, const double *position, unsigned int n_unknowns) const;

    /// Normal stress (Pa) along the span in a surface that has turned to the unit normal `surface_normal`:
    /// s . sigma . s, where s is a span direction without its part out of that surface; sigma = xx yy zz xy yz zx in
    /// global axes.
    static double stress_along(const Point3 &span, const Point3 &surface_normal, const std::array<double, 6> &stress);
  };

  /// The clamped edge of a shell. Its normal is that of the surface until it is turned.
  class RootSection
  {
  public:
    RootSection(const SurfaceMesh &mesh, const std::vector<unsigned int> &root_ids);

    /// From now on the normal looks the other way.
    void turn();

    /// From the nodal forces [n_nodes][6] that elements exert (N, N m) at positions [n_nodes][3], and the layer
    /// stresses.
    RootSectionReport compute_report(const double *force, const double *position, const ShellElements &elements) const;
    std::size_t       count_failed(const ShellElements &elements) const; ///< of the elements at the edge

    const SectionFrame &section() const;

  private:
    struct Element
    {
      std::size_t index;
      double      chord_position; ///< m from the origin
      Point3      span;           ///< unit, in the element's plane, from its root edge inwards
    };
    SectionFrame         frame;
    std::vector<Element> elements_at_root;  ///< by chord position
    bool                 is_turned = false; ///< the normal is not the surface's
  };

  /// The tip row: mid-chord and both corners. Of a solid, the mean of the rows on both faces: its mid-surface.
  class TipRow
  {
  public:
    TipRow() = default; ///< absent
    TipRow(const SurfaceMesh &mesh, const std::vector<unsigned int> &tip_ids);

    /// Adds a row of at least two nodes; `chord` and `normal` are unit vectors of the tip.
    void add_row(const std::vector<std::array<double, 3>> &nodes, const std::vector<std::uint32_t> &row,
                 const std::vector<std::uint32_t> &symmetry_nodes, const Point3 &chord, const Point3 &normal);

    /// From now on deflections count in the other direction. Leading and trailing stay what they are.
    void turn();

    bool          is_present() const;
    bool          has_any(FunctionRef<bool(std::uint32_t)> property) const; ///< of the nodes it watches
    TipDeflection compute_deflection(const double *displacement, unsigned int n_unknowns) const; ///< [n][n_unknowns]

    Point3        mid_chord(const double *position) const; ///< m, from positions [n_nodes][3]
    const Point3 &surface_normal() const;

  private:
    struct Row
    {
      std::array<std::uint32_t, 2> corners{}, middle{}; ///< leading and trailing; neighbours of mid-chord
      std::array<double, 2>        share{};
    };
    std::vector<Row> rows;
    Point3           normal = Point3::Zero();
  };

  /// From the middle of the root to that of the tip, by reference positions [n_nodes][3]; nothing where one is missing.
  std::optional<SpanLine> make_span_line(const SectionFrame &root, const TipRow &tip, const double *reference);
} // namespace birdstrike
