#include "structure/elements/shell/group.h"

namespace birdstrike
{
  void ShellGroup::archive(Archive &archive)
  {
    archive.entities("sections", ids(n_in_plane), [&](Archive::Row &row, const std::size_t number) {
      const std::size_t     e = number / n_in_plane, b = e / n_lanes;
      const auto            in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      SectionStress<Lanes> &s       = n_in_plane == 1 ? stress[b] : sections[n_in_plane * b + number % n_in_plane];
      row("thickness", in_lane(s.thickness));
      row("mean stress", in_lane(s.mean[0]), in_lane(s.mean[1]), in_lane(s.mean[2]));
      row("outer stress", in_lane(s.outer[0]), in_lane(s.outer[1]), in_lane(s.outer[2]));
      row("shear stress", in_lane(s.shear[0]), in_lane(s.shear[1]));
      if (n_in_plane > 1)
        return;
      ShellStress<Lanes> &hourglass = stress[b];
      row("hourglass membrane stress", in_lane(hourglass.linear_membrane[0]), in_lane(hourglass.linear_membrane[1]));
      row("hourglass bending stress", in_lane(hourglass.linear_curvature[0]), in_lane(hourglass.linear_curvature[1]));
      row("hourglass shear stress", in_lane(hourglass.linear_shear[0]), in_lane(hourglass.linear_shear[1]));
    });
    if (laminate)
      archive_laminate(archive);
    else
      archive_points(archive);
  }

  /// Through the thickness, of sections that have them: number rule.n section + k. Batches get them together; of
  /// another width, elements that had none get those of their elastic section.
  void ShellGroup::archive_points(Archive &archive)
  {
    std::vector<std::uint64_t> point_ids;
    for (std::size_t e = 0; e < n_elements(); ++e)
      for (std::size_t s = 0; s < n_in_plane; ++s)
        for (std::size_t k = 0; k < points[n_in_plane * (e / n_lanes) + s].size(); ++k)
          point_ids.push_back(law.rule.n * (std::uint64_t(n_in_plane) * place.number[e] + s) + k);
    archive.population("points", point_ids);
    archive.rows("points", point_ids.size(), [&](Archive::Row &row, const std::size_t i) {
      const std::uint64_t section_id = point_ids[i] / law.rule.n;
      const std::size_t   e = find(section_id / n_in_plane), k = point_ids[i] % law.rule.n;
      const std::size_t   at = n_in_plane * (e / n_lanes) + section_id % n_in_plane; // in `points`
      if (points[at].empty())
        promote(at);
      const auto         in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      ShellPoint<Lanes> &point   = points[at][k];
      row("stress", in_lane(point.stress[0]), in_lane(point.stress[1]), in_lane(point.stress[2]));
      row("plastic strain", in_lane(point.plastic_strain));
      row("yield stress", in_lane(point.yield));
      row("plastic work", in_lane(point.plastic_work));
      if (!erosion)
        return;
      erosion->damage[at].resize(law.rule.n, Lanes(0.));
      row("damage", in_lane(erosion->damage[at][k]));
    });
  }
} // namespace birdstrike
