#include <birdstrike/contact/dissipation.h>

#include <algorithm>

namespace birdstrike
{
  void Dissipation::book_past(const PointsView &points, const FacetsView &facets, const PointMemory &memory,
                              const double step)
  {
    for (const Past &touch : past)
      {
        const std::size_t i       = memory.data()[touch.id].index;
        double            to_come = 0.; // of a point that has left the computation
        if (i < points.n && points.id[i] == touch.id)
          {
            Point3 velocity(points.velocity[0][i], points.velocity[1][i], points.velocity[2][i]);
            for (unsigned int k = 0; k < 4; ++k)
              velocity -= touch.weights[k] * Point3(facets.velocity + touch.nodes[k] * facets.velocity_stride);
            to_come = -0.5 * step * touch.force.dot(velocity);
          }
        booked += touch.taken + to_come;
      }
    past.clear();
    under_way    = 0.;
    most         = std::max(most, booked);
    largest_fall = std::max(largest_fall, most - booked);
    reported     = std::max(reported, booked);
  }

  void Dissipation::add(const PointsView &points, const FacetsView &facets, const std::vector<TouchRecord> &touches,
                        const double step)
  {
    for (const TouchRecord &touch : touches)
      if (touch.dissipative != Point3::Zero())
        {
          const double taken = -0.5 * step * touch.dissipative.dot(touch.velocity);
          under_way += taken;
          reported = std::max(reported, booked + under_way);
          past.push_back({points.id[touch.point], facets.nodes[touch.facet], touch.weights, touch.dissipative, taken});
        }
  }
} // namespace birdstrike
