#pragma once

#include "mesh/files/gmsh/entities.h"
#include "mesh/files/numbered_groups.h"

namespace birdstrike
{
  /// Elements of a Gmsh file, and the groups they lie in.
  ///
  /// A group is a physical one. An element that lies in none has the number of its entity in the model (elementary
  /// tag), unless a physical group of its dimension has this number. Format 2 writes an element once for each of its
  /// groups, turned round where the group's number is negative: those of one entity with the same nodes are one.
  class GmshElements
  {
  public:
    using Id     = ImportedMesh::Id;
    using Fields = GmshLines::Fields;

    struct Type
    {
      Id           number;
      unsigned int dim, n_nodes;
      const char  *shape  = nullptr; ///< of those that are not offered: "a triangle"
      const char  *remedy = nullptr;
    };

    GmshElements(ImportedMesh &mesh, NumberedGroups &group, GmshLines &lines) : mesh(mesh), group(group), lines(lines)
    {
    }

    const Type &type_of(std::string_view field) const; ///< throws InputError for what is of a higher order

    /// Format 2: id, type, number of tags, tags, nodes. Tags: group, entity, number of parts, parts (ghosts negative).
    void add_of_format_2(const Fields &fields);

    /// Formats 4: id, nodes; the owner is what `owner_of` says of the block's entity.
    void          add_of_entity(const Type &type, const Fields &fields, std::uint32_t owner);
    std::uint32_t owner_of(unsigned int dim, const GmshEntities::Entity &entity);

    /// Puts elements into their groups. Throws InputError where the elements of some partition are not in the file.
    void finish(std::size_t n_partitions);

  private:
    using Owner = std::pair<std::vector<Id>, Id>; ///< groups and elementary tag

    ImportedMesh                             &mesh;
    NumberedGroups                           &group;
    GmshLines                                &lines;
    std::vector<Owner>                        owners;
    std::map<Owner, std::uint32_t>            place_of;
    std::array<std::vector<std::uint32_t>, 4> owner;                 ///< of each element, by dimension
    std::array<std::vector<std::uint32_t>, 4> owner_not_offered;     ///< of those that are not offered
    std::array<std::set<Id>, 4>               partitions;            ///< that have elements, by dimension
    Id                                        largest_partition = 0; ///< that format 2 mentions
    bool                                      is_format_2       = false;

    std::uint32_t place(const Owner &one);
    void          add(const Type &type, const Fields &fields, std::size_t first, std::uint32_t owned_by);
    void          note_partitions(unsigned int dim, const Fields &fields, Id n_tags);
    void          merge_copies(unsigned int dim);
    bool          take_over(unsigned int dim, std::size_t copy, std::size_t original);
    void          add_not_offered(const Type &type, Id id, std::uint32_t owned_by);
    void          group_elements(unsigned int dim);
    template <class Elements>
    void group_elements(unsigned int dim, const Elements &elements, const std::vector<std::uint32_t> &owned_by);
    void check_partitions(std::size_t n_partitions) const;
  };
} // namespace birdstrike
