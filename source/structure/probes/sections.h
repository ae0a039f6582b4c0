#pragma once

#include "structure/elements/shell/elements.h"
#include <birdstrike/core/function_ref.h>
#include <birdstrike/mesh/roles.h>
#include <birdstrike/structure/reports.h>
#include <birdstrike/structure/rotor.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace birdstrike
{
  /// The clamped section as that of a beam: force and moment of the nodal forces [n_nodes][n_unknowns] (N, N m) that
  /// elements exert at positions [n_nodes][3] (m), about its centroid, in the axes of the root.
  RootSectionReport compute_section_forces(const BladeEnd &root, const double *force, const double *position,
                                           unsigned int n_unknowns);

  /// Normal stress (Pa) along the span in a surface that has turned to the unit normal `surface_normal`:
  /// s . sigma . s, where s is a span direction without its part out of that surface; sigma = xx yy zz xy yz zx in
  /// global axes.
  double stress_along(const Point3 &span, const Point3 &surface_normal, const std::array<double, 6> &stress);

  /// The clamped edge of a shell.
  class RootSection
  {
  public:
    RootSection() = default; ///< absent
    RootSection(const ShellMesh &mesh, const BladeEnd &root);

    /// From the nodal forces [n_nodes][6] that elements exert (N, N m) at positions [n_nodes][3], and the layer
    /// stresses.
    /// On a blade that turns, forces and positions are those in the turning frame; stresses are turned back.
    RootSectionReport compute_report(const double *force, const double *position, const ShellElements &elements,
                                     const Turn &turned = {}) const;
    std::size_t       count_failed(const ShellElements &elements) const;  ///< of the elements at the edge
    void              add_nodes(std::vector<std::uint32_t> &nodes) const; ///< those that a report asks

  private:
    struct Element
    {
      std::size_t index;
      double      chord_position; ///< m from the origin
      Point3      span;           ///< unit, in the element's plane, from its root edge inwards
    };
    BladeEnd             root;
    std::vector<Element> elements_at_root; ///< by chord position
  };

  /// The tip row: mid-chord and both corners. Of a solid, the mean of the rows on both faces: its mid-surface.
  class TipRow
  {
  public:
    TipRow() = default; ///< absent
    TipRow(const ShellMesh &mesh, const BladeEnd &tip);
    TipRow(const SolidMesh &mesh, const BladeEnd &tip);

    bool          is_present() const;
    bool          has_any(FunctionRef<bool(std::uint32_t)> property) const; ///< of the nodes it watches
    TipDeflection compute_deflection(const double *displacement, unsigned int n_unknowns) const; ///< [n][n_unknowns]
    void          add_nodes(std::vector<std::uint32_t> &nodes) const;                            ///< those that it asks

    Point3 mid_chord(const double *position) const; ///< m, from positions [n_nodes][3]

  private:
    template <int dim>
    void add_row(const BladeMesh<dim> &mesh, const std::vector<std::uint32_t> &row, const Point3 &chord);

    struct Row
    {
      std::array<std::uint32_t, 2> corners{}, middle{}; ///< leading and trailing; neighbours of mid-chord
      std::array<double, 2>        share{};
    };
    std::vector<Row> rows;
    Point3           normal = Point3::Zero();
  };

  /// From the middle of the root to that of the tip, by reference positions [n_nodes][3]; nothing where one is missing.
  std::optional<SpanLine> make_span_line(const BladeRoles &roles, const TipRow &tip, const double *reference);
} // namespace birdstrike
