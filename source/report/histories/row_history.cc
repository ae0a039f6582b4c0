#include <birdstrike/report/row_history.h>
#include <birdstrike/structure/blade.h>

namespace birdstrike
{
  RowHistory::RowHistory(const Blade &blade) : blade(blade)
  {
    name = "blades";
    for (const BladeBalance &of : blade.balance_of_row())
      {
        const std::string member = "blade_" + std::to_string(of.place) + ".";
        const std::string where  = " of the blade in place " + std::to_string(of.place) + " of the row";
        columns.push_back({member + "kinetic_energy", "J", "Kinetic energy" + where + ", in fixed axes"});
        if (of.is_rigid)
          continue;
        columns.push_back({member + "elastic_energy", "J", "Energy stored in the elements" + where});
        columns.push_back({member + "plastic_work", "J", "Plastic work" + where});
        columns.push_back({member + "tip_deflection", "m",
                           "Deflection of the tip at mid-chord" + where +
                             ", for somebody on the hub, away from the "
                             "struck side of the described blade"});
        columns.push_back({member + "root_normal_force", "N", "Force along the span on the root" + where});
        columns.push_back({member + "root_transverse_force", "N", "Force across the surface on the root" + where});
        columns.push_back({member + "root_moment", "N m", "Bending moment at the root" + where});
        columns.push_back(
          {member + "root_stress", "Pa", "Largest normal stress along the span of the root's elements" + where});
      }
  }

  void RowHistory::fill(const std::span<double> row) const
  {
    const std::vector<BladeBalance> balances = blade.balance_of_row();
    const std::vector<BladeLoads>   loads    = blade.loads_of_row();
    std::size_t                     n        = 0;
    for (std::size_t k = 0; k < balances.size(); ++k)
      {
        row[n++] = balances[k].energies.kinetic;
        if (balances[k].is_rigid)
          continue;
        const RootSectionReport &root = loads[k].root;
        for (const double value : {balances[k].energies.elastic, balances[k].energies.plastic, loads[k].tip.mid_chord,
                                   root.normal_force, root.transverse_force, root.bending_moment, root.peak_stress()})
          row[n++] = value;
      }
  }
} // namespace birdstrike
