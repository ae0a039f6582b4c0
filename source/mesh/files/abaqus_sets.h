#pragma once

#include "mesh/files/file_lines.h"
#include "mesh/files/imported_mesh.h"

#include <map>

namespace birdstrike
{
  /// Sets of an Abaqus file, by their names whatever the case of the letters. A node set, an element set and a surface
  /// of the same name are one group.
  class AbaqusSets
  {
  public:
    using Id = ImportedMesh::Id;

    AbaqusSets(ImportedMesh &mesh, FileLines &lines) : mesh(mesh), lines(lines)
    {
    }

    std::size_t                group_of(const std::string &name); ///< begins it where it is new
    std::optional<std::size_t> find(const std::string &name) const;

    bool add(const ImportedMesh::Element &element, unsigned int dim); ///< to the mesh; false if the id is there
    void add_element(std::size_t group, Id id);                       ///< once it is there
    void add_elements(std::size_t group, std::size_t of);
    void add_nodes(std::size_t group, std::size_t of);
    void add_nodes_of_elements(std::size_t group, std::size_t of);
    void add_awaited(); ///< elements that sets have named before they were there; at the end of the file

    /// Sides of the elements of a set, or of one element: S1..S6 of bricks, E1..E4 of shells, S1..S4 of plane elements;
    /// none: all of them. SPOS and SNEG, the faces of a shell, are no side of it.
    void add_sides(std::size_t group, const std::string &elements, const std::string &label);

  private:
    const ImportedMesh::Element &element(Id id) const;
    void                         add_nodes_of(Id id, ImportedMesh::Group &group) const;

    struct Place
    {
      unsigned int  dim;
      std::uint32_t place;
    };

    ImportedMesh                           &mesh;
    FileLines                              &lines;                      ///< to refuse sets without bounds
    std::unordered_map<std::string, size_t> groups;                     ///< by name in upper case
    std::unordered_map<Id, Place>           places;                     ///< of elements
    std::map<std::size_t, std::vector<Id>>  awaited, awaited_for_nodes; ///< by group
  };
} // namespace birdstrike
