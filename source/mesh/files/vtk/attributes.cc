#include "mesh/files/vtk/attributes.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace birdstrike
{
  namespace
  {
    constexpr std::array<const char *, 3> numbering{{"MaterialID", "gmsh:physical", "CellEntityIds"}};

    bool is_numbering(const std::string &name)
    {
      return std::find(numbering.begin(), numbering.end(), name) != numbering.end();
    }
  } // namespace

  void VtkAttributes::begin(const bool of_cells, const std::size_t n_expected)
  {
    is_of_cells = of_cells;
    n_things    = words.must_count();
    if (n_things != n_expected)
      words.refuse(std::string(of_cells ? "CELL_DATA" : "POINT_DATA") + " is of " + std::to_string(n_things) +
                     ", but there are " + std::to_string(n_expected) + (of_cells ? " cells" : " points") + " above",
                   "Save it again as VTK legacy, ASCII.");
  }

  bool VtkAttributes::take(const std::string &keyword)
  {
    static const std::map<std::string, std::size_t> components{{"VECTORS", 3},   {"NORMALS", 3},    {"TENSORS", 9},
                                                               {"TENSORS6", 6},  {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1},
                                                               {"EDGE_FLAGS", 1}};
    const auto                                      found = components.find(keyword);
    if (found != components.end())
      take_named(found->second);
    else if (keyword == "SCALARS")
      take_scalars();
    else if (keyword == "FIELD")
      take_field();
    else if (keyword == "TEXTURE_COORDINATES")
      {
        words.must_word(); // name
        const std::size_t dim = words.must_count();
        take_array("", dim, n_things, words.must_word());
      }
    else if (keyword == "COLOR_SCALARS")
      {
        words.must_word(); // name
        words.skip_words(words.must_count() * n_things);
      }
    else if (keyword == "LOOKUP_TABLE")
      {
        words.must_word(); // name
        words.skip_words(4 * words.must_count());
      }
    else if (keyword == "METADATA")
      words.skip_metadata();
    else
      return false;
    return true;
  }

  /// name, type
  void VtkAttributes::take_named(const std::size_t n_components)
  {
    words.must_word();
    take_array("", n_components, n_things, words.must_word());
  }

  /// name, type, number of components (1 where there is none); LOOKUP_TABLE with a name, which some programs leave out.
  void VtkAttributes::take_scalars()
  {
    const std::string name(words.must_word());
    const std::string type(words.rest_of_line().substr(0, words.rest_of_line().find(' ')));
    if (type.empty())
      words.refuse("the SCALARS '" + name + "' have no type", "Save it again as VTK legacy, ASCII.");
    words.must_word();
    const std::size_t n_components = words.rest_of_line().empty() ? 1 : words.must_count();
    if (upper(words.peek()) == "LOOKUP_TABLE")
      words.skip_words(2);
    take_array(name, n_components, n_things, type);
  }

  /// name, number of arrays; of each: name, numbers of components and tuples, type.
  void VtkAttributes::take_field()
  {
    words.must_word();
    for (std::size_t n = words.must_count(); n > 0; --n)
      {
        while (words.peek() == "METADATA") // of the array before
          words.skip_metadata();
        const std::string name(words.must_word());
        const std::size_t n_components = words.must_count(), n_tuples = words.must_count();
        take_array(name, n_components, n_tuples, words.must_word());
      }
  }

  /// Strings have a line each.
  void VtkAttributes::take_array(const std::string &name, const std::size_t n_components, const std::size_t n_tuples,
                                 const std::string_view type)
  {
    static const std::array<const char *, 3> lines_each{{"STRING", "UTF8_STRING", "VARIANT"}};
    const bool is_text = std::find(lines_each.begin(), lines_each.end(), upper(type)) != lines_each.end();
    if (!is_of_cells || !is_numbering(name))
      return is_text ? words.skip_lines(n_components * n_tuples) : words.skip_words(n_components * n_tuples);
    if (is_text || n_components != 1 || n_tuples != n_things)
      words.refuse("the array '" + name + "' has not one whole number for each of " + std::to_string(n_things) +
                     " cells",
                   "It numbers the groups of cells. Save it as whole numbers, or under another name.");
    wanted[name] = words.must_ids(n_tuples);
  }

  std::vector<VtkAttributes::Id> VtkAttributes::numbers() const
  {
    for (const char *name : numbering)
      if (const auto found = wanted.find(name); found != wanted.end() && !found->second.empty())
        {
          std::vector<Id> all = found->second;
          if (found->first != "MaterialID") // of Gmsh: a group that runs against its surface
            std::transform(all.begin(), all.end(), all.begin(), [](const Id number) { return std::abs(number); });
          return all;
        }
    return {};
  }
} // namespace birdstrike
