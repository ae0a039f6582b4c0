#include "structure/census.h"
#include "structure/deformable_blade.h"
#include "structure/histories/watched_blade.h"
#include <birdstrike/core/errors.h>

#include <algorithm>

namespace birdstrike
{
  template <class Kind>
  EnergyReport DeformableBlade<Kind>::energies() const
  {
    EnergyReport report = motion.energies();
    elements.add_energies(report);
    return plane.whole(report);
  }

  template <class Kind>
  BladeCensus DeformableBlade<Kind>::census() const
  {
    BladeCensus census = compute_census(mesh);
    census.bytes       = motion.bytes() + elements.bytes() + Kind::bytes_per_cell * census.n_elements;
    census.n_elements  = n_elements();
    census.n_nodes     = n_nodes();
    census.mass        = mass();
    census.area        = plane.whole(census.area);
    census.n_held_dofs = supports.held_dofs.size();
    if (!lumped.element_thickness.empty())
      {
        const auto [least, most] = std::ranges::minmax(lumped.element_thickness);
        census.thinnest          = least;
        census.thickest          = most;
        census.n_thickness_given = plane.whole(lumped.n_given);
      }
    Point3 moment = Point3::Zero();
    for (std::size_t n = 0; n < mesh.space.n_owned(); ++n)
      moment += lumped.node[n] * mesh.node(n);
    for (unsigned int d = 0; d < 3; ++d)
      census.centre_of_mass[d] = d == 1 && plane.exists() ? 0. : moment[d] / lumped.total;
    std::vector<std::uint32_t> driven;
    for (const auto &support : supports.driven)
      driven.insert(driven.end(), support.dofs.begin(), support.dofs.end());
    census.supports               = compute_support_census(mesh.nodes, Kind::n_unknowns, supports.held_dofs, driven);
    census.held_faces             = supports.held_faces;
    census.n_elements_with_points = plane.whole(elements.n_promoted());
    census.mass_scaling           = scaling;
    census.mass_scaling.n_scaled  = plane.whole(scaling.n_scaled);
    for (std::size_t k = 0; k < sections.n_of_blade; ++k)
      {
        SizeCensus sizes{sections.number[k]};
        for (std::size_t of_blade = k; of_blade < elements.n_sections(); of_blade += sections.n_of_blade)
          elements.add_sizes(of_blade, sizes);
        sizes.n_beyond = plane.whole(sizes.n_beyond);
        if (sizes.largest > 0.)
          census.sizes.push_back(sizes);
      }
    census.warnings = supports.warnings;
    count_sections(census);
    return census;
  }

  /// Sections that a mesh from a file splits into several formulations count once.
  template <class Kind>
  void DeformableBlade<Kind>::count_sections(BladeCensus &census) const
  {
    for (std::size_t k = 0; k < sections.n_of_blade; ++k)
      {
        const std::size_t number = sections.number[k];
        auto              sum    = std::ranges::find(census.sections, number, &SectionCensus::number);
        if (sum == census.sections.end())
          sum = census.sections.insert(sum, {number, 0, 0., 0.});
        FormulationCensus of_formulation{number, Kind::formulation_of(sections.all[k]), 0, n_layers[k]};
        for (std::size_t of_blade = k; of_blade < elements.n_sections(); of_blade += sections.n_of_blade)
          {
            const auto sums = elements.section_sums(of_blade);
            of_formulation.n_elements += plane.whole(sums.n_elements);
            sum->mass += plane.whole(sums.mass);
            sum->plastic_work += plane.whole(sums.plastic_work);
          }
        sum->n_elements += of_formulation.n_elements;
        census.formulations.push_back(of_formulation);
      }
    if (census.sections.size() == 1)
      census.sections.clear();
  }

