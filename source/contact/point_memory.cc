#include <birdstrike/contact/point_memory.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  void PointMemory::update(const PointsView &points)
  {
    if (!is_empty && points.revision == revision && points.n_ids == records.size())
      return;
    is_empty = false;
    revision = points.revision;
    records.resize(std::max(points.n_ids, records.size()));
    for (std::size_t i = 0; i < points.n; ++i)
      {
        PointRecord &record = records[points.id[i]];
        record.index        = static_cast<std::uint32_t>(i);
        if (record.size > 0.)
          continue;
        record.size        = points.spacing;
        record.density     = points.undeformed_density;
        record.sound_speed = points.undeformed_sound_speed;
        largest_size       = std::max(largest_size, record.size);
      }
  }

  void PointMemory::forget_sides()
  {
    for (PointRecord &record : records)
      record.sides = {};
  }
} // namespace birdstrike
