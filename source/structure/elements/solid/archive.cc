#include "structure/elements/solid/group.h"

namespace birdstrike
{
  void SolidGroup::archive(Archive &archive)
  {
    archive.entities("bricks", ids(1), [&](Archive::Row &row, const std::size_t e) {
      const std::size_t b       = e / n_lanes;
      const auto        in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      row("viscous pressure", in_lane(batches[b].viscous_pressure));
      if (stabilisation.empty())
        return;
      for (int k = 0; k < 3; ++k)
        {
          constexpr const char *names[] = {"hourglass stress 1", "hourglass stress 2", "hourglass stress 3"};
          Stabilisation        &s       = stabilisation[b];
          row(names[k], in_lane(s.linear[k][0]), in_lane(s.linear[k][1]), in_lane(s.linear[k][2]), in_lane(s.last[k]));
        }
    });
    archive.entities("points", ids(n_points()), [&](Archive::Row &row, const std::size_t number) {
      const std::size_t  e       = number / n_points();
      const auto         in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      SolidPoint<Lanes> &point   = points[n_points() * (e / n_lanes) + number % n_points()];
      auto              &s       = point.stress;
      row("stress", in_lane(s[0]), in_lane(s[1]), in_lane(s[2]), in_lane(s[3]), in_lane(s[4]), in_lane(s[5]));
      row("plastic strain", in_lane(point.plastic_strain));
      row("yield stress", in_lane(point.yield));
      row("plastic work", in_lane(point.plastic_work));
      if (erosion)
        row("damage", in_lane(erosion->damage[e / n_lanes][number % n_points()]));
    });
    if (!layers.empty())
      archive_layers(archive);
    if (erosion)
      archive_ledger(archive);
  }

  /// Points through the thickness, of solid-shells that have them: number rule.n element + k. Batches get them
  /// together; of another width, elements that had none get those of an elastic section.
  void SolidGroup::archive_layers(Archive &archive)
  {
    std::vector<std::uint64_t> layer_ids;
    for (std::size_t e = 0; e < n_elements(); ++e)
      for (std::size_t k = 0; k < layers[e / n_lanes].size(); ++k)
        layer_ids.push_back(std::uint64_t(rule.n) * place.number[e] + k);
    archive.population("layers", layer_ids);
    archive.rows("layers", layer_ids.size(), [&](Archive::Row &row, const std::size_t i) {
      const std::size_t e = find(layer_ids[i] / rule.n), b = e / n_lanes;
      if (layers[b].empty())
        promote(b);
      const auto  in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      LayerPoint &point   = layers[b][layer_ids[i] % rule.n];
      auto       &r       = point.residual;
      row("residual stress", in_lane(r[0]), in_lane(r[1]), in_lane(r[2]), in_lane(r[3]), in_lane(r[4]));
      row("plastic strain", in_lane(point.plastic_strain));
      row("yield stress", in_lane(point.yield));
      row("plastic work", in_lane(point.plastic_work));
    });
  }

  /// See SolidErosion.
  void SolidGroup::archive_ledger(Archive &archive)
  {
    archive.entities("ledgers", ids(1), [&](Archive::Row &row, const std::size_t e) {
      SolidErosion::OfElements &own     = erosion->elements[e / n_lanes];
      const auto                in_lane = [&](Lanes &batch) { return lane_of(batch, e); };
      const auto                vector  = [&](const char *name, Vector3<Lanes> &f) {
        row(name, in_lane(f[0]), in_lane(f[1]), in_lane(f[2]));
      };
      constexpr const char *linear[] = {"force on mode 1", "force on mode 2", "force on mode 3"};
      constexpr const char *twist[]  = {"force on mode 4", "force on mode 5", "force on mode 6"};
      row("held energy", in_lane(own.held));
      for (int k = 0; k < 3; ++k)
        {
          vector(linear[k], own.force.linear[k]);
          vector(twist[k], own.force.twist[k]);
        }
      vector("force on mode 7", own.force.last);
    });
  }
} // namespace birdstrike
