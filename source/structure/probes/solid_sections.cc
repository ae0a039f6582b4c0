#include "structure/probes/solid_sections.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Face = VolumeMesh::BoundarySide;

    /// The other boundary faces of the cells at an end: those that look along minus and plus the normal (within 60
    /// degrees), in this order. Edges of finite thickness are in neither.
    std::array<std::vector<std::size_t>, 2> find_adjoining(const VolumeMesh &mesh, const BladeEnd &end)
    {
      std::set<std::uint32_t> cells;
      for (const std::size_t f : end.sides)
        cells.insert(mesh.boundary[f].cell);
      std::array<std::vector<std::size_t>, 2> found;
      for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
        if (const Face &face = mesh.boundary[f];
            cells.count(face.cell) > 0 && !std::binary_search(end.sides.begin(), end.sides.end(), f))
          {
            const double cosine = area_vector(mesh, face).normalized().dot(end.normal);
            if (std::abs(cosine) > 0.5)
              found[cosine > 0. ? 1 : 0].push_back(f);
          }
      return found;
    }
  } // namespace

  SolidRootSection::SolidRootSection(const SolidMesh &mesh, const BladeEnd &root) : root(root)
  {
    const auto adjoining = find_adjoining(mesh, root);
    for (unsigned int side = 0; side < 2; ++side)
      facets[side] = make_facets(mesh, adjoining[side]);
    if (facets[0].empty() || facets[1].empty())
      {
        facets = {};
        return;
      }
    std::vector<Facet> paired;
    for (const Facet &below : facets[0])
      paired.push_back(*std::min_element(facets[1].begin(), facets[1].end(), [&](const Facet &a, const Facet &b) {
        return std::abs(a.chord_position - below.chord_position) < std::abs(b.chord_position - below.chord_position);
      }));
    facets[1] = paired;
  }

  std::vector<SolidRootSection::Facet> SolidRootSection::make_facets(const VolumeMesh               &mesh,
                                                                     const std::vector<std::size_t> &faces) const
  {
    std::vector<Facet> made;
    for (const std::size_t f : faces)
      {
        const Face &face = mesh.boundary[f];
        made.push_back({face.cell,
                        face.nodes,
                        {face.side / 2, face.side % 2 == 0 ? -1. : 1.},
                        (middle(mesh, face) - root.middle).dot(root.chord)});
      }
    std::sort(made.begin(), made.end(),
              [](const Facet &a, const Facet &b) { return a.chord_position < b.chord_position; });
    return made;
  }

  double SolidRootSection::stress(const Facet &facet, const double *position, const SolidElements &elements,
                                  const Turn &turned) const
  {
    if (elements.is_failed(facet.cell))
      return 0.;
    const auto   x       = [&](const unsigned int k) { return Point3(position + 3 * facet.nodes[k]); };
    const Point3 outward = (x(2) - x(0)).cross(x(3) - x(1)).normalized();
    return stress_along(turned(root.span), turned(outward), elements.face_state(facet.cell, facet.face, 0.).stress);
  }

  RootSectionReport SolidRootSection::compute_report(const double *force, const double *position,
                                                     const SolidElements &elements, const Turn &turned) const
  {
    RootSectionReport report = compute_section_forces(root, force, position, 3);
    for (auto *list : {&report.chord_position, &report.stress_struck, &report.stress_rear})
      list->reserve(facets[0].size());
    for (std::size_t k = 0; k < facets[0].size(); ++k)
      {
        report.chord_position.push_back(facets[0][k].chord_position);
        report.stress_struck.push_back(stress(facets[0][k], position, elements, turned));
        report.stress_rear.push_back(stress(facets[1][k], position, elements, turned));
      }
    return report;
  }

  void SolidRootSection::add_nodes(std::vector<std::uint32_t> &nodes) const
  {
    nodes.insert(nodes.end(), root.nodes.begin(), root.nodes.end());
    for (const auto &side : facets)
      for (const Facet &facet : side)
        nodes.insert(nodes.end(), facet.nodes.begin(), facet.nodes.end());
  }

  std::size_t SolidRootSection::count_failed(const SolidElements &elements) const
  {
    std::set<std::uint32_t> failed; // with one layer both faces are of the same element
    for (const auto &side : facets)
      for (const Facet &facet : side)
        if (elements.is_failed(facet.cell))
          failed.insert(facet.cell);
    return failed.size();
  }

  TipRow::TipRow(const SolidMesh &mesh, const BladeEnd &tip) : normal(tip.normal)
  {
    for (const auto &faces : find_adjoining(mesh, tip))
      {
        std::set<std::uint32_t> nodes;
        for (const std::size_t f : faces)
          for (const std::uint32_t n : mesh.boundary[f].nodes)
            if (std::binary_search(tip.nodes.begin(), tip.nodes.end(), n))
              nodes.insert(n);
        add_row(mesh, {nodes.begin(), nodes.end()}, tip.chord);
      }
  }
} // namespace birdstrike
