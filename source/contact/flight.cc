#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr double never = std::numeric_limits<double>::infinity();

    struct Ray
    {
      Point3 origin, velocity;
      double half_size; // m

      Point3 at(const double time) const
      {
        return origin + time * velocity;
      }
    };

    Ray ray_of(const PointsView &points, const std::size_t i)
    {
      const auto vector = [i](const auto &v) { return Point3(v[0][i], v[1][i], v[2][i]); };
      return {vector(points.position), vector(points.velocity), 0.5 * std::cbrt(points.volume[i])};
    }

    /// Times at which the ray is inside a box widened by `margin`; empty (first > last) if it passes by.
    struct Interval
    {
      double first = 0., last = never;
    };
    Interval crossing(const Box &box, const double margin, const Ray &ray)
    {
      Interval inside;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double low = box.low[d] - margin - ray.origin[d], high = box.high[d] + margin - ray.origin[d];
          if (ray.velocity[d] == 0.)
            {
              if (low > 0. || high < 0.)
                inside.last = -1.;
              continue;
            }
          const double a = low / ray.velocity[d], b = high / ray.velocity[d];
          inside.first = std::max(inside.first, std::min(a, b));
          inside.last  = std::min(inside.last, std::max(a, b));
        }
      return inside;
    }

    class Surface
    {
    public:
      explicit Surface(const FacetsView &facets) : facets(facets)
      {
        topology.update(facets);
        boxes.resize(facets.n_facets);
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          for (const std::uint32_t node : facets.nodes[f])
            {
              boxes[f].add(facets.position + 3 * node);
              all.add(facets.position + 3 * node);
            }
      }

      /// g - distance to one facet, m; `normal` points from the facet to p.
      double overlap(const Point3 &p, const std::size_t f, const double half_size, Point3 &normal) const
      {
        const auto closest   = compute_closest_point(p, facet_nodes(facets, f));
        double     thickness = 0.;
        for (unsigned int k = 0; k < 4; ++k)
          thickness += closest.weights[k] * topology.half_thickness(facets.nodes[f][k]);
        const double distance = std::sqrt(closest.distance_squared);
        normal                = distance > 0. ? Point3(closest.offset / distance) : Point3::Zero();
        return thickness + half_size - distance;
      }

      /// First touch of one facet within the interval, or never.
      double touch(const Ray &ray, const std::size_t f, const Interval &interval) const
      {
        const double tolerance =
          1e-13 * (ray.half_size + topology.max_half_thickness() + (ray.at(interval.first) - ray.origin).norm());
        double time = interval.first;
        for (unsigned int iteration = 0; iteration < 1000 && time <= interval.last; ++iteration)
          {
            Point3       normal;
            const double gap = -overlap(ray.at(time), f, ray.half_size, normal);
            if (gap <= tolerance)
              return time;
            const double closing = -ray.velocity.dot(normal);
            if (closing <= 0.)
              return never;
            time += gap / closing;
          }
        return never;
      }

      double touch(const Ray &ray, double limit) const
      {
        const double margin = ray.half_size + topology.max_half_thickness();
        if (const Interval whole = crossing(all, margin, ray); whole.first > std::min(whole.last, limit))
          return limit;
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          {
            Interval interval = crossing(boxes[f], margin, ray);
            interval.last     = std::min(interval.last * (1. + 1e-12), limit);
            if (interval.first <= interval.last)
              limit = std::min(limit, touch(ray, f, interval));
          }
        return limit;
      }

      Overlap deepest(const Ray &ray, const std::uint32_t id) const
      {
        Overlap      result;
        const Ray    resting{ray.origin, Point3::Zero(), 0.};
        const double margin = ray.half_size + topology.max_half_thickness();
        if (crossing(all, margin, resting).last < 0.)
          return result;
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          {
            if (crossing(boxes[f], margin, resting).last < 0.)
              continue;
            Point3       normal;
            const double depth = overlap(ray.origin, f, ray.half_size, normal);
            if (depth > result.depth)
              result = {depth, id, ray.origin};
          }
        return result;
      }

    private:
      const FacetsView &facets;
      SurfaceTopology   topology;
      std::vector<Box>  boxes;
      Box               all;
    };
  } // namespace

  double time_to_first_touch(const PointsView &points, const FacetsView &facets)
  {
    const Surface surface(facets);
    double        first = never;
    for (std::size_t i = 0; i < points.n; ++i)
      first = surface.touch(ray_of(points, i), first);
    return first;
  }

  Overlap initial_overlap(const PointsView &points, const FacetsView &facets)
  {
    const Surface surface(facets);
    Overlap       result;
    for (std::size_t i = 0; i < points.n; ++i)
      if (const Overlap found = surface.deepest(ray_of(points, i), points.id[i]); found.depth > result.depth)
        result = found;
    return result;
  }
} // namespace birdstrike
