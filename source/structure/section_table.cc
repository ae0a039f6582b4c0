#include "structure/section_table.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <memory>
#include <ranges>

namespace birdstrike
{
  SectionTable::SectionTable(const BladeParameters &parameters, const std::vector<unsigned int> &material_ids,
                             const NamedIds &names, const std::vector<std::uint32_t> &blades,
                             const std::vector<std::int64_t> &labels)
    : names(names), ids(material_ids), labels(labels)
  {
    std::ranges::sort(ids);
    for (auto &[k, of_section] : parameters.by_section())
      {
        const std::string entry = BladeParameters::section_path(k) + "Material ids";
        for (const unsigned int id :
             names.parse(k > 0 ? parameters.sections[k - 1].material_ids : "", "Blade/" + entry))
          {
            if (std::find(material_ids.begin(), material_ids.end(), id) == material_ids.end())
              throw InputError(
                "Blade/" + entry + ": no cell of the mesh has the material id " + std::to_string(id) +
                ".\nSet Blade/Mesh/Material boxes, or name an id that the file has; its names: " + names.list() + ".");
            if (!of_id.emplace(id, all.size()).second)
              throw InputError("Blade/" + entry + ": the material id " + std::to_string(id) +
                               " has been named before.\nName each id once, in one section.");
          }
        number.push_back(k);
        all.push_back(of_section);
      }
    for (const unsigned int id : material_ids)
      of_element.push_back(of_id.count(id) > 0 ? of_id.at(id) : 0);
    if (std::find(of_element.begin(), of_element.end(), 0) == of_element.end()) // every id has a section
      {
        number.erase(number.begin());
        all.erase(all.begin());
        for (std::uint32_t &place : of_element)
          --place;
        for (auto &[id, place] : of_id)
          --place;
      }
    n_of_blade = all.size();
    if (blades.empty())
      return;
    is_rigid.assign(n_of_blade, false);
    for (const bool is_rigid_there : std::views::drop(parameters.mesh.row.is_rigid(), 1))
      for (std::size_t k = 0; k < n_of_blade; ++k)
        {
          number.push_back(number[k]);
          all.push_back(all[k]);
          is_rigid.push_back(is_rigid_there);
        }
    for (std::size_t e = 0; e < of_element.size(); ++e)
      of_element[e] += n_of_blade * blades[e];
  }

  std::optional<std::size_t> SectionTable::split(const std::size_t place, const std::vector<bool> &is_other)
  {
    std::size_t n = 0, n_others = 0;
    for (std::size_t e = 0; e < of_element.size(); ++e)
      if (of_element[e] == place)
        {
          ++n;
          n_others += is_other[e];
        }
    if (n_others == 0 || n_others == n)
      return {};
    for (std::size_t e = 0; e < of_element.size(); ++e)
      if (of_element[e] == place && is_other[e])
        of_element[e] = static_cast<std::uint32_t>(all.size());
    number.push_back(number[place]);
    all.push_back(BladeParameters(all[place]));
    n_of_blade = all.size();
    return all.size() - 1;
  }

  DensityLaw SectionTable::density_law() const
  {
    std::map<unsigned int, double> some;
    for (const auto &[id, place] : of_id)
      some[id] = all[place].density();
    return DensityLaw(all.front().density(), some);
  }

  ThicknessLaw SectionTable::thickness_law() const
  {
    const std::string entry = "Blade/Thickness/By material";
    for (const auto &[key, value] : parse_pairs(all.front().thickness.by_material, entry))
      for (const unsigned int id : names.parse(key, entry))
        if (!std::ranges::binary_search(ids, id))
          throw InputError(
            entry + ": no cell of the mesh has the material id " + std::to_string(id) +
            ".\nSet Blade/Mesh/Material boxes, or name an id that the file has; its names: " + names.list() + ".");
    struct Given
    {
      std::string  entry;
      ThicknessLaw law;
    };
    std::map<unsigned int, Given> some;
    for (const auto &[id, place] : of_id)
      {
        const std::string &text = all[place].sections[number[place] - 1].thickness;
        if (text.empty())
          continue;
        Given &given = some[id];
        given.entry  = BladeParameters::section_path(number[place]) + "Thickness";
        given.law    = [formula = std::make_shared<Expression>(text, 1, given.entry)](const SurfacePlace &place) {
          return formula->value(place.position, 0.);
        };
      }
    return [some, law = make_thickness_law(all.front(), names)](const SurfacePlace &place) {
      const auto given = some.find(place.material_id);
      return given != some.end() ? thickness_at(given->second.law, place, given->second.entry) : law(place);
    };
  }
} // namespace birdstrike
