#pragma once

#include "structure/elements/elements.h"
#include <birdstrike/mesh/density_law.h>
#include <birdstrike/mesh/named_ids.h>
#include <birdstrike/mesh/thickness_law.h>
#include <birdstrike/structure/parameters.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace birdstrike
{
  /// The sections of a blade's elements, by the material ids of their cells: the blade's own, and section k where it
  /// has ids.
  struct SectionTable
  {
    /// `material_ids` of the cells, and names for them; of a row `blades` of the cells: each blade then has sections of
    /// its own, one blade's after the other's. Throws InputError for an id that is named twice or that no cell has.
    SectionTable(const BladeParameters &parameters, const std::vector<unsigned int> &material_ids,
                 const NamedIds &names, const std::vector<std::uint32_t> &blades = {},
                 const std::vector<std::int64_t> &labels = {});

    /// Elements of a section for which `is_other` holds (by their places) become another with the same number and
    /// entries, whose place it returns; none: no element is, or all are. Not of a row.
    std::optional<std::size_t> split(std::size_t place, const std::vector<bool> &is_other);

    DensityLaw   density_law() const;
    ThicknessLaw thickness_law() const; ///< of shells

    std::vector<std::size_t>              number;     ///< of sections with elements: 0 is the blade's own; may repeat
    std::vector<BladeParameters>          all;        ///< of these, with the entries of each in their places
    std::vector<std::uint32_t>            of_element; ///< which of these
    std::vector<bool>                     is_rigid;   ///< likewise; empty: none
    std::size_t                           n_of_blade; ///< sections of each blade
    std::map<unsigned int, std::uint32_t> of_id;      ///< which, of ids that sections name
    NamedIds                              names;      ///< of material ids
    std::vector<unsigned int>             ids;        ///< of the cells, sorted
    std::vector<std::int64_t>             labels;     ///< of elements, by which users know them; empty: their places
  };

  /// Sections as elements take them; `make`: one of these from the parameters with its entries.
  template <class Section, class Make>
  Sections<Section> make_sections(const SectionTable &table, const Make &make)
  {
    std::vector<Section> all;
    for (const BladeParameters &of_section : table.all)
      all.push_back(make(of_section));
    return {std::move(all), table.of_element, table.is_rigid, table.labels};
  }
} // namespace birdstrike
