#include "mesh/files/abaqus/elements.h"

#include <algorithm>
#include <cctype>

namespace birdstrike
{
  const AbaqusElements::Type *AbaqusElements::type_of(const std::string &name)
  {
    static constexpr Type types[] = {{"S4", 2, 4},     {"M3D4", 2, 4}, {"CPS4", 2, 4}, {"CPE4", 2, 4}, {"R3D4", 2, 4},
                                     {"SFM3D4", 2, 4}, {"C3D8", 3, 8}, {"SC8", 3, 8},  {"T2D2", 1, 2}, {"T3D2", 1, 2},
                                     {"B21", 1, 2},    {"B23", 1, 2},  {"B31", 1, 2},  {"B33", 1, 2},  {"R2D2", 1, 2},
                                     {"RB2D2", 1, 2},  {"RB3D2", 1, 2}};
    const auto            found   = std::find_if(std::begin(types), std::end(types), [&name](const Type &type) {
      const std::string beginning = type.name;
      return name.starts_with(beginning) &&
             (name.size() == beginning.size() || !std::isdigit(static_cast<unsigned char>(name[beginning.size()])));
    });
    return found != std::end(types) ? found : nullptr;
  }

  void AbaqusElements::begin(const AbaqusKeyword &k)
  {
    name         = upper(k.value("TYPE"));
    type         = scopes[parts.present()].has_mesh ? type_of(name) : nullptr;
    group        = {};
    keyword_line = lines.line_number();
    is_continued = false;
    if (k.has("ELSET"))
      group = sets.group_of(AbaqusSets::Kind::elements, parts.present(), k.value("ELSET"));
  }

  AbaqusElements::Id AbaqusElements::id_of(const std::string_view field, const std::size_t scope) const
  {
    const Id id = lines.integer(field);
    if (id < 0 || id >= ImportedMesh::ids_of_a_list - 1)
      lines.refuse("the number " + std::string(trim(field)) + " cannot be an id", "Allowed: from 1 to 999999999.");
    return scopes[scope].first_id + id;
  }

  void AbaqusElements::add_to_sets(const Id id, const unsigned int dim)
  {
    parts.add_element(id, dim);
    if (group)
      sets.add_element(*group, id);
  }

  void AbaqusElements::read_line(const Fields &fields)
  {
    if (type == nullptr)
      return read_not_offered(fields);
    for (const auto field : fields)
      pending.push_back(id_of(field, parts.present()));
    if (pending.size() > type->n_nodes)
      finish();
  }

  void AbaqusElements::finish()
  {
    if (pending.empty())
      return;
    const Id id = pending[0] - scopes[parts.present()].first_id;
    if (pending.size() < type->n_nodes + 1 || (type->dim > 1 && pending.size() > type->n_nodes + 1))
      lines.refuse("element " + std::to_string(id) + " of type " + type->name + " has " +
                     std::to_string(pending.size() - 1) + " nodes",
                   "It must have " + std::to_string(type->n_nodes) + ".");
    ImportedMesh::Element element{pending[0]};
    std::copy_n(pending.begin() + 1, type->n_nodes, element.nodes.begin());
    if (!sets.add(element, type->dim))
      lines.refuse("the element " + std::to_string(id) + " is given twice", "Give each id once.");
    add_to_sets(element.id, type->dim);
    pending.clear();
  }

  /// Its id, and the node of a mass; the rest goes on to the next line after a comma.
  void AbaqusElements::read_not_offered(const Fields &fields)
  {
    const bool is_first = !is_continued;
    is_continued        = lines.text().ends_with(',');
    const auto line     = keyword_line;
    if (!is_first)
      return;
    if (is_mass() && fields.size() > 1)
      if (const auto [scope, node] = scopes.split(fields[1], parts.present()); scopes[scope].has_mesh)
        mesh.nodes_not_offered.push_back(mesh.not_offered(
          id_of(node, scope), line, "an element of type " + name + " gives a mass to node # of the blade",
          "Remove the mass, or make elements of it: masses of nodes are not offered."));
    if (!scopes[parts.present()].has_mesh)
      return;
    const Id id = id_of(fields[0], parts.present());
    sets.add_not_offered(mesh.not_offered(
      id, line, "elements of the type " + name + " are not offered",
      "Allowed: shells S4, S4R, S4RS, M3D4, R3D4, CPS4; bricks C3D8, C3D8R, C3D8I, SC8R; lines T3D2, B31. Mesh with "
      "quadrilaterals or hexahedra of the first order, or name the parts that are the blade in Blade/Mesh/Parts."));
    add_to_sets(id, 0);
  }
} // namespace birdstrike
