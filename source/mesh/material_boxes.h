#pragma once

#include <birdstrike/core/errors.h>
#include <birdstrike/core/number.h>
#include <birdstrike/core/text_lists.h>

#include <array>
#include <string>
#include <vector>

namespace birdstrike
{
  /// Gives the cells whose centre lies in a box the material id of that box, of a list "xmin ymin zmin xmax ymax zmax:
  /// id; ..." (m); later boxes win. `as_first(cell, x)`: where x lies in the first blade of a row. Throws InputError
  /// for a box without cells (of a half: on neither side), and on a half if a cell's mirror image about y = 0 would
  /// have another id.
  template <class Triangulation, class AsFirst>
  void set_material_ids(const std::string &boxes, const bool is_halved, Triangulation &triangulation,
                        const AsFirst &as_first)
  {
    const std::string entry = "Mesh/Material boxes";
    struct Box
    {
      std::string         text;
      std::vector<double> bounds;
      unsigned int        id;
      bool                is_used;
    };
    std::vector<Box> list;
    for (const auto &[where, id] : parse_pairs(boxes, entry))
      {
        const auto ids = parse_ids(id, entry);
        if (ids.size() != 1)
          throw InputError("Blade/" + entry + ": the box '" + where + "' has the ids '" + id +
                           "'.\nAllowed: one material id a box.");
        list.push_back({where, parse_numbers(where, 6, entry), ids[0], false});
      }
    const auto id_at = [&list](const std::array<double, 3> &x, unsigned int id) {
      for (Box &box : list)
        {
          bool is_inside = true;
          for (unsigned int d = 0; d < 3; ++d)
            is_inside = is_inside && box.bounds[d] <= x[d] && x[d] <= box.bounds[3 + d];
          box.is_used = box.is_used || is_inside;
          id          = is_inside ? box.id : id;
        }
      return id;
    };
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const auto         x   = cell->center();
        const Point3       c   = as_first(cell->active_cell_index(), Point3(x[0], x[1], x[2]));
        const unsigned int own = cell->material_id(), id = id_at({c[0], c[1], c[2]}, own);
        if (is_halved && id_at({c[0], -c[1], c[2]}, own) != id)
          throw InputError("Blade/" + entry +
                           " is not symmetric about the plane y = 0.\nGive each box its mirror "
                           "image, or set Case/Symmetry plane to none.");
        cell->set_material_id(id);
      }
    for (const Box &box : list)
      if (!box.is_used)
        throw InputError("Blade/" + entry + ": no cell has its centre in the box '" + box.text +
                         "'.\nGive xmin ymin zmin xmax ymax zmax, in m.");
  }
} // namespace birdstrike