  template <class Kind>
  FieldSnapshot DeformableBlade<Kind>::snapshot() const
  {
    const auto   &plain = mesh;
    FieldSnapshot snapshot;
    snapshot.dim = Kind::dim;
    for (const auto &x : plain.nodes)
      snapshot.points.insert(snapshot.points.end(), x.begin(), x.end());
    std::vector<std::size_t> left; // failed elements are not shown
    Field                    number{"element", "", true, 1, {}, true}, damage{"damage", "-", true, 1, {}};
    Field                    failed_points{"failed_points", "", true, 1, {}, true};
    for (std::size_t e = 0; e < plain.cells.size(); ++e)
      if (!elements.is_failed(e))
        {
          const auto &nodes = Kind::nodes_of(plain, e);
          snapshot.cells.insert(snapshot.cells.end(), nodes.begin(), nodes.end());
          left.push_back(e);
          number.values.push_back(static_cast<double>(plain.element_label(e)));
          if (can_fail)
            {
              damage.values.push_back(elements.damage(e));
              failed_points.values.push_back(static_cast<double>(elements.n_failed_points(e)));
            }
        }
    Field node{"node", "", false, 1, {}, true};
    for (std::size_t n = 0; n < plain.nodes.size(); ++n)
      node.values.push_back(static_cast<double>(plain.node_label(n)));
    snapshot.fields = {std::move(node), std::move(number)};
    motion.add_fields(snapshot.fields);
    snapshot.fields.push_back(contact_pressure());
    Kind::add_fields(elements, left, snapshot.fields);
    if (row.size() > 1)
      {
        Field blade{"blade", "", true, 1, {}, true}; // its place in the row
        for (const std::size_t e : left)
          blade.values.push_back(row[plain.blade_of(e)]);
        snapshot.fields.push_back(std::move(blade));
      }
    if (std::ranges::any_of(sections.number, [&](const std::size_t k) { return k != sections.number[0]; }))
      {
        Field section{"section", "-", true, 1, {}, true}; // 0: the blade's own
        for (const std::size_t e : left)
          section.values.push_back(static_cast<double>(sections.number[sections.of_element[e]]));
        snapshot.fields.push_back(std::move(section));
      }
    if (can_fail)
      snapshot.fields.insert(snapshot.fields.end(), {std::move(damage), std::move(failed_points)});
    return snapshot;
  }

  // The force on a node along the normal of its facets over their shares of area, of the bent blade.
  template <class Kind>
  Field DeformableBlade<Kind>::contact_pressure() const
  {
    const auto         &skin = mesh.surface();
    std::vector<Point3> area(mesh.nodes.size(), Point3::Zero());
    const double *const x = motion.positions();
    for (std::size_t f = 0; f < skin.cells.size(); ++f)
      {
        std::array<Point3, 4> corner;
        for (unsigned int c = 0; c < 4; ++c)
          corner[c] = Point3(x + 3 * skin.cells[f][c]);
        const Point3 share = 0.125 * (corner[2] - corner[0]).cross(corner[3] - corner[1]);
        for (const std::uint32_t node : skin.cells[f])
          area[node] += share;
      }
    Field               field{"contact_pressure", "Pa", false, 1, {}};
    const double *const force = motion.contact_forces();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      {
        const double squared = area[n].squaredNorm(); // 0 within a body, and across its edges if facets cancel
        field.values.push_back(squared > 0. ? std::abs(Point3(force + Kind::n_unknowns * n).dot(area[n])) / squared
                                            : 0.);
      }
    return field;
  }

  template <class Kind>
  BladeHistories DeformableBlade<Kind>::make_histories(const HistoryRequests &requests) const
  {
    if (hub.turns() && !requests.stations.empty())
      throw InputError("Output/Histories/Stations: forces on sections of a blade that turns are not there.\nLeave it "
                       "empty; root forces are reported in the frame of the hub.");
    if (hub.turns() && requests.is_any() && requests.axes != HistoryRequests().axes)
      throw InputError(
        "Output/Histories/Axes: on a blade that turns components are in global axes.\nSet it to global.");
    BladeHistories histories = make_blade_histories<Kind>({mesh, elements, motion, roles, stiffness, plane}, requests);
    histories.warnings.insert(histories.warnings.begin(), probe_warnings.begin(), probe_warnings.end());
    return histories;
  }

  template <class Kind>
  RootSectionReport DeformableBlade<Kind>::root_section() const
  {
    const Turn    turned   = hub.turn(motion.present_time());
    const double *position = motion.positions(), *force = nullptr;
    if (!hub.turns())
      force = motion.support_forces();
    else
      {
        const auto &seen = motion.in_turning_frame();
        force            = seen.force.data();
        position         = seen.position.data();
      }
    RootSectionReport report = root.compute_report(force, position, elements, turned);
    for (double *sum : {&report.normal_force, &report.bending_moment, &report.transverse_force})
      *sum = plane.whole(*sum);
    return report;
  }

