#include "mesh/files/gmsh/elements.h"

#include <algorithm>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    constexpr const char *recombine =
      "Recombine the triangles (Gmsh: Mesh.RecombineAll = 1), or name the groups that are the blade in "
      "Blade/Mesh/Parts.";
    constexpr const char *sweep = "Mesh bodies by sweeping or transfinite volumes, recombined: Gmsh offers no other "
                                  "hexahedra. Or name the groups that are the blade in Blade/Mesh/Parts.";

    /// "Gmsh reference manual", MSH file format: those of the first order.
    constexpr GmshElements::Type types[] = {{15, 0, 1},
                                            {1, 1, 2},
                                            {3, 2, 4},
                                            {5, 3, 8},
                                            {2, 2, 3, "a triangle", recombine},
                                            {4, 3, 4, "a tetrahedron", sweep},
                                            {6, 3, 6, "a wedge", sweep},
                                            {7, 3, 5, "a pyramid", sweep}};

    std::string complaint(const Id number, const std::string &shape)
    {
      return "an element is of Gmsh's type " + std::to_string(number) + ", " + shape +
             ". Allowed: hexahedra, quadrilaterals and lines of the first order";
    }
  } // namespace

  const GmshElements::Type &GmshElements::type_of(const std::string_view field) const
  {
    const Id    number = lines.integer(field);
    const auto *found =
      std::find_if(std::begin(types), std::end(types), [number](const Type &type) { return type.number == number; });
    if (found == std::end(types))
      lines.refuse(complaint(number, "of a higher order"), "Mesh by the first order (Gmsh: Mesh.ElementOrder = 1).");
    return *found;
  }

  std::uint32_t GmshElements::place(const Owner &one)
  {
    const auto [found, is_new] = place_of.try_emplace(one, static_cast<std::uint32_t>(owners.size()));
    if (is_new)
      owners.push_back(one);
    return found->second;
  }

  std::uint32_t GmshElements::owner_of(const unsigned int dim, const GmshEntities::Entity &entity)
  {
    if (entity.elementary != 0)
      partitions[dim].insert(entity.partitions.begin(), entity.partitions.end());
    return place({entity.groups, entity.elementary});
  }

  void GmshElements::note_partitions(const unsigned int dim, const Fields &fields, const Id n_tags)
  {
    if (n_tags < 4 || lines.integer(fields[5]) != n_tags - 3)
      return;
    partitions[dim].insert(lines.integer(fields[6]));
    for (Id tag = 3; tag < n_tags; ++tag)
      largest_partition = std::max(largest_partition, lines.group_number(fields[static_cast<std::size_t>(3 + tag)]));
  }

  void GmshElements::add_of_format_2(const Fields &fields)
  {
    is_format_2     = true;
    const Id n_tags = lines.count(fields[2]);
    if (n_tags >= static_cast<Id>(fields.size()) - 3)
      lines.refuse("an element has " + std::to_string(n_tags) + " tags and no nodes", "Save the mesh again.");
    const Type &type       = type_of(fields[1]);
    const Id    number     = n_tags > 0 ? lines.group_number(fields[3]) : 0;
    const Id    elementary = n_tags > 1 ? lines.integer(fields[4]) : 0;
    note_partitions(type.dim, fields, n_tags);
    add(type, fields, static_cast<std::size_t>(3 + n_tags),
        place({number > 0 ? std::vector<Id>{number} : std::vector<Id>{}, elementary}));
  }

  void GmshElements::add_of_entity(const Type &type, const Fields &fields, const std::uint32_t owned_by)
  {
    add(type, fields, 1, owned_by);
  }

  void GmshElements::add(const Type &type, const Fields &fields, const std::size_t first, const std::uint32_t owned_by)
  {
    if (fields.size() != first + type.n_nodes)
      lines.refuse("element " + std::string(fields[0]) + " of Gmsh's type " + std::to_string(type.number) + " has " +
                     std::to_string(fields.size() - std::min(fields.size(), first)) + " nodes",
                   "It must have " + std::to_string(type.n_nodes) + ". A line too few or too many?");
    if (type.dim == 0)
      return;
    if (type.shape != nullptr)
      return add_not_offered(type, lines.integer(fields[0]), owned_by);
    auto &element = mesh.elements[type.dim].emplace_back(ImportedMesh::Element{lines.integer(fields[0])});
    for (unsigned int k = 0; k < type.n_nodes; ++k)
      element.nodes[k] = lines.integer(fields[first + k]);
    owner[type.dim].push_back(owned_by);
    if (const std::size_t n = owners[owned_by].first.size(); n > 1)
      lines.add_listed(n);
  }

  void GmshElements::add_not_offered(const Type &type, const Id id, const std::uint32_t owned_by)
  {
    mesh.elements_not_offered[type.dim].push_back(
      mesh.not_offered(id, lines.line_number(), complaint(type.number, type.shape), type.remedy));
    owner_not_offered[type.dim].push_back(owned_by);
  }

  /// Whether the copy lies in another group of the same entity: the original then lies in both.
  bool GmshElements::take_over(const unsigned int dim, const std::size_t copy, const std::size_t original)
  {
    const Owner of_copy = owners[owner[dim][copy]];
    Owner       both    = owners[owner[dim][original]];
    if (of_copy.second != both.second || of_copy.first.empty() || both.first.empty() ||
        std::find(both.first.begin(), both.first.end(), of_copy.first[0]) != both.first.end())
      return false;
    both.first.push_back(of_copy.first[0]);
    owner[dim][original] = place(both);
    return true;
  }

  void GmshElements::merge_copies(const unsigned int dim)
  {
    auto                          &elements = mesh.elements[dim];
    std::vector<std::array<Id, 8>> nodes;
    std::vector<std::size_t>       order(elements.size());
    std::vector<bool>              is_copy(elements.size(), false);
    nodes.reserve(elements.size());
    for (const auto &element : elements)
      {
        nodes.push_back(element.nodes);
        std::sort(nodes.back().begin(), nodes.back().end());
      }
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](const auto a, const auto b) { return nodes[a] < nodes[b]; });
    for (std::size_t first = 0, k = 1; k < order.size(); ++k)
      if (nodes[order[k]] != nodes[order[first]])
        first = k;
      else
        is_copy[order[k]] = take_over(dim, order[k], order[first]);
    std::size_t to = 0;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (!is_copy[k])
        {
          elements[to]     = elements[k];
          owner[dim][to++] = owner[dim][k];
        }
    elements.resize(to);
    owner[dim].resize(to);
  }

  template <class Elements>
  void GmshElements::group_elements(const unsigned int dim, const Elements &elements,
                                    const std::vector<std::uint32_t> &owned_by)
  {
    std::vector<std::pair<Id, Id>> in_none; ///< elementary tag, id
    for (std::size_t k = 0; k < owned_by.size(); ++k)
      {
        const auto &[groups, elementary] = owners[owned_by[k]];
        const Id id                      = elements[k].id;
        for (const Id number : groups)
          group(dim, number).elements[dim].push_back(id);
        if (groups.empty() && elementary > 0 && elementary <= ImportedMesh::largest_number)
          in_none.emplace_back(elementary, id);
      }
    std::erase_if(in_none, [&](const auto &each) { return group.has(dim, each.first); });
    for (const auto &[elementary, id] : in_none)
      group(dim, elementary).elements[dim].push_back(id);
  }

  void GmshElements::group_elements(const unsigned int dim)
  {
    group_elements(dim, mesh.elements[dim], owner[dim]);
    group_elements(dim, mesh.elements_not_offered[dim], owner_not_offered[dim]);
  }

  void GmshElements::check_partitions(const std::size_t n_partitions) const
  {
    const auto &own = partitions[mesh.elements[3].empty() ? 2 : 3];
    if (!own.empty() && own.size() < n_partitions)
      lines.refuse("the file ends with the elements of " + std::to_string(own.size()) + " of " +
                     std::to_string(n_partitions) + " partitions",
                   "Save the mesh in one file (Gmsh: Mesh.PartitionSplitMeshFiles = 0), or without partitions.");
  }

  void GmshElements::finish(const std::size_t n_partitions)
  {
    check_partitions(is_format_2 ? static_cast<std::size_t>(largest_partition) : n_partitions);
    for (unsigned int dim = 1; dim < 4; ++dim)
      {
        if (is_format_2)
          merge_copies(dim);
        group_elements(dim);
      }
  }
} // namespace birdstrike
