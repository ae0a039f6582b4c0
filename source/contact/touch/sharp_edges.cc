#include "contact/touch/edge_profile.h"
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/sharp_edges.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr double blunt   = std::numbers::pi / 6.; // ridges below have no chamfer
    constexpr double watched = 0.5 * blunt;           // from here on their angle is looked at in every step
    constexpr double at_it   = 1e-9;                  // of the size: closer to an edge than this is on it

    Point3 node_at(const FacetsView &facets, const std::uint32_t node)
    {
      return Eigen::Map<const Point3>(facets.position + 3 * node);
    }

    Point3 centre_of(const std::array<Point3, 4> &x)
    {
      return 0.25 * (x[0] + x[1] + x[2] + x[3]);
    }

    Point3 closest_on_segment(const Point3 &p, const Point3 &a, const Point3 &b)
    {
      const Point3 along = b - a;
      return a + std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0., 1.) * along;
    }

    /// Frame of a face at its edge from a to b: the face's normal there and the outward direction in its plane.
    struct Frame
    {
      Point3 normal, outward;
    };
    Frame frame_at(const FacetsView &facets, const std::int32_t facet, const Point3 &a, const Point3 &b)
    {
      const Point3 centre = centre_of(facet_nodes(facets, static_cast<std::size_t>(facet)));
      const Point3 normal = (b - a).cross(centre - a).normalized();
      return {normal, (b - a).cross(normal).normalized()};
    }

    /// Bounds a face at a right-angled edge, s beyond it and z above the face, by the plane s + z = 0. The normal is
    /// its gradient, as that of the face.
    void bound(const Point3 &outward, const double s, const double z, EdgeTouch &touch)
    {
      const double cosine = std::sqrt(0.5);
      touch.limit         = -cosine * (s + z);
      touch.limit_normal  = cosine * (outward + touch.normal - touch.slope);
      if (touch.limit <= 0.)
        touch.feature = EdgeTouch::Feature::beyond;
    }
  } // namespace

  struct SharpEdges::Foot
  {
    const Edge *edge;
    Point3      from_closest; // to the foot
    double      distance;
  };

  void SharpEdges::update(const FacetsView &facets, const double reach)
  {
    if (facets.two_sided && facets.revision == revision && reach == known_reach && first.size() == facets.n_facets + 1)
      return;
    revision    = facets.revision;
    known_reach = reach;
    find_edges(facets);
    spread(facets, 1.25 * reach); // facets stretch by a few per cent, and fail before they stretch by a quarter
  }

  void SharpEdges::find_edges(const FacetsView &facets)
  {
    edges.clear();
    normals.clear();
    if (!facets.two_sided)
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        normals.push_back(compute_area_vector(facet_nodes(facets, f)).normalized());
    for (std::uint32_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (is_edge(facets.nodes[f], k))
          {
            const std::int32_t g = facets.neighbor[f][k];
            if (g == FacetsView::free_edge)
              edges.push_back(
                {{{facets.nodes[f][k], facets.nodes[f][(k + 1) % 4]}}, {{static_cast<std::int32_t>(f), -1}}});
            else if (!facets.two_sided && g > static_cast<std::int32_t>(f))
              add_ridge(facets, f, k);
          }
  }

  void SharpEdges::add_ridge(const FacetsView &facets, const std::uint32_t f, const unsigned int k)
  {
    const std::int32_t                 g = facets.neighbor[f][k];
    const std::array<std::uint32_t, 2> nodes{{facets.nodes[f][k], facets.nodes[f][(k + 1) % 4]}};
    const double                       cosine = normals[f].dot(normals[static_cast<std::size_t>(g)]);
    if (cosine > std::cos(watched))
      return;
    const Edge   edge{nodes, {{static_cast<std::int32_t>(f), g}}};
    const Point3 a = node_at(facets, nodes[0]), b = node_at(facets, nodes[1]);
    // seen from both facets alike, whichever comes first
    if (frame_at(facets, edge.facets[0], a, b).normal.dot(frame_at(facets, g, b, a).outward) > 0.) // not hollow
      edges.push_back(edge);
  }

  void SharpEdges::spread(const FacetsView &facets, const double reach)
  {
    found.clear();
    seen.assign(facets.n_facets, 0);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      {
        const Point3 a = node_at(facets, edges[e].nodes[0]), b = node_at(facets, edges[e].nodes[1]);
        const auto   is_near = [&](const std::size_t f) {
          const auto x = facet_nodes(facets, f);
          for (const Point3 &p : x)
            if ((p - closest_on_segment(p, a, b)).squaredNorm() < reach * reach)
              return true;
          for (const Point3 &p : {a, b, Point3(0.5 * (a + b))})
            if (compute_closest_point(p, x).distance_squared < reach * reach)
              return true;
          return false;
        };
        for (const std::int32_t facet : edges[e].facets)
          if (facet >= 0)
            front.push_back(facet);
        while (!front.empty())
          {
            const auto f = static_cast<std::uint32_t>(front.back());
            front.pop_back();
            if (seen[f] == e + 1 || !is_near(f))
              continue;
            seen[f] = e + 1;
            found.push_back({{f, e}});
            for (const std::int32_t g : facets.neighbor[f])
              if (g >= 0 && seen[static_cast<std::size_t>(g)] != e + 1)
                front.push_back(g);
          }
      }
    std::sort(found.begin(), found.end());
    first.assign(facets.n_facets + 1, 0);
    near.clear();
    for (const auto &[facet, edge] : found)
      {
        ++first[facet + 1];
        near.push_back(edge);
      }
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      first[f + 1] += first[f];
  }

  bool SharpEdges::is_sharp(const FacetsView &facets, const Edge &edge) const
  {
    if (edge.facets[1] < 0)
      return true;
    const Point3 a = node_at(facets, edge.nodes[0]), b = node_at(facets, edge.nodes[1]);
    const Frame  one = frame_at(facets, edge.facets[0], a, b), other = frame_at(facets, edge.facets[1], b, a);
    return one.normal.dot(other.normal) <= std::cos(blunt) && one.normal.dot(other.outward) > 0.;
  }

  void SharpEdges::cut(const FacetsView &facets, const std::uint32_t facet, const Point3 &closest,
                       EdgeTouch &touch) const
  {
    // the nearest edge; on a corner all that meet there
    const auto to_foot = [&](const Edge &edge) {
      return Point3(closest_on_segment(closest, node_at(facets, edge.nodes[0]), node_at(facets, edge.nodes[1])) -
                    closest);
    };
    double smallest = edge_reach(touch.size);
    for (std::uint32_t n = first[facet]; n < first[facet + 1]; ++n)
      if (const Edge &edge = edges[near[n]];
          to_foot(edge).squaredNorm() < smallest * smallest && is_sharp(facets, edge))
        smallest = to_foot(edge).norm();
    if (smallest >= edge_reach(touch.size))
      return;
    const EdgeTouch smooth = touch;
    bool            is_cut = false;
    for (std::uint32_t n = first[facet]; n < first[facet + 1]; ++n)
      {
        const Edge &edge = edges[near[n]];
        Foot        foot;
        foot.edge         = &edge;
        foot.from_closest = to_foot(edge);
        foot.distance     = foot.from_closest.norm();
        if (foot.distance > smallest + at_it * touch.size || !is_sharp(facets, edge))
          continue;
        EdgeTouch here = smooth;
        if (edge.facets[1] < 0)
          cut_rim(facets, foot, here);
        else
          cut_ridge(facets, foot, here);
        if (!is_cut || here.limit < touch.limit)
          touch = here;
        is_cut = true;
      }
  }

  void SharpEdges::cut_rim(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const
  {
    const Point3 a = node_at(facets, foot.edge->nodes[0]), b = node_at(facets, foot.edge->nodes[1]);
    const Frame  frame   = frame_at(facets, foot.edge->facets[0], a, b);
    const auto   outward = [&](const Point3 &direction, const double length, const Point3 &up) {
      const Point3 &along = length > at_it * touch.size ? direction : frame.outward;
      return Point3((along - along.dot(up) * up).normalized());
    };
    if (!touch.is_beyond)
      {
        const Point3 out = outward(foot.from_closest, foot.distance, touch.normal);
        const double z   = touch.height - touch.half_thickness;
        bound(out, -foot.distance, z, touch);
        if (touch.was_on_edge_face && z < 0. && touch.feature == EdgeTouch::Feature::face)
          {
            touch.feature    = EdgeTouch::Feature::edge_face;
            touch.overlap    = 0.5 * touch.size + foot.distance;
            touch.normal     = out;
            touch.is_oblique = true;
          }
        return;
      }
    const double height = touch.offset.dot(frame.normal), side = touch.height < 0. ? -1. : 1.; // through it, or not
    const double z  = side * std::abs(height) - touch.half_thickness;
    const Point3 up = (height < 0. ? -side : side) * frame.normal, r = touch.offset - height * frame.normal;
    const double s = r.norm();
    touch.overlap  = 0.5 * touch.size - std::hypot(s, std::max(z, 0.));
    touch.normal   = up;
    bound(outward(r, s, up), s, z, touch);
    touch.normal     = outward(r, s, up);
    touch.is_oblique = true;
    if (z < 0. && touch.feature == EdgeTouch::Feature::face)
      touch.feature = EdgeTouch::Feature::edge_face;
  }

  void SharpEdges::cut_ridge(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const
  {
    const Edge  &edge = *foot.edge;
    const Point3 a = node_at(facets, edge.nodes[0]), b = node_at(facets, edge.nodes[1]);
    const Point3 first_normal  = frame_at(facets, edge.facets[0], a, b).normal,
                 second_normal = frame_at(facets, edge.facets[1], b, a).normal;
    const double angle         = std::acos(std::clamp(first_normal.dot(second_normal), -1., 1.));
    const double round         = 0.5 * touch.size * round_share(angle);
    const Point3 bisector      = (first_normal + second_normal).normalized();
    touch.limit                = round - bisector.dot(touch.offset - foot.from_closest);
    touch.limit_normal         = bisector;
    if (touch.limit <= 0.)
      touch.feature = EdgeTouch::Feature::beyond;
  }
} // namespace birdstrike
