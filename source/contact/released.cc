#include "contact/law.h"
#include <birdstrike/contact/contact.h>

#include <cmath>

// The energy that springs lose otherwise than by the way of their points.
namespace birdstrike
{
  void Contact::note_depths(const PointsView &points)
  {
    depths_before.resize(points.n);
    for (std::size_t i = 0; i < points.n; ++i)
      {
        const PointRecord &record = memory[points.id[i]];
        depths_before[i]          = record.last_call + 1 == last.calls ? record.sides[0].depth : 0.;
      }
  }

  double Contact::energy_of(const std::vector<ReleasedDepth> &depths, const ContactLaw &law) const
  {
    double sum = 0.;
    for (const ReleasedDepth &depth : depths)
      {
        const PointRecord &record    = memory.data()[depth.id];
        const double       stiffness = law.stiffness_scale * record.modulus * record.size;
        const double       beta      = law.hardening(record.softening()) / record.size;
        sum += ContactSpring<double>(stiffness, beta, depth.due).energy -
               ContactSpring<double>(stiffness, beta, depth.now).energy;
      }
    return sum;
  }

  /// What a depth has lost besides the way of its point: to another facet, and as facets failed or edges came up beside
  /// it, which points that are no longer looked at lose too.
  void Contact::book_released(const ContactScene &scene)
  {
    for (const BlockReport &report : block_reports)
      dissipation.add_released(report.released_energy);
    if (!is_changed)
      return;
    std::vector<ReleasedDepth> depths;
    for (const CandidateBlock &block : search.blocks())
      for (std::size_t i = block.begin; i < block.end; ++i)
        {
          const PointRecord &record = memory[scene.points.id[i]];
          const double       way    = std::sqrt(block.point_motions_squared[i - block.begin]) + scene.nodes_motion;
          const double       now    = record.last_call == last.calls ? record.sides[0].depth : 0.;
          const double       due    = depths_before[i] - way;
          if (due > now)
            depths.push_back({scene.points.id[i], due, now});
        }
    dissipation.add_released(energy_of(depths, law(scene)));
  }
} // namespace birdstrike
