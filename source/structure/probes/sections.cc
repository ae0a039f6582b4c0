#include "structure/probes/sections.h"
#include <birdstrike/core/simd/larger.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  double RootSectionReport::peak_stress() const
  {
    double peak = 0.;
    for (const auto *face : {&stress_struck, &stress_rear})
      for (const double s : *face)
        peak = larger(peak, std::abs(s));
    return peak;
  }

  RootSectionReport compute_section_forces(const BladeEnd &root, const double *force, const double *position,
                                           const unsigned int n_unknowns)
  {
    RootSectionReport report;
    Point3            total = Point3::Zero(), moment = Point3::Zero();
    for (const std::uint32_t n : root.nodes)
      {
        const double *entries = force + n_unknowns * n;
        const Point3  f(entries[0], entries[1], entries[2]);
        const Point3  m = n_unknowns == 6 ? Point3(entries[3], entries[4], entries[5]) : Point3::Zero();
        const Point3  x(position[3 * n], position[3 * n + 1], position[3 * n + 2]);
        total += f;
        moment += m + (x - root.centroid).cross(f);
      }
    report.normal_force     = total.dot(root.span);
    report.transverse_force = total.dot(root.normal);
    report.bending_moment   = -moment.dot(root.normal.cross(root.span));
    return report;
  }

  double stress_along(const Point3 &span, const Point3 &surface_normal, const std::array<double, 6> &s)
  {
    const Point3 n = (span - span.dot(surface_normal) * surface_normal).normalized();
    return s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + s[2] * n[2] * n[2] +
           2. * (s[3] * n[0] * n[1] + s[4] * n[1] * n[2] + s[5] * n[2] * n[0]);
  }

  RootSection::RootSection(const ShellMesh &mesh, const BladeEnd &root) : root(root)
  {
    for (const std::size_t side : root.sides)
      {
        const std::uint32_t cell = mesh.boundary[side].cell;
        elements_at_root.push_back(
          {cell, (mesh.centroid(cell) - root.middle).dot(root.chord), inwards(mesh, mesh.boundary[side])});
      }
    std::sort(elements_at_root.begin(), elements_at_root.end(),
              [](const Element &a, const Element &b) { return a.chord_position < b.chord_position; });
  }

  RootSectionReport RootSection::compute_report(const double *force, const double *position,
                                                const ShellElements &elements, const Turn &turned) const
  {
    RootSectionReport report = compute_section_forces(root, force, position, 6);
    for (auto *list : {&report.chord_position, &report.stress_struck, &report.stress_rear})
      list->reserve(elements_at_root.size());
    for (const auto &element : elements_at_root)
      {
        // The element turns with the blade: its span direction is the reference one without the part out of its plane.
        const auto stress = elements.outer_stresses_along(element.index, turned(element.span));
        report.chord_position.push_back(element.chord_position);
        report.stress_struck.push_back(stress[root.is_turned ? 1 : 0]);
        report.stress_rear.push_back(stress[root.is_turned ? 0 : 1]);
      }
    return report;
  }

  void RootSection::add_nodes(std::vector<std::uint32_t> &nodes) const
  {
    nodes.insert(nodes.end(), root.nodes.begin(), root.nodes.end());
  }

  std::size_t RootSection::count_failed(const ShellElements &elements) const
  {
    return std::count_if(elements_at_root.begin(), elements_at_root.end(),
                         [&](const Element &element) { return elements.is_failed(element.index); });
  }

  TipRow::TipRow(const ShellMesh &mesh, const BladeEnd &tip) : normal(tip.normal)
  {
    add_row(mesh, tip.nodes, tip.chord);
  }

  template <int dim>
  void TipRow::add_row(const BladeMesh<dim> &mesh, const std::vector<std::uint32_t> &row, const Point3 &chord)
  {
    if (row.size() < 2)
      return;
    std::vector<std::pair<double, std::uint32_t>> along;
    for (const std::uint32_t n : row)
      along.emplace_back(mesh.node(n).dot(chord), n);
    std::sort(along.begin(), along.end());
    Row added;
    added.corners = {along.front().second, along.back().second};

    // Of half a row, mid-chord is on the plane of symmetry and both corners are alike.
    for (const std::uint32_t plane : mesh.symmetry_nodes)
      for (const int end : {0, 1})
        if (added.corners[end] == plane)
          {
            added.middle  = {{plane, plane}};
            added.share   = {{1., 0.}};
            added.corners = {added.corners[1 - end], added.corners[1 - end]};
            rows.push_back(added);
            return;
          }
    const double centre = 0.5 * (along.front().first + along.back().first);
    std::size_t  k      = 0;
    while (k + 2 < along.size() && along[k + 1].first < centre)
      ++k;
    const double weight = (centre - along[k].first) / (along[k + 1].first - along[k].first);
    added.middle        = {{along[k].second, along[k + 1].second}};
    added.share         = {{1. - weight, weight}};
    rows.push_back(added);
  }

  bool TipRow::is_present() const
  {
    return !rows.empty();
  }

  bool TipRow::has_any(const FunctionRef<bool(std::uint32_t)> property) const
  {
    for (const Row &row : rows)
      for (const std::uint32_t n : {row.corners[0], row.corners[1], row.middle[0], row.middle[1]})
        if (property(n))
          return true;
    return false;
  }

  void TipRow::add_nodes(std::vector<std::uint32_t> &nodes) const
  {
    for (const Row &row : rows)
      {
        nodes.insert(nodes.end(), row.corners.begin(), row.corners.end());
        nodes.insert(nodes.end(), row.middle.begin(), row.middle.end());
      }
  }

  TipDeflection TipRow::compute_deflection(const double *displacement, const unsigned int n_unknowns) const
  {
    const auto along_normal = [&](const std::uint32_t n) {
      const double *u = displacement + n_unknowns * n;
      return normal[0] * u[0] + normal[1] * u[1] + normal[2] * u[2];
    };
    TipDeflection sum;
    for (const Row &row : rows)
      {
        sum.mid_chord += row.share[0] * along_normal(row.middle[0]) + row.share[1] * along_normal(row.middle[1]);
        sum.leading += along_normal(row.corners[0]);
        sum.trailing += along_normal(row.corners[1]);
      }
    const double n = rows.empty() ? 1. : static_cast<double>(rows.size());
    return {sum.mid_chord / n, sum.leading / n, sum.trailing / n};
  }

  Point3 TipRow::mid_chord(const double *position) const
  {
    Point3 sum = Point3::Zero();
    for (const Row &row : rows)
      for (const int end : {0, 1})
        for (unsigned int d = 0; d < 3; ++d)
          sum[d] += row.share[end] * position[3 * row.middle[end] + d];
    return rows.empty() ? sum : Point3(sum / static_cast<double>(rows.size()));
  }

  std::optional<SpanLine> make_span_line(const BladeRoles &roles, const TipRow &tip, const double *reference)
  {
    if (!roles.root.is_present() || !tip.is_present())
      return {};
    const auto plain = [](const Point3 &p) { return std::array<double, 3>{{p[0], p[1], p[2]}}; };
    return SpanLine{plain(roles.root.middle), plain(tip.mid_chord(reference)), plain(roles.tip.normal)};
  }

  template void TipRow::add_row(const BladeMesh<3> &, const std::vector<std::uint32_t> &, const Point3 &);
} // namespace birdstrike
