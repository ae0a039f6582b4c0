#include "mesh/files/check_elements.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    using Id      = ImportedMesh::Id;
    using Element = ImportedMesh::Element;

    /// Nodes of something, sorted, with the element that has it.
    template <std::size_t n>
    using Owned = std::pair<std::array<Id, n>, Id>;

    /// Sorts; then the first of m in a row with the same nodes, or null.
    template <std::size_t n>
    const Owned<n> *first_of(const std::size_t m, std::vector<Owned<n>> &all)
    {
      std::sort(all.begin(), all.end());
      for (std::size_t k = m - 1; k < all.size(); ++k)
        if (all[k].first == all[k + 1 - m].first)
          return &all[k + 1 - m];
      return nullptr;
    }

    template <int dim>
    void check_corners(const std::vector<Element> &elements, const std::string &path)
    {
      constexpr std::size_t         n_corners = 1u << dim;
      std::vector<Owned<n_corners>> of_elements;
      of_elements.reserve(elements.size());
      for (const Element &element : elements)
        {
          auto &nodes = of_elements.emplace_back(Owned<n_corners>{{}, element.id}).first;
          std::copy_n(element.nodes.begin(), n_corners, nodes.begin());
          std::sort(nodes.begin(), nodes.end());
          if (const auto same = std::adjacent_find(nodes.begin(), nodes.end()); same != nodes.end())
            refuse_mesh_file(
              path,
              "element " + std::to_string(element.id) + " has the node " + std::to_string(*same) + " more than once",
              dim == 2 ? "Collapsed quadrilaterals (triangles) are not offered; re-mesh there."
                       : "Collapsed hexahedra (wedges, pyramids, tetrahedra) are not offered; re-mesh there.");
        }
      if (const auto *two = first_of(2, of_elements))
        refuse_mesh_file(path,
                         "the elements " + std::to_string(two[0].second) + " and " + std::to_string(two[1].second) +
                           " have the same nodes",
                         "Remove one of them.");
    }

    template <int dim>
    void check_sides(const std::vector<Element> &elements, const std::string &path)
    {
      constexpr std::size_t n_corners = (1u << dim) / 2;

      std::vector<Owned<n_corners>> of_sides;
      of_sides.reserve(2 * dim * elements.size());
      for (const Element &element : elements)
        for (unsigned int number = 0; number < 2 * dim; ++number)
          {
            auto &nodes = of_sides.emplace_back(Owned<n_corners>{{}, element.id}).first;
            for (std::size_t k = 0; k < n_corners; ++k)
              nodes[k] = element.nodes[dim == 2 ? (number + k) % 4 : ImportedMesh::brick_sides[number][k]];
            std::sort(nodes.begin(), nodes.end());
          }
      if (const auto *three = first_of(3, of_sides))
        refuse_mesh_file(path,
                         "the elements " + std::to_string(three[0].second) + ", " + std::to_string(three[1].second) +
                           " and " + std::to_string(three[2].second) + " share " + (dim == 2 ? "an edge" : "a face") +
                           ", between the nodes " + std::to_string(three->first.front()) + " and " +
                           std::to_string(three->first.back()),
                         dim == 2 ? "A shell surface must not branch: remove elements that do not belong to the blade."
                                  : "A face has at most one brick on either side: remove bricks that lie in another.");
    }
  } // namespace

  template <int dim>
  void check_elements(const std::vector<Element> &elements, const std::string &path)
  {
    check_corners<dim>(elements, path);
    check_sides<dim>(elements, path);
  }

  template void check_elements<2>(const std::vector<Element> &, const std::string &);
  template void check_elements<3>(const std::vector<Element> &, const std::string &);
} // namespace birdstrike
