#pragma once

#include "mesh/files/file_lines.h"
#include "mesh/files/imported_mesh.h"

namespace birdstrike
{
  /// Where names and ids of an Abaqus file hold: the file itself (the first), each part with its instance, the
  /// assembly.
  class AbaqusScopes
  {
  public:
    using Id = ImportedMesh::Id;

    struct Scope
    {
      std::vector<std::string> names;               ///< of the instance, then of the part
      Id                       first_id     = 0;    ///< is added to the ids of the file
      bool                     has_mesh     = true; ///< not of the assembly
      bool                     has_instance = false;
    };

    std::size_t add(const std::string &name, bool has_mesh)
    {
      scopes.push_back({{name}, has_mesh ? ImportedMesh::ids_of_a_list * n_lists++ : 0, has_mesh});
      return scopes.size() - 1;
    }
    void add_instance(const std::size_t scope, const std::string &name)
    {
      scopes[scope].names.insert(scopes[scope].names.begin(), name);
      scopes[scope].has_instance = true;
    }
    std::optional<std::size_t> find(const std::string &name) const
    {
      for (std::size_t k = scopes.size(); k-- > 1;)
        for (const std::string &other : scopes[k].names)
          if (upper(other) == upper(name))
            return k;
      return {};
    }
    const Scope &operator[](const std::size_t scope) const
    {
      return scopes[scope];
    }
    Id number_of_lists() const
    {
      return n_lists;
    }

    /// "Blade-1.27" or "Blade-1.root": whose, and the rest. In a file without parts what stands before a dot means
    /// nothing.
    std::pair<std::size_t, std::string_view> split(const std::string_view member, const std::size_t present) const
    {
      const std::size_t dot = member.rfind('.');
      if (dot == member.npos)
        return {present, member};
      if (const auto found = find(std::string(member.substr(0, dot))))
        return {*found, member.substr(dot + 1)};
      return {present, scopes.size() == 1 ? member.substr(dot + 1) : member};
    }

  private:
    std::vector<Scope> scopes{{}};
    Id                 n_lists = 0;
  };
} // namespace birdstrike