  template <class Kind>
  TipDeflection DeformableBlade<Kind>::tip_deflection() const
  {
    return tip.compute_deflection(hub.turns() ? motion.in_turning_frame().displacement.data() : motion.displacements(),
                                  Kind::n_unknowns);
  }

  template <class Kind>
  std::vector<BladeLoads> DeformableBlade<Kind>::loads_of_row() const
  {
    if (row.size() == 1)
      return {};
    if (!hub.turns())
      return members.loads(motion.support_forces(), motion.positions(), motion.displacements(), elements, {});
    const auto &seen = motion.in_turning_frame();
    return members.loads(seen.force.data(), seen.position.data(), seen.displacement.data(), elements,
                         hub.turn(motion.present_time()));
  }

  template <class Kind>
  std::vector<BladeBalance> DeformableBlade<Kind>::balance_of_row() const
  {
    return members.balance(motion, elements);
  }

  template <class Kind>
  std::optional<SpanLine> DeformableBlade<Kind>::span_line() const
  {
    return make_span_line(roles, tip, mesh.nodes[0].data());
  }

  template <class Kind>
  std::optional<Point3> DeformableBlade<Kind>::span_direction() const
  {
    const Point3 along = roles.tip.middle - roles.root.middle;
    if (!roles.root.is_present() || !roles.tip.is_present() || along.norm() == 0.)
      return {};
    return along.normalized();
  }

  template <class Kind>
  std::vector<PeakPlasticStrain> DeformableBlade<Kind>::peak_plastic_strains() const
  {
    std::vector<PeakPlasticStrain> result;
    for (std::size_t k = 0; const auto &peak : elements.max_plastic_strains())
      {
        const Point3            c = mesh.centroid(peak.element);
        const PeakPlasticStrain here{peak.value, peak.element, {{c[0], c[1], c[2]}}, sections.number[k]};
        ++k;
        const auto whole = std::ranges::find(result, here.section, &PeakPlasticStrain::section);
        if (whole == result.end() || row.size() > 1) // of a row each blade's
          result.push_back(here);
        else if (here.value > whole->value)
          *whole = here;
      }
    return result;
  }

  template <class Kind>
  FailureReport DeformableBlade<Kind>::failure() const
  {
    FailureReport report;
    report.can_fail = can_fail;
    if (!can_fail)
      return report;
    std::size_t most = 0;
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      if (const std::size_t n = elements.n_failed_points(e); n > 0 && mesh.is_owned(e) && !elements.is_failed(e))
        {
          if (n > most)
            {
              most             = n;
              const Point3 at  = mesh.centroid(e);
              report.partly_at = {{at[0], at[1], at[2]}};
            }
          report.n_partly += plane.whole(std::size_t(1));
          report.n_points += plane.whole(n);
        }
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      if (mesh.is_owned(e))
        {
          const auto [fibre, matrix] = Kind::failed_ply_mass(elements, e);
          report.fibre_mass += plane.whole(fibre);
          report.matrix_mass += plane.whole(matrix);
        }
    if (elements.n_failed() == 0)
      return report;
    std::size_t n_owned_failed = 0;
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      n_owned_failed += mesh.is_owned(e) && elements.is_failed(e);
    report.n_elements  = plane.whole(n_owned_failed);
    report.n_collapsed = plane.whole(elements.n_collapsed());
    report.n_at_root   = plane.whole(root.count_failed(elements));
    report.mass        = plane.whole(elements.failed_mass());
    for (std::size_t n = 0; n < mesh.space.n_owned(); ++n)
      if (elements.is_free(n))
        report.free_mass += plane.whole(lumped.node[n]);
    report.has_lost_tip = tip.has_any([&](const std::uint32_t n) { return elements.is_free(n); });
    return report;
  }

  template class DeformableBlade<ShellKind>;
  template class DeformableBlade<SolidKind>;
} // namespace birdstrike
