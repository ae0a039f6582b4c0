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
    constexpr double      never            = std::numeric_limits<double>::infinity();
    constexpr double      tie              = 1e-9; // relative difference of equal distances
    constexpr std::size_t facets_per_group = 16;   // that follow one another in the mesh, and so lie together

    struct Ray
    {
      Point3 origin, velocity;
      double half_size; // m

      TimeSpan passage(const Box &box) const
      {
        return box.passage(origin, velocity);
      }
      Point3 at(const double time) const
      {
        return origin + time * velocity;
      }
    };

    Ray ray_of(const PointsView &points, const std::size_t i)
    {
      const auto vector = [i](const auto &v) { return Point3(v[0][i], v[1][i], v[2][i]); };
      return {vector(points.position), vector(points.velocity), 0.5 * points.spacing};
    }

    bool is_plane(const std::array<Point3, 4> &x)
    {
      const Point3 twice_area = compute_area_vector(x);
      return std::abs((x[1] - x[0]).dot(twice_area)) + std::abs((x[3] - x[0]).dot(twice_area)) <=
             1e-9 * twice_area.norm() * std::sqrt(twice_area.norm());
    }

    class Surface
    {
    public:
      Surface(const PointsView &points, const FacetsView &facets) : facets(facets)
      {
        topology.update(facets);
        topology.update_slowly(facets, points.spacing);
        boxes.resize(facets.n_facets);
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          is_flat.push_back(is_plane(facet_nodes(facets, f)));
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          for (const std::uint32_t node : facets.nodes[f])
            {
              boxes[f].add(facets.position + 3 * node);
              all.add(facets.position + 3 * node);
            }
        groups.resize((facets.n_facets + facets_per_group - 1) / facets_per_group);
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          groups[f / facets_per_group].add(boxes[f]);
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
      double touch(const Ray &ray, const std::size_t f, const TimeSpan &interval) const
      {
        return enter(ray, interval.first, interval.last, is_flat[f],
                     [&](const Point3 &p, Point3 &normal, double &clear) {
                       const double depth = overlap(p, f, ray.half_size, normal);
                       clear              = -depth;
                       return depth;
                     });
      }

      /// Where the nearest facet's edges let the point in, or past: the offset surface is inside that without edges, so
      /// the search starts where that is touched. m, negative outside. Of a point further than twice the margin
      /// from all facets it is only known to be below minus the margin, which is what it gets. `clear`: how far it is
      /// from the surface without edges, m; the planes at edges come and go with the facets below the point.
      double depth(const Point3 &p, const double half_size, Point3 &normal, double &clear) const
      {
        const double margin = half_size + topology.max_half_thickness();
        const Ray    resting{p, Point3::Zero(), 0.};
        double       smallest = never, highest = 0.;
        clear = margin;
        EdgeTouch result;
        result.overlap = -margin;
        for_each_in_the_way(resting, 2. * margin, never, [&](const std::size_t f, const TimeSpan &) {
          const auto   x        = facet_nodes(facets, f);
          const auto   closest  = compute_closest_point(p, x);
          const double distance = std::sqrt(closest.distance_squared),
                       height   = std::abs(closest.offset.dot(compute_area_vector(x).normalized()));
          if (distance > smallest * (1. + tie) || (distance >= smallest * (1. - tie) && height <= highest))
            return;
          smallest         = std::min(smallest, distance);
          highest          = height;
          double thickness = 0.;
          for (unsigned int k = 0; k < 4; ++k)
            thickness += closest.weights[k] * topology.half_thickness(facets.nodes[f][k]);
          const Point3 outward = distance > 0. ? Point3(closest.offset / distance) : Point3::Zero();
          clear                = distance - half_size - thickness;
          result               = {closest.offset,
                                  distance,
                                  thickness,
                                  2. * half_size,
                                  topology.is_on_rim(facets, f, closest.weights),
                                  false,
                                  half_size + thickness - distance,
                                  outward};
          if (topology.sharp_edges().are_near(f))
            topology.sharp_edges().cut(facets, f, p - closest.offset, result);
        });
        normal = result.limit < result.overlap ? result.limit_normal : result.normal;
        return std::min(result.limit, result.overlap);
      }

      /// When the ray first comes where `depth(place, normal, clear)` is positive, from a time at which it is outside
      /// on, or never. Newton's step, exact on planes; where it oversteps, bisection. What is around a convex body does
      /// not come back once it is left behind.
      template <class Depth>
      double enter(const Ray &ray, double time, const double last, const bool is_convex, const Depth &depth) const
      {
        const double size = ray.half_size + topology.max_half_thickness(), speed = ray.velocity.norm();
        const double tolerance = 1e-13 * (size + (ray.at(time) - ray.origin).norm());
        double       outside   = time;
        const double way       = speed > 0. ? speed * (last - time) / size : 0.;
        const double n_most    = 1000. + (is_convex ? 0. : 50. * way); // steps of 0.02, and Newton's
        for (double n = 0.; n < n_most && time <= last; ++n)
          {
            Point3       normal = Point3::Zero();
            double       clear  = 0.;
            const double gap    = -depth(ray.at(time), normal, clear);
            if (gap <= tolerance)
              return gap >= -tolerance || outside == time ? time : bisect(ray, outside, time, depth);
            outside              = time;
            const double closing = -ray.velocity.dot(normal);
            if (closing <= 0. && is_convex)
              return never;
            const double newton = closing > 0. ? gap / closing : never;
            time += is_convex ? newton : std::min(newton, std::max(clear, 0.02 * size) / speed);
          }
        return never;
      }

      template <class Depth>
      double bisect(const Ray &ray, double outside, double inside, const Depth &depth) const
      {
        for (unsigned int iteration = 0; iteration < 60; ++iteration)
          {
            const double middle = 0.5 * (outside + inside);
            double       clear;
            Point3       normal;
            (depth(ray.at(middle), normal, clear) > 0. ? inside : outside) = middle;
          }
        return inside;
      }

      double touch(const Ray &ray, const double limit) const
      {
        const double   margin = ray.half_size + topology.max_half_thickness();
        const TimeSpan whole  = ray.passage(all.widened(margin));
        if (whole.first > std::min(whole.last, limit))
          return limit;
        double first = limit;
        for_each_in_the_way(ray, margin, first, [&](const std::size_t f, const TimeSpan &interval) {
          first = std::min(first, touch(ray, f, interval));
        });
        const auto beside_edges = [&](const Point3 &p, Point3 &normal, double &clear) {
          return depth(p, ray.half_size, normal, clear);
        };
        return first < limit ? std::min(limit, enter(ray, first, std::min(whole.last, limit), false, beside_edges))
                             : limit;
      }

      Overlap deepest(const Ray &ray, const std::uint32_t id) const
      {
        const Ray    resting{ray.origin, Point3::Zero(), 0.};
        const double margin = ray.half_size + topology.max_half_thickness();
        if (resting.passage(all.widened(margin)).is_empty())
          return {};
        double       clear;
        Point3       normal;
        const double found = depth(ray.origin, ray.half_size, normal, clear);
        return found > 0. ? Overlap{found, id, ray.origin} : Overlap{};
      }

    private:
      /// Visits the facets, in their order, whose boxes widened by the margin the ray passes before `limit`, which a
      /// visit may lower, and when.
      template <class Visit>
      void for_each_in_the_way(const Ray &ray, const double margin, const double &limit, const Visit &visit) const
      {
        const auto passage = [&](const Box &box) {
          const TimeSpan inside = ray.passage(box.widened(margin));
          return TimeSpan{inside.first, std::min(inside.last * (1. + 1e-12), limit)};
        };
        for (std::size_t g = 0; g < groups.size(); ++g)
          if (!passage(groups[g]).is_empty())
            for (std::size_t f = g * facets_per_group; f < std::min((g + 1) * facets_per_group, boxes.size()); ++f)
              if (const TimeSpan interval = passage(boxes[f]); !interval.is_empty())
                visit(f, interval);
      }

      const FacetsView &facets;
      SurfaceTopology   topology;
      std::vector<Box>  boxes, groups;
      std::vector<bool> is_flat; // and so convex: a warped facet is four triangles
      Box               all;
    };
  } // namespace

  double time_to_first_touch(const PointsView &points, const FacetsView &facets)
  {
    const Surface surface(points, facets);
    double        first = never;
    for (std::size_t i = 0; i < points.n; ++i)
      first = surface.touch(ray_of(points, i), first);
    return first;
  }

  Overlap initial_overlap(const PointsView &points, const FacetsView &facets)
  {
    const Surface surface(points, facets);
    Overlap       result;
    for (std::size_t i = 0; i < points.n; ++i)
      if (const Overlap found = surface.deepest(ray_of(points, i), points.id[i]); found.depth > result.depth)
        result = found;
    return result;
  }
} // namespace birdstrike
