#include "mesh/files/abaqus/parts.h"

namespace birdstrike
{
  namespace
  {
    const char *const remedy =
      "Save the blade alone, one part and one instance of it, or name the one that is the blade in Blade/Mesh/Parts.";
  } // namespace

  bool AbaqusParts::begin(const AbaqusKeyword &k)
  {
    if (k.name == "PART")
      {
        scope = add_part(k.value("NAME"));
        if (scopes.number_of_lists() > 1)
          complain(scope, "a second *PART begins here");
      }
    else if (k.name == "ASSEMBLY")
      scope = assembly = scopes.add(k.has("NAME") ? k.value("NAME") : "Assembly", false);
    else if (k.name == "INSTANCE")
      begin_instance(k);
    else if (k.name == "END INSTANCE")
      scope = assembly;
    else if (k.name == "END PART" || k.name == "END ASSEMBLY")
      scope = 0;
    else
      return false;
    return true;
  }

  std::size_t AbaqusParts::add_part(const std::string &name)
  {
    const std::size_t added = scopes.add(name, true);
    groups[added]           = mesh.groups.size();
    auto &group             = mesh.groups.emplace_back();
    group.name              = name;
    group.is_part_only      = true;
    mesh.has_lists          = scopes.number_of_lists() > 1;
    return added;
  }

  /// Refused where the whole file is wanted: an element that only the file has.
  void AbaqusParts::complain(const std::size_t of, const std::string &what)
  {
    const Id id = scopes[of].first_id + ImportedMesh::ids_of_a_list - 1;
    mesh.elements_not_offered[0].push_back(mesh.not_offered(id, lines.line_number(), what, remedy));
  }

  void AbaqusParts::begin_instance(const AbaqusKeyword &k)
  {
    const auto part = scopes.find(k.value("PART"));
    if (part && scopes[*part].has_mesh && !scopes[*part].has_instance)
      {
        scopes.add_instance(*part, k.value("NAME"));
        scope = *part;
        return;
      }
    scope = add_part(k.value("NAME"));
    scopes.add_instance(scope, k.value("NAME"));
    complain(scope, part ? "a second *INSTANCE begins here" : "an *INSTANCE of a part begins here that is not there");
    mesh.groups[groups.at(scope)].not_read =
      "Line " + std::to_string(lines.line_number()) + ": " +
      (part ? "it is another *INSTANCE of a part; the first is read." : "its part is not in the file.") +
      "\nGive the first instance of its part, or save this one alone.";
  }

  std::size_t AbaqusParts::instance(const std::string &name) const
  {
    const auto found = scopes.find(name);
    if (!found)
      lines.refuse("there is no *INSTANCE '" + name + "' above", "Define it further up.");
    return *found;
  }

  void AbaqusParts::move_present()
  {
    if (const auto found = groups.find(scope); found != groups.end())
      mesh.groups[found->second].not_offered =
        mesh.not_offered(0, lines.line_number(), "the *INSTANCE is moved or turned",
                         "Save the blade where it stands (a flat input file).");
  }

  void AbaqusParts::add_element(const Id id, const unsigned int dim)
  {
    if (const auto found = groups.find(scope); found != groups.end())
      mesh.groups[found->second].elements[dim].push_back(id);
  }

  void AbaqusParts::finish()
  {
    for (const auto &[of, group] : groups)
      {
        auto &names = mesh.groups[group].other_names;
        names       = scopes[of].names;
        names.push_back("part." + mesh.groups[group].name);
      }
  }
} // namespace birdstrike
