#include "structure/probes/solid_sections.h"
#include <birdstrike/material/radial_return.h>
#include <birdstrike/mesh/orientation.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Face = VolumeMesh::BoundarySide;

    bool has_id(const Face &face, const std::vector<unsigned int> &ids)
    {
      return std::find(ids.begin(), ids.end(), face.id) != ids.end();
    }

    /// Mean direction of the third axis of a cell, m.
    Point3 third_axis(const VolumeMesh &mesh, const std::size_t cell)
    {
      Point3 sum = Point3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        sum += mesh.node(mesh.cells[cell][k + 4]) - mesh.node(mesh.cells[cell][k]);
      return 0.25 * sum;
    }

    /// The thin principal direction of faces about their centroid: the second of three by second moment, after the one
    /// out of their plane.
    Point3 thin_axis(const VolumeMesh &mesh, const std::vector<std::size_t> &faces, const Point3 &centroid)
    {
      Matrix3<double> moment = Matrix3<double>::Zero();
      for (const std::size_t f : faces)
        for (const std::uint32_t n : mesh.boundary[f].nodes)
          {
            const Point3 arm = mesh.node(n) - centroid;
            moment += area_vector(mesh, mesh.boundary[f]).norm() * arm * arm.transpose();
          }
      if (!mesh.symmetry_nodes.empty()) // with the mirror image
        moment(0, 1) = moment(1, 0) = moment(1, 2) = moment(2, 1) = 0.;
      const Point3 axis = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(moment).eigenvectors().col(1);
      return sign_by_axes(axis, {{2, 1, 0}}) * axis;
    }

    /// Scales the deviator so that von Mises' stress is no more than the flow stress.
    void limit(const double flow_stress, std::array<double, 6> &s)
    {
      double stress[6];
      std::copy(s.begin(), s.end(), stress);
      if (const double q = von_mises(stress); q > flow_stress)
        scale_deviator(flow_stress / q, stress);
      std::copy(stress, stress + 6, s.begin());
    }
  } // namespace

  EndFaces::EndFaces(const VolumeMesh &mesh, const std::vector<unsigned int> &ids)
  {
    double area = 0.;
    Point3 axis = Point3::Zero();
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
      if (const Face &face = mesh.boundary[f]; has_id(face, ids))
        {
          const Point3 vector = area_vector(mesh, face);
          faces.push_back(f);
          area += vector.norm();
          centroid += vector.norm() * middle(mesh, face);
          outward += vector;
          axis += vector.norm() * third_axis(mesh, face.cell).normalized();
        }
    if (faces.empty() || outward.norm() < 1e-6 * area)
      {
        faces.clear(); // nothing here, or all around: no single end to speak of
        return;
      }
    centroid /= area;
    if (!mesh.symmetry_nodes.empty())
      centroid[1] = 0.; // the middle of the whole
    outward.normalize();
    normal = mesh.layers > 0 ? axis : thin_axis(mesh, faces, centroid);
    if (normal.norm() < 1e-6 * (mesh.layers > 0 ? area : 1.))
      faces.clear();
    normal.normalize();
  }

  std::array<std::vector<std::size_t>, 2> EndFaces::find_adjoining(const VolumeMesh                &mesh,
                                                                   const std::vector<unsigned int> &ids) const
  {
    std::set<std::uint32_t> cells;
    for (const std::size_t f : faces)
      cells.insert(mesh.boundary[f].cell);
    std::array<std::vector<std::size_t>, 2> found;
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
      if (const Face &face = mesh.boundary[f]; !has_id(face, ids) && cells.count(face.cell) > 0)
        {
          const double cosine = area_vector(mesh, face).normalized().dot(normal);
          if (std::abs(cosine) > 0.5)
            found[cosine > 0. ? 1 : 0].push_back(f);
        }
    return found;
  }

  SolidRootSection::SolidRootSection(const VolumeMesh &mesh, const std::vector<unsigned int> &root_ids)
  {
    const EndFaces root(mesh, root_ids);
    if (!root.is_present())
      return;
    frame.nodes  = mesh.nodes_on(root_ids);
    frame.origin = root.centroid;
    frame.span   = -root.outward;
    frame.normal = root.normal;
    frame.make_orthonormal();
    const auto adjoining = root.find_adjoining(mesh, root_ids);
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

  void SolidRootSection::turn()
  {
    frame.normal = -frame.normal;
    std::swap(facets[0], facets[1]);
  }

  std::vector<SolidRootSection::Facet> SolidRootSection::make_facets(const VolumeMesh               &mesh,
                                                                     const std::vector<std::size_t> &faces) const
  {
    std::vector<Facet> made;
    for (const std::size_t f : faces)
      {
        const Face &face = mesh.boundary[f];
        Facet       facet{face.cell, face.nodes, {}, (middle(mesh, face) - frame.origin).dot(frame.chord)};
        const auto &cell = mesh.cells[face.cell];
        for (unsigned int k = 0; k < 4; ++k)
          facet.corners[k] =
            static_cast<unsigned int>(std::find(cell.begin(), cell.end(), face.nodes[k]) - cell.begin());
        made.push_back(facet);
      }
    std::sort(made.begin(), made.end(),
              [](const Facet &a, const Facet &b) { return a.chord_position < b.chord_position; });
    return made;
  }

  double SolidRootSection::stress(const Facet &facet, const double *position, const SolidElements &elements) const
  {
    if (elements.is_failed(facet.cell))
      return 0.;
    std::array<double, 6> mean{};
    for (const unsigned int corner : facet.corners)
      {
        const auto at = elements.corner_stress(facet.cell, corner);
        for (unsigned int c = 0; c < 6; ++c)
          mean[c] += 0.25 * at[c];
      }
    const Hardening &hardening = elements.section(facet.cell).material.hardening;
    const double     flow = compute_flow_stress(hardening, elements.state(facet.cell).plastic_strain, 0., 1., 1.).value;
    limit(flow, mean);
    const auto   x       = [&](const unsigned int k) { return Point3(position + 3 * facet.nodes[k]); };
    const Point3 outward = (x(2) - x(0)).cross(x(3) - x(1)).normalized();
    return SectionFrame::stress_along(frame.span, outward, mean);
  }

  RootSectionReport SolidRootSection::compute_report(const double *force, const double *position,
                                                     const SolidElements &elements) const
  {
    RootSectionReport report = frame.compute_forces(force, position, 3);
    for (auto *list : {&report.chord_position, &report.stress_struck, &report.stress_rear})
      list->reserve(facets[0].size());
    for (std::size_t k = 0; k < facets[0].size(); ++k)
      {
        report.chord_position.push_back(facets[0][k].chord_position);
        report.stress_struck.push_back(stress(facets[0][k], position, elements));
        report.stress_rear.push_back(stress(facets[1][k], position, elements));
      }
    return report;
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

  TipRow make_tip_row(const VolumeMesh &mesh, const std::vector<unsigned int> &tip_ids)
  {
    TipRow         row;
    const EndFaces tip(mesh, tip_ids);
    if (!tip.is_present())
      return row;
    const auto   on_tip = mesh.nodes_on(tip_ids);
    const Point3 chord  = chord_along(tip.normal, tip.outward);
    for (const auto &faces : tip.find_adjoining(mesh, tip_ids))
      {
        std::set<std::uint32_t> nodes;
        for (const std::size_t f : faces)
          for (const std::uint32_t n : mesh.boundary[f].nodes)
            if (std::binary_search(on_tip.begin(), on_tip.end(), n))
              nodes.insert(n);
        row.add_row(mesh.nodes, {nodes.begin(), nodes.end()}, mesh.symmetry_nodes, chord, tip.normal);
      }
    return row;
  }
} // namespace birdstrike
