#include <birdstrike/blade/sections.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  double RootSectionReport::peak_stress() const
  {
    double peak = 0.;
    for (const auto *face : {&stress_bottom, &stress_top})
      for (const double s : *face)
        peak = std::max(peak, std::abs(s));
    return peak;
  }

  RootSection::RootSection(const SurfaceMesh &mesh, const std::vector<unsigned int> &root_ids)
    : nodes(mesh.rim_nodes(root_ids))
    , origin(Point3::Zero())
    , span(Point3::Zero())
    , chord(Point3::Zero())
    , normal(Point3::Zero())
  {
    double length = 0.;
    for (const auto &edge : mesh.rim)
      if (std::find(root_ids.begin(), root_ids.end(), edge.id) != root_ids.end())
        {
          const Point3 a = mesh.node(edge.nodes[0]), b = mesh.node(edge.nodes[1]), middle = 0.5 * (a + b);
          const Point3 along   = (b - a).normalized();
          const Point3 inwards = mesh.centroid(edge.cell) - middle;
          const Point3 inside  = (inwards - inwards.dot(along) * along).normalized();
          elements_at_root.push_back({edge.cell, 0., inside});
          origin += (b - a).norm() * middle;
          span += (b - a).norm() * inside;
          normal += (b - a).norm() * mesh.area_vector(edge.cell).normalized();
          length += (b - a).norm();
        }
    if (elements_at_root.empty() || span.norm() < 1e-6 * length || normal.norm() < 1e-6 * length)
      {
        // Nothing clamped, or clamped all around: no single section to speak of.
        nodes.clear();
        elements_at_root.clear();
        return;
      }
    origin /= length;
    if (!mesh.symmetry_nodes.empty())
      origin[1] = 0.; // the middle of the whole edge
    normal.normalize();
    span  = (span - span.dot(normal) * normal).normalized();
    chord = normal.cross(span);
    for (auto &element : elements_at_root)
      element.chord_position = (mesh.centroid(element.index) - origin).dot(chord);
    std::sort(elements_at_root.begin(), elements_at_root.end(),
              [](const Element &a, const Element &b) { return a.chord_position < b.chord_position; });
  }

  RootSectionReport RootSection::compute_report(const double *force, const double *position,
                                                const ShellElements &elements) const
  {
    RootSectionReport report;
    Point3            total = Point3::Zero(), moment = Point3::Zero();
    for (const std::uint32_t n : nodes)
      {
        const Point3 f(force[6 * n], force[6 * n + 1], force[6 * n + 2]);
        const Point3 m(force[6 * n + 3], force[6 * n + 4], force[6 * n + 5]);
        const Point3 x(position[3 * n], position[3 * n + 1], position[3 * n + 2]);
        total += f;
        moment += m + (x - origin).cross(f);
      }
    report.normal_force     = total.dot(span);
    report.transverse_force = total.dot(normal);
    report.bending_moment   = -moment.dot(chord);

    // Normal stress s . sigma . s with the stress in global axes.
    const auto along = [](const std::array<double, 6> &s, const Point3 &n) {
      return s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + s[2] * n[2] * n[2] +
             2. * (s[3] * n[0] * n[1] + s[4] * n[1] * n[2] + s[5] * n[2] * n[0]);
    };
    for (const auto &element : elements_at_root)
      {
        report.chord_position.push_back(element.chord_position);
        // The element turns with the blade: its span direction is the reference one without the part out of its plane.
        const Point3 axis   = elements.state(element.index).axes.col(2);
        const Point3 inside = (element.span - element.span.dot(axis) * axis).normalized();
        report.stress_bottom.push_back(along(elements.global_layer_stress(element.index, ShellLayer::bottom), inside));
        report.stress_top.push_back(along(elements.global_layer_stress(element.index, ShellLayer::top), inside));
      }
    return report;
  }

  TipRow::TipRow(const SurfaceMesh &mesh, const std::vector<unsigned int> &tip_ids) : normal(Point3::Zero())
  {
    const auto row = mesh.rim_nodes(tip_ids);
    if (row.size() < 2)
      return;
    Point3 span = Point3::Zero();
    for (const auto &edge : mesh.rim)
      if (std::find(tip_ids.begin(), tip_ids.end(), edge.id) != tip_ids.end())
        {
          normal += mesh.area_vector(edge.cell);
          span += 0.5 * (mesh.node(edge.nodes[0]) + mesh.node(edge.nodes[1])) - mesh.centroid(edge.cell);
        }
    normal.normalize();
    // At the tip "outwards" is the span direction, so that the chord runs as it does at the root.
    const Point3                                  chord = normal.cross(span).normalized();
    std::vector<std::pair<double, std::uint32_t>> along;
    for (const std::uint32_t n : row)
      along.emplace_back(mesh.node(n).dot(chord), n);
    std::sort(along.begin(), along.end());
    corners = {along.front().second, along.back().second};

    // Of half a row, mid-chord is on the plane of symmetry and both corners are alike.
    for (const std::uint32_t plane : mesh.symmetry_nodes)
      for (const int end : {0, 1})
        if (corners[end] == plane)
          {
            middle  = {{plane, plane}};
            share   = {{1., 0.}};
            corners = {corners[1 - end], corners[1 - end]};
            return;
          }
    const double centre = 0.5 * (along.front().first + along.back().first);
    std::size_t  k      = 0;
    while (k + 2 < along.size() && along[k + 1].first < centre)
      ++k;
    const double weight = (centre - along[k].first) / (along[k + 1].first - along[k].first);
    middle              = {{along[k].second, along[k + 1].second}};
    share               = {{1. - weight, weight}};
  }

  bool TipRow::is_present() const
  {
    return !corners.empty();
  }

  TipDeflection TipRow::compute_deflection(const double *displacement) const
  {
    const auto along_normal = [&](const std::uint32_t n) {
      return normal[0] * displacement[6 * n] + normal[1] * displacement[6 * n + 1] +
             normal[2] * displacement[6 * n + 2];
    };
    if (!is_present())
      return {};
    return {share[0] * along_normal(middle[0]) + share[1] * along_normal(middle[1]), along_normal(corners[0]),
            along_normal(corners[1])};
  }
} // namespace birdstrike
