#include <birdstrike/contact/dissipation.h>
#include <birdstrike/core/simd/larger.h>

namespace birdstrike
{
  double add_spin_power(double power, const FacetsView &facets, const std::array<std::uint32_t, 4> &nodes,
                        const Point3 &turn, const Point3 &tilt, const std::array<double, 4> &turn_weights)
  {
    const auto   position = [&](const std::uint32_t node) { return Point3(facets.position + 3 * node); };
    const Point3 mean     = 0.25 * (position(nodes[0]) + position(nodes[1]) + position(nodes[2]) + position(nodes[3]));
    for (unsigned int k = 0; k < 4; ++k)
      power += (turn.cross(position(nodes[k]) - mean) + turn_weights[k] * tilt)
                 .dot(Point3(facets.velocity + nodes[k] * facets.velocity_stride));
    return power;
  }

  void Dissipation::book_past(const PointsView &points, const FacetsView &facets, const PointMemory &memory,
                              const double step)
  {
    auto couple = past_couples.begin();
    for (const Past &touch : past)
      {
        const auto  is_at   = [&](const std::size_t i) { return i < points.n && points.id[i] == touch.id; };
        std::size_t i       = touch.index;
        double      to_come = 0.; // of a point that has left the computation
        if (is_at(i) || is_at(i = memory.data()[touch.id].index))
          {
            Point3 velocity(points.velocity[0][i], points.velocity[1][i], points.velocity[2][i]);
            for (unsigned int k = 0; k < 4; ++k)
              velocity -= touch.weights[k] * Point3(facets.velocity + touch.nodes[k] * facets.velocity_stride);
            double power = -touch.force.dot(velocity);
            if (touch.has_couple)
              power = add_spin_power(power, facets, touch.nodes, couple->turn, couple->tilt, couple->turn_weights);
            to_come = 0.5 * step * power;
          }
        if (touch.has_couple)
          ++couple;
        booked += touch.taken + to_come;
      }
    past.clear();
    past_couples.clear();
    under_way    = 0.;
    most         = larger(most, booked);
    largest_fall = larger(largest_fall, most - booked);
    reported     = larger(reported, booked);
  }

  void Dissipation::add_released(const double energy)
  {
    booked += energy;
    lost += energy;
    most     = larger(most, booked);
    reported = larger(reported, booked);
  }

  void Dissipation::add(const PointsView &points, const FacetsView &facets, const std::vector<TouchRecord> &touches,
                        const double step)
  {
    for (const TouchRecord &touch : touches)
      if (touch.dissipative != Point3::Zero())
        {
          const auto  &nodes = facets.nodes[touch.facet];
          const double taken = -0.5 * step * touch.dissipative.dot(touch.velocity);
          under_way += taken;
          reported       = larger(reported, booked + under_way);
          Past &now      = past.emplace_back();
          now.id         = points.id[touch.point];
          now.nodes      = nodes;
          now.index      = touch.point;
          now.weights    = touch.weights;
          now.force      = touch.dissipative;
          now.taken      = taken;
          now.has_couple = touch.turn != Point3::Zero() || touch.tilt != Point3::Zero();
          if (now.has_couple)
            past_couples.push_back({touch.turn, touch.tilt, touch.turn_weights});
        }
  }
} // namespace birdstrike
