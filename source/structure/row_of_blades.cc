#include "structure/row_of_blades.h"
#include "structure/shell_kind.h"
#include "structure/solid_kind.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace birdstrike
{
  template <class Kind>
  RowOfBlades<Kind>::RowOfBlades(const MeshParameters::Row &row, const Mesh &mesh, const SectionTable &sections,
                                 const BladeRoles &described, const std::vector<unsigned int> &root_ids,
                                 const std::vector<unsigned int> &tip_ids)
    : n_sections(sections.n_of_blade)
  {
    if (row.n_blades == 1)
      return;
    const std::vector<unsigned int> places   = row.places();
    const std::vector<double>       angles   = row.angles();
    const std::vector<bool>         is_rigid = row.is_rigid();
    std::vector<std::uint32_t>      blade_of(mesh.nodes.size());
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (const std::uint32_t n : mesh.cells[cell])
        blade_of[n] = mesh.blade_of(cell);
    for (std::uint32_t k = 0; k < places.size(); ++k)
      {
        const Matrix3<double> R = Eigen::AngleAxisd(angles[k], Point3(row.axis.data()).normalized()).toRotationMatrix();
        const Point3          centre(row.centre.data());
        Member                member{places[k], is_rigid[k], k * n_sections, {}, {}, {}};
        for (std::uint32_t n = 0; n < mesh.space.n_owned(); ++n)
          if (blade_of[n] == k)
            member.nodes.push_back(n);
        member.root = typename Kind::Root(mesh, described.root.of_blade(mesh, root_ids, k, R, centre));
        member.tip  = TipRow(mesh, described.tip.of_blade(mesh, tip_ids, k, R, centre));
        members.push_back(std::move(member));
      }
    std::ranges::sort(members, {}, &Member::place);
  }

  template <class Kind>
  std::vector<BladeLoads> RowOfBlades<Kind>::loads(const double *force, const double *position,
                                                   const double *displacement, const Elements &elements,
                                                   const Turn &turned) const
  {
    std::vector<BladeLoads> all;
    for (const Member &member : members)
      {
        BladeLoads of{member.place, member.is_rigid, {}, {}};
        if (!member.is_rigid)
          {
            of.tip  = member.tip.compute_deflection(displacement, Kind::n_unknowns);
            of.root = member.root.compute_report(force, position, elements, turned);
          }
        all.push_back(std::move(of));
      }
    return all;
  }

  template <class Kind>
  void RowOfBlades<Kind>::add_nodes(std::vector<std::uint32_t> &nodes) const
  {
    for (const Member &member : members)
      {
        member.root.add_nodes(nodes);
        member.tip.add_nodes(nodes);
      }
  }

  template <class Kind>
  std::vector<BladeBalance> RowOfBlades<Kind>::balance(const Motion &motion, const Elements &elements) const
  {
    std::vector<BladeBalance> all;
    for (const Member &member : members)
      {
        BladeBalance of{member.place, member.is_rigid, {}, {}};
        std::tie(of.energies.kinetic, of.impulse) = motion.kinetic_and_impulse(member.nodes);
        for (std::size_t k = 0; k < n_sections; ++k)
          elements.add_energies_of(member.first_section + k, of.energies);
        all.push_back(of);
      }
    return all;
  }

  template class RowOfBlades<ShellKind>;
  template class RowOfBlades<SolidKind>;
} // namespace birdstrike
