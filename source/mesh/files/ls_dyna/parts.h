#pragma once

#include "mesh/files/ls_dyna/groups.h"

namespace birdstrike
{
  /// Titles and ids of the *PARTs of an LS-DYNA file, and what *PART_MOVE moves.
  class LsDynaParts
  {
  public:
    LsDynaParts(ImportedMesh &mesh, LsDynaCards &cards, LsDynaGroups &groups) : mesh(mesh), cards(cards), groups(groups)
    {
    }

    bool begin(); ///< false: the present keyword is no such
    void read_card();

  private:
    std::size_t n_cards_of_part() const; ///< with heading, as far as it is known

    ImportedMesh &mesh;
    LsDynaCards  &cards;
    LsDynaGroups &groups;

    bool        is_move = false, has_one = false;
    std::size_t n_cards = 0, n_of_inertia = 0;
    std::string title;
  };
} // namespace birdstrike
