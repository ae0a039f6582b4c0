#pragma once

#include "structure/histories/axes.h"
#include "structure/histories/places.h"
#include "structure/shell_kind.h"
#include "structure/solid_kind.h"
#include <birdstrike/core/symmetry_plane.h>
#include <birdstrike/structure/histories.h>

namespace birdstrike
{
  /// What histories look at; all of it outlives them.
  template <class Kind>
  struct WatchedBlade
  {
    const typename Kind::Mesh     &mesh;
    const typename Kind::Elements &elements;
    const typename Kind::Nodes    &motion;
    const BladeRoles              &roles;
    const std::vector<double>     &stiffness; ///< of the elements, as of the roles
    SymmetryPlane                  plane;
  };

  /// A node or element of the mesh, as text: "node 17 at (..) m".
  template <int dim>
  std::string describe_node(const CellMesh<dim> &mesh, std::size_t node);
  template <int dim>
  std::string describe_element(const CellMesh<dim> &mesh, std::size_t element);

  /// A place farther from the mesh than this share of the diagonal of its box is none of the blade.
  constexpr double farthest_place = 0.1;

  /// The node that a place names, the nearest of a point; adds a warning where that is farther than the elements there
  /// are long. Throws InputError for a number that the mesh does not have, and for a point that is farther than that
  /// and than farthest_place.
  template <int dim>
  std::uint32_t find_node(const BladeMesh<dim> &mesh, const Place &place, const std::string &entry, Warnings &warnings);

  /// The same for Blade/Probes.
  template <int dim>
  Warnings warn_of_far_probes(const std::string &probes, const BladeMesh<dim> &mesh);

  /// The element that a place names, the nearest of a point; warnings and errors as above.
  template <int dim>
  std::uint32_t find_element(const CellMesh<dim> &mesh, const Place &place, const std::string &entry,
                             Warnings &warnings);

  /// The tables; each throws InputError for requests that cannot be met, and adds to the warnings.
  template <class Kind>
  std::unique_ptr<HistoryTable> make_node_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests,
                                                Warnings &warnings);
  template <class Kind>
  std::unique_ptr<HistoryTable> make_element_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests,
                                                   Warnings &warnings);
  template <class Kind>
  std::unique_ptr<HistoryTable> make_gauge_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests,
                                                 Warnings &warnings);
  template <class Kind>
  std::unique_ptr<HistoryTable> make_section_table(const WatchedBlade<Kind> &blade, const HistoryRequests &requests);

  /// All that are asked for.
  template <class Kind>
  BladeHistories make_blade_histories(const WatchedBlade<Kind> &blade, const HistoryRequests &requests)
  {
    BladeHistories histories;
    if (!requests.nodes.empty())
      histories.tables.push_back(make_node_table(blade, requests, histories.warnings));
    if (!requests.elements.empty())
      histories.tables.push_back(make_element_table(blade, requests, histories.warnings));
    if (!requests.gauges.empty())
      histories.tables.push_back(make_gauge_table(blade, requests, histories.warnings));
    if (!requests.stations.empty())
      histories.tables.push_back(make_section_table(blade, requests));
    return histories;
  }
} // namespace birdstrike
