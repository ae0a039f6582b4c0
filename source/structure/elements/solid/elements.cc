#include "structure/elements/solid/elements.h"
#include "structure/elements/solid/thickness.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    std::vector<std::uint8_t> find_axes(const std::vector<Point3> &nodes, const std::vector<SolidElements::Cell> &cells,
                                        const Sections<SolidSection> &sections)
    {
      const auto is_solid_shell = [](const SolidSection &s) { return s.formulation == SolidFormulation::solid_shell; };
      std::vector<std::uint8_t> axes(cells.size(), 2);
      if (std::none_of(sections.all.begin(), sections.all.end(), is_solid_shell))
        return axes;
      const auto found = solid_shell::find_thickness_axes(nodes, cells);
      for (std::size_t e = 0; e < cells.size(); ++e)
        if (is_solid_shell(sections.of(e)))
          axes[e] = found[e];
      return axes;
    }
  } // namespace

  SolidElements::SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                               const Sections<SolidSection> &sections, ThreadPool &pool)
    : SolidElements(nodes, cells, find_axes(nodes, checked(cells, nodes.size()), sections), sections, pool)
  {
  }

  SolidElements::SolidElements(const std::vector<Point3> &nodes, const std::vector<Cell> &cells,
                               const std::vector<std::uint8_t> &axes, const Sections<SolidSection> &sections,
                               ThreadPool &pool)
    : Elements(nodes, solid_shell::with_third(axes, cells), axes, sections, pool)
  {
  }

  double SolidElements::elastic_energy() const
  {
    return stored_energy()[0];
  }

  double SolidElements::hourglass_energy() const
  {
    return stored_energy()[1];
  }
} // namespace birdstrike
