#include "mesh/files/check_elements.h"
#include "mesh/files/combinations.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    using Id    = ImportedMesh::Id;
    using Group = ImportedMesh::Group;

    /// Places of things by their ids.
    template <class List, class IdOf>
    std::unordered_map<Id, std::uint32_t> places_of(const List &list, const IdOf &id_of, const std::string &what,
                                                    const std::string &path)
    {
      std::unordered_map<Id, std::uint32_t> places;
      for (std::uint32_t k = 0; k < list.size(); ++k)
        if (!places.emplace(id_of(list[k]), k).second)
          refuse_mesh_file(path, "the " + what + " " + std::to_string(id_of(list[k])) + " is given twice",
                           "Give each id once, or save the mesh again.");
      return places;
    }

    template <int dim>
    class Builder
    {
    public:
      Builder(const ImportedMesh &mesh, const std::string &path, dealii::Triangulation<dim, 3> &triangulation)
        : mesh(mesh), path(path), triangulation(triangulation)
      {
      }

      MeshLabels build()
      {
        check_elements<dim>(elements(), path);
        find_vertices();
        label_cells();
        create();
        label_sides();
        copy_thickness();
        return std::move(labels);
      }

    private:
      static constexpr unsigned int n_corners = 1u << dim, n_side_corners = n_corners / 2;
      static constexpr unsigned int round_the_faces[8] = {0, 1, 3, 2, 4, 5, 7, 6}; ///< deal.II's order
      using Side                                       = std::array<std::uint32_t, n_side_corners>;
      using LabelledSides =
        std::vector<std::pair<typename dealii::Triangulation<dim, 3>::face_iterator, Combinations::Groups>>;

      const ImportedMesh                   &mesh;
      const std::string                    &path;
      dealii::Triangulation<dim, 3>        &triangulation;
      MeshLabels                            labels;
      std::vector<dealii::Point<3>>         vertices;
      std::unordered_map<Id, std::uint32_t> vertex_of; ///< by node id, of nodes that cells have
      std::vector<dealii::CellData<dim>>    cells;

      const std::vector<ImportedMesh::Element> &elements() const
      {
        return mesh.elements[dim];
      }

      void find_vertices()
      {
        const auto node_of = places_of(
          mesh.nodes, [](const auto &node) { return node.first; }, "node", path);
        std::vector<bool> is_used(mesh.nodes.size(), false);
        for (const auto &element : elements())
          for (unsigned int k = 0; k < n_corners; ++k)
            {
              const auto found = node_of.find(element.nodes[k]);
              if (found == node_of.end())
                refuse_mesh_file(path,
                                 "element " + std::to_string(element.id) + " has the node " +
                                   std::to_string(element.nodes[k]) + ", which is not there",
                                 "Save the mesh again with all its nodes.");
              is_used[found->second] = true;
            }
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
          if (is_used[n])
            {
              const auto &[id, x] = mesh.nodes[n];
              vertex_of[id]       = static_cast<std::uint32_t>(vertices.size());
              vertices.emplace_back(x[0], x[1], x[2]);
              labels.node_ids.push_back(id);
            }
        for (const auto &element : elements())
          {
            labels.element_ids.push_back(element.id);
            cells.emplace_back(n_corners);
            for (unsigned int k = 0; k < n_corners; ++k)
              cells.back().vertices[k] = vertex_of.at(element.nodes[round_the_faces[k]]);
          }
      }

      void label_cells()
      {
        const auto place_of = places_of(
          elements(), [](const auto &element) { return element.id; }, "element", path);
        std::vector<Combinations::Groups> groups_of(elements().size());
        std::vector<bool>                 is_material(mesh.groups.size(), false);
        for (std::uint32_t g = 0; g < mesh.groups.size(); ++g)
          {
            is_material[g] = mesh.groups[g].dim == static_cast<unsigned int>(dim);
            for (const Id id : mesh.groups[g].elements[dim])
              if (const auto found = place_of.find(id); found != place_of.end())
                {
                  is_material[g] = true;
                  if (auto &groups = groups_of[found->second]; groups.empty() || groups.back() != g)
                    groups.push_back(g);
                }
          }
        const Combinations combinations(mesh.groups, &Group::material_number, {groups_of.begin(), groups_of.end()});
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
          cells[cell].material_id = combinations[groups_of[cell]];
        combinations.name(mesh.groups, &Group::material_number, is_material, labels.materials);
      }

      /// deal.II's invert_cells_with_negative_measure() measures from the origin, where the sign of a cell's volume
      /// drowns in round-off 1000 m away; here from the cell's first corner.
      void turn_inverted_cells()
      {
        for (auto &cell : cells)
          {
            std::vector<dealii::Point<dim>>     corners(n_corners);
            std::array<unsigned int, n_corners> as_numbered;
            for (unsigned int v = 0; v < n_corners; ++v)
              {
                corners[v]     = dealii::Point<dim>(vertices[cell.vertices[v]] - vertices[cell.vertices[0]]);
                as_numbered[v] = v;
              }
            if (dealii::GridTools::cell_measure(corners, as_numbered) < 0.)
              for (const unsigned int v : {0, 1, 4, 5})
                std::swap(cell.vertices[v], cell.vertices[v + 2]);
          }
      }

      void create()
      {
        if constexpr (dim == 3)
          turn_inverted_cells();
        dealii::GridTools::consistently_order_cells(cells);
        try
          {
            triangulation.create_triangulation(vertices, cells, {});
          }
        catch (const typename dealii::Triangulation<dim, 3>::DistortedCellList &)
          {
            // The cells exist; check_cells finds the first bad one and names it.
          }
      }

      /// A side by its nodes, sorted; of nodes that no cell has: none.
      std::optional<Side> side_of(const Id *nodes) const
      {
        Side side;
        for (unsigned int k = 0; k < n_side_corners; ++k)
          if (const auto found = vertex_of.find(nodes[k]); found != vertex_of.end())
            side[k] = found->second;
          else
            return {};
        std::sort(side.begin(), side.end());
        return side;
      }

      void label_sides()
      {
        std::map<Side, Combinations::Groups>          listed;
        std::map<std::uint32_t, Combinations::Groups> of_node;
        std::vector<bool>                             is_boundary(mesh.groups.size(), false);
        const auto                                    place_of = places_of(
                                             mesh.elements[dim - 1], [](const auto &e) { return e.id; }, "element", path);
        for (std::uint32_t g = 0; g < mesh.groups.size(); ++g)
          {
            const Group &group = mesh.groups[g];
            is_boundary[g]     = group.dim == static_cast<unsigned int>(dim - 1);
            const auto list    = [&](const Id *nodes) {
              is_boundary[g] = true;
              if (const auto side = side_of(nodes))
                listed[*side].push_back(g);
            };
            for (const Id id : group.elements[dim - 1])
              if (const auto found = place_of.find(id); found != place_of.end())
                list(mesh.elements[dim - 1][found->second].nodes.data());
            for (const auto &side : group.sides)
              if (side.size() == n_side_corners)
                list(side.data());
            for (const Id node : group.nodes)
              if (const auto found = vertex_of.find(node); found != vertex_of.end())
                {
                  is_boundary[g] = true;
                  of_node[found->second].push_back(g);
                }
          }
        set_boundary_ids(listed, of_node, is_boundary);
      }

      static void make_set(Combinations::Groups &groups)
      {
        std::sort(groups.begin(), groups.end());
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
      }

      void set_boundary_ids(std::map<Side, Combinations::Groups>          &listed,
                            std::map<std::uint32_t, Combinations::Groups> &of_node,
                            const std::vector<bool>                       &is_boundary)
      {
        for (auto &[node, groups] : of_node)
          make_set(groups);
        LabelledSides sides;
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              {
                const auto face = cell->face(f);
                Side       side;
                for (unsigned int k = 0; k < n_side_corners; ++k)
                  side[k] = face->vertex_index(k);
                std::sort(side.begin(), side.end());
                Combinations::Groups groups = of_node[side[0]], common;
                for (unsigned int k = 1; k < n_side_corners; ++k, groups.swap(common), common.clear())
                  std::set_intersection(groups.begin(), groups.end(), of_node[side[k]].begin(), of_node[side[k]].end(),
                                        std::back_inserter(common));
                if (const auto found = listed.find(side); found != listed.end())
                  groups.insert(groups.end(), found->second.begin(), found->second.end());
                make_set(groups);
                sides.emplace_back(face, groups);
              }
        std::set<Combinations::Groups> occurring;
        for (const auto &[face, groups] : sides)
          occurring.insert(groups);
        const Combinations combinations(mesh.groups, &Group::boundary_number, occurring);
        for (const auto &[face, groups] : sides)
          face->set_boundary_id(combinations[groups]);
        combinations.name(mesh.groups, &Group::boundary_number, is_boundary, labels.boundaries);
        count_nodes_of_sets(of_node, sides);
      }

      /// Of sets of nodes: those of the mesh, and those that no side of the set has.
      void count_nodes_of_sets(const std::map<std::uint32_t, Combinations::Groups> &of_node, const LabelledSides &sides)
      {
        std::set<std::pair<std::uint32_t, std::uint32_t>> on_sides; // groups, nodes
        for (const auto &[face, groups] : sides)
          for (const std::uint32_t group : groups)
            for (const unsigned int v : face->vertex_indices())
              on_sides.emplace(group, face->vertex_index(v));
        std::map<std::uint32_t, NamedIds::Nodes> of_group;
        for (const auto &[node, groups] : of_node)
          for (const std::uint32_t group : groups)
            {
              ++of_group[group].n;
              if (!on_sides.contains({group, node}))
                of_group[group].off_sides.push_back(labels.node_ids[node]);
            }
        for (const auto &[group, nodes] : of_group)
          {
            for (const std::string &name : mesh.groups[group].all_names())
              labels.boundaries.add_nodes(name, nodes);
            if (const auto number = mesh.groups[group].boundary_number)
              labels.boundaries.add_nodes(std::to_string(*number), nodes);
          }
      }

      void copy_thickness()
      {
        if (dim == 3 || std::none_of(elements().begin(), elements().end(),
                                     [](const auto &element) { return element.thickness != std::array<double, 4>{}; }))
          return;
        for (const auto &cell : triangulation.active_cell_iterators())
          {
            const auto            &element = elements()[cell->active_cell_index()];
            std::array<double, 4> &corners = labels.corner_thickness.emplace_back();
            for (unsigned int v = 0; v < 4; ++v)
              for (unsigned int k = 0; k < 4; ++k)
                if (vertex_of.at(element.nodes[k]) == cell->vertex_index(v))
                  corners[v] = element.thickness[k];
          }
      }
    };
  } // namespace

  template <int dim>
  MeshLabels make_triangulation(const ImportedMesh &mesh, const std::string &path,
                                dealii::Triangulation<dim, 3> &triangulation)
  {
    return Builder<dim>(mesh, path, triangulation).build();
  }

  template MeshLabels make_triangulation(const ImportedMesh &, const std::string &, dealii::Triangulation<2, 3> &);
  template MeshLabels make_triangulation(const ImportedMesh &, const std::string &, dealii::Triangulation<3, 3> &);
} // namespace birdstrike
