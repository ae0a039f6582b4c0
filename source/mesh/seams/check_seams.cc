#include "mesh/seams/check_seams.h"

#include "mesh/seams/find_seams.h"

#include <fmt/format.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::string corners_of(const Rim &rim, const Rim::Side &side, const MeshLabels &labels)
    {
      std::vector<std::int64_t> ids;
      for (unsigned int k = 0; k < rim.n_corners; ++k)
        ids.push_back(labels.node_ids[side.nodes[k]]);
      if (rim.n_corners == 2)
        std::ranges::sort(ids);
      return fmt::format("{} and {}", fmt::join(ids.begin(), ids.end() - 1, ", "), ids.back());
    }

    [[noreturn]] void refuse(const Rim &rim, const std::vector<HangingNode> &hanging, const MeshLabels &labels,
                             const std::string &path)
    {
      const bool         is_shell = rim.n_corners == 2;
      const HangingNode &first    = hanging.front();
      const Rim::Side   &side     = rim.sides[first.side];
      const Point3      &x        = rim.x[first.node];
      refuse_mesh_file(
        path,
        fmt::format(
          "node {} at ({:.6g}, {:.6g}, {:.6g}) m hangs on {} of element {} between its nodes {}, which has "
          "no node there. Nothing joins the elements at this node to that one (nodes that hang in this mesh: {})",
          labels.node_ids[first.node], x[0], x[1], x[2], is_shell ? "the edge" : "the face",
          labels.element_ids[side.cell], corners_of(rim, side, labels), hanging.size()),
        fmt::format("Elements must share whole {0}: mesh both sides of {1} alike there (Gmsh: the same transfinite "
                    "number on both), or split element {2} at the node. Merging nodes does not help. If the blade is "
                    "meant to be cut there, part both sides by more than {3} of an element.",
                    is_shell ? "edges" : "faces", is_shell ? "the line" : "the interface",
                    labels.element_ids[side.cell], OpenSeams::near));
    }

    std::int64_t label(const std::vector<std::int64_t> &labels, const std::int64_t place)
    {
      return labels[static_cast<std::size_t>(place)];
    }
  } // namespace

  template <int dim>
  OpenSeams check_seams(const dealii::Triangulation<dim, 3> &triangulation, const MeshLabels &labels,
                        const std::string &path)
  {
    const Rim rim(triangulation);
    Seams     seams = find_seams(rim);
    if (!seams.hanging.empty())
      refuse(rim, seams.hanging, labels, path);
    for (OpenSeams::Found *found : {&seams.open.pairs, &seams.open.beside})
      if (found->n > 0)
        found->labels = {label(labels.node_ids, found->labels[0]),
                         label(found == &seams.open.pairs ? labels.node_ids : labels.element_ids, found->labels[1])};
    return seams.open;
  }

  template OpenSeams check_seams(const dealii::Triangulation<2, 3> &, const MeshLabels &, const std::string &);
  template OpenSeams check_seams(const dealii::Triangulation<3, 3> &, const MeshLabels &, const std::string &);
} // namespace birdstrike
