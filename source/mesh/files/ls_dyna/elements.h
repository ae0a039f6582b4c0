#pragma once

#include "mesh/files/ls_dyna/groups.h"

namespace birdstrike
{
  /// The *ELEMENT_... keywords of an LS-DYNA file. Shells and bricks of other shapes, particles, springs and masses are
  /// kept with what is to be said of them: they may belong to parts that are not the blade.
  class LsDynaElements
  {
  public:
    using Id = ImportedMesh::Id;

    LsDynaElements(ImportedMesh &mesh, LsDynaCards &cards, LsDynaGroups &groups)
      : mesh(mesh), cards(cards), groups(groups)
    {
    }

    void begin(); ///< throws InputError for elements whose cards are not known
    void read_card();

  private:
    void add(Id element, Id of_part, std::size_t first, std::size_t n_nodes);
    void add_not_offered(unsigned int dim, Id element, Id of_part, const std::string &what, const std::string &remedy);
    void add_shape(unsigned int dim, Id element, Id of_part, const std::string &shape);
    void read_beam();
    void read_shell();
    void read_thickness(ImportedMesh::Element *shell);
    void read_offset();
    void read_solid();
    void read_other();
    void read_mass();
    void read_mass_of_group();
    bool begin_shell();
    bool begin_beam();
    bool begin_other();

    ImportedMesh &mesh;
    LsDynaCards  &cards;
    LsDynaGroups &groups;

    // the present keyword
    void (LsDynaElements::*read_one)() = nullptr;
    std::size_t n_extra                = 0; ///< cards of an element behind those that are read
    const char *mass_group             = "";
    bool        has_thickness = false, has_offset = false;

    // the present element
    std::size_t n_cards = 0; ///< that have been read of it
    Id          element = 0, part = 0;
    bool        is_added = false, has_mid_nodes = false;
  };
} // namespace birdstrike
