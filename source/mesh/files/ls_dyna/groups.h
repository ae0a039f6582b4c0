#pragma once

#include "mesh/files/imported_mesh.h"
#include "mesh/files/ls_dyna/cards.h"

#include <map>

namespace birdstrike
{
  /// Groups of an LS-DYNA file by kind and id: "part_3", "node_set_7". A title is their name before these.
  class LsDynaGroups
  {
  public:
    using Id = ImportedMesh::Id;

    LsDynaGroups(ImportedMesh &mesh, const LsDynaCards &cards) : mesh(mesh), cards(cards)
    {
    }

    std::size_t                operator()(const std::string &kind, Id number); ///< begins it where it is new
    std::optional<std::size_t> find(const std::string &kind, Id number) const;
    std::vector<Id>            numbers(const std::string &kind) const; ///< ascending
    void                       give_title(std::size_t group, const std::string &title);

  private:
    ImportedMesh                                     &mesh;
    const LsDynaCards                                &cards;
    std::map<std::pair<std::string, Id>, std::size_t> places;
  };
} // namespace birdstrike
