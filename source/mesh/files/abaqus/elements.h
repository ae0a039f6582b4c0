#pragma once

#include "mesh/files/abaqus/parts.h"
#include "mesh/files/abaqus/sets.h"

namespace birdstrike
{
  /// The *ELEMENT keywords of an Abaqus file. Elements of types that are not offered are kept with a complaint, for
  /// they may belong to what is not the blade.
  class AbaqusElements
  {
  public:
    using Id     = ImportedMesh::Id;
    using Fields = std::vector<std::string_view>;

    AbaqusElements(ImportedMesh &mesh, FileLines &lines, const AbaqusScopes &scopes, AbaqusSets &sets,
                   AbaqusParts &parts)
      : mesh(mesh), lines(lines), scopes(scopes), sets(sets), parts(parts)
    {
    }

    void begin(const AbaqusKeyword &keyword);
    void read_line(const Fields &fields);
    void finish(); ///< the last element
    bool is_mass() const
    {
      return type == nullptr && (name.starts_with("MASS") || name.starts_with("ROTARYI"));
    }

    /// An id as it stands in a scope. Throws InputError for what cannot be one.
    Id id_of(std::string_view field, std::size_t scope) const;

  private:
    struct Type
    {
      const char  *name; ///< its beginning: letters may follow, digits not
      unsigned int dim, n_nodes;
    };
    static const Type *type_of(const std::string &name);

    void read_not_offered(const Fields &fields);
    void add_to_sets(Id id, unsigned int dim);

    ImportedMesh       &mesh;
    FileLines          &lines;
    const AbaqusScopes &scopes;
    AbaqusSets         &sets;
    AbaqusParts        &parts;

    const Type                *type = nullptr; ///< none: not offered
    std::string                name;
    std::size_t                keyword_line = 0;
    std::optional<std::size_t> group;
    std::vector<Id>            pending;              ///< of an element that goes on in the next line
    bool                       is_continued = false; ///< of a type that is not offered
  };
} // namespace birdstrike
