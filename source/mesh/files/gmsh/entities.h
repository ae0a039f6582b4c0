#pragma once

#include "mesh/files/gmsh/lines.h"
#include "mesh/files/imported_mesh.h"

#include <map>
#include <set>

namespace birdstrike
{
  /// Points, curves, surfaces and volumes of a Gmsh model, formats 4.0 and 4.1: what their elements belong to.
  class GmshEntities
  {
  public:
    using Id = ImportedMesh::Id;

    struct Entity
    {
      std::vector<Id> groups{};      ///< physical
      Id              elementary{0}; ///< tag in the model; 0: none, as of what a partitioning adds
      std::set<Id>    partitions{};  ///< empty: the mesh is in one piece
    };

    explicit GmshEntities(GmshLines &lines) : lines(lines)
    {
    }

    /// $Entities: a line each. Format 4.0 gives points a box, 4.1 a place.
    void read(bool is_4_1);

    /// $PartitionedEntities: those of the parts, each with the entity it is cut from. Groups of one cut from another
    /// dimension (a curve between two parts of a surface) are its parent's and left out.
    void read_partitioned(bool is_4_1);

    /// Of one that the file does not describe: no groups.
    Entity find(unsigned int dim, Id tag) const;

    std::size_t n_partitions() const ///< 0: of a mesh in one piece
    {
      return n_parts;
    }

  private:
    GmshLines                                    &lines;
    std::map<std::pair<unsigned int, Id>, Entity> all;
    std::size_t                                   n_parts = 0;

    std::array<Id, 4> take_counts(const std::string &section);
    std::vector<Id>   groups_from(const std::vector<std::string_view> &fields, std::size_t at) const;
  };
} // namespace birdstrike
