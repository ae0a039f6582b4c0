#pragma once

#include "mesh/files/vtk/words.h"

#include <map>

namespace birdstrike
{
  /// Attributes of points and cells in VTK's legacy format ("VTK User's Guide", file formats; what VTK 9 writes
  /// besides: METADATA, strings, TENSORS6, EDGE_FLAGS): all kinds are passed over but for the arrays of cells that
  /// number groups, of which each value must be a whole number.
  class VtkAttributes
  {
  public:
    using Id = VtkWords::Id;

    explicit VtkAttributes(VtkWords &words) : words(words)
    {
    }

    /// CELL_DATA or POINT_DATA with its number of things; `n_expected` of these have come before.
    void begin(bool is_of_cells, std::size_t n_expected);

    /// Takes the attribute that begins with this keyword (capitals); false: it begins none.
    bool take(const std::string &keyword);

    /// Numbers of groups, a cell each: of MaterialID, as deal.II writes it, else gmsh:physical, else CellEntityIds, as
    /// Gmsh does with the sign of the group; empty: no array numbers groups.
    std::vector<Id> numbers() const;

  private:
    VtkWords                              &words;
    bool                                   is_of_cells = false;
    std::size_t                            n_things    = 0;
    std::map<std::string, std::vector<Id>> wanted;

    void take_scalars();
    void take_field();
    void take_array(const std::string &name, std::size_t n_components, std::size_t n_tuples, std::string_view type);
    void take_named(std::size_t n_components);
  };
} // namespace birdstrike
