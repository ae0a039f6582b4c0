#pragma once

#include "mesh/files/abaqus/scopes.h"
#include "mesh/files/imported_mesh.h"

namespace birdstrike
{
  /// Sets of an Abaqus file, by their kind, where they are defined, and their names whatever the case of the letters.
  class AbaqusSets
  {
  public:
    using Id = ImportedMesh::Id;
    enum class Kind
    {
      nodes,
      elements,
      surface
    };

    AbaqusSets(ImportedMesh &mesh, FileLines &lines, const AbaqusScopes &scopes)
      : mesh(mesh), lines(lines), scopes(scopes)
    {
    }

    std::size_t group_of(Kind kind, std::size_t scope, const std::string &name); ///< begins it where it is new
    std::optional<std::size_t> find(Kind kind, std::size_t scope, const std::string &name) const;

    bool add(const ImportedMesh::Element &element, unsigned int dim); ///< to the mesh; false if the id is there
    void add_not_offered(const ImportedMesh::NotOffered &element);
    void add_element(std::size_t group, Id id); ///< once it is there
    void add_elements(std::size_t group, std::size_t of);
    void add_nodes(std::size_t group, std::size_t of);
    void add_nodes_of_elements(std::size_t group, std::size_t of);

    /// Sides of the elements of a set, or of one element: S1..S6 of bricks, E1..E4 of shells, S1..S4 of plane elements;
    /// none: all of them. SPOS and SNEG, the faces of a shell, are no side of it. Done by `finish`.
    void add_sides(std::size_t group, std::size_t scope, const std::string &elements, const std::string &label);

    /// At the end of the file: elements that sets have named before they were there, sides, longer names.
    void finish();

  private:
    struct Name
    {
      Kind        kind;
      std::size_t scope;
      std::string name; ///< in upper case

      auto operator<=>(const Name &) const = default;
    };
    struct Place
    {
      unsigned int  dim; ///< 0: it is not offered
      std::uint32_t place;
    };
    struct Face
    {
      std::size_t group, scope;
      std::string elements, label;
    };

    const ImportedMesh::Element &element(Id id) const;
    void                         add_nodes_of(Id id, ImportedMesh::Group &group) const;
    void                         add_awaited();
    std::vector<Id>              elements_of(const Face &face) const;
    void                         add_sides(const Face &face);
    void                         add_longer_names();

    ImportedMesh                          &mesh;
    FileLines                             &lines; ///< to refuse sets without bounds
    const AbaqusScopes                    &scopes;
    std::map<Name, std::size_t>            groups;
    std::unordered_map<Id, Place>          places;                     ///< of elements
    std::map<std::size_t, std::vector<Id>> awaited, awaited_for_nodes; ///< by group
    std::vector<Face>                      faces;
  };
} // namespace birdstrike
