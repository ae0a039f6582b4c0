#include "contact/touch_records.h"
#include "contact/couple.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// The moment that a force of 1 N along an edge's normal and its turns leave, m.
    Point3 left_over_of(const FacetsView &facets, const TouchRecord &touch)
    {
      const auto x      = facet_nodes(facets, touch.facet);
      Point3     moment = touch.offset.cross(touch.normal);
      for (unsigned int k = 1; k < 4; ++k)
        moment -= touch.turn_weights[k] * (x[k] - x[0]).cross(touch.turn_normal);
      return moment / touch.normal.squaredNorm();
    }

    /// What a couple changes in the relative velocity and in the forces on the nodes.
    void add_spin(const FacetsView &facets, const bool has_friction, TouchRecord &touch)
    {
      const Couple couple(facets, has_friction, touch);
      touch.velocity -= couple.velocity(facets);
      const Point3 normal = touch.normal.normalized();
      touch.loads         = couple.loads(normal);
      if (!has_friction)
        return;
      const auto along = couple.largest_loads_across(normal);
      for (unsigned int k = 0; k < 4; ++k)
        touch.loads[k] = std::max(touch.loads[k], along[k]);
    }

    /// Moves the place where the force acts from the closest point to the edge that carries it, and to one of the
    /// facets there.
    void move_to_edge(const PointsView &points, const FacetsView &facets, const EdgePlace &edge,
                      const std::uint32_t facet, TouchRecord &touch)
    {
      touch.facet    = facet;
      touch.offset   = edge.offset;
      touch.velocity = {points.velocity[0][touch.point], points.velocity[1][touch.point],
                        points.velocity[2][touch.point]};
      touch.weights  = {};
      for (unsigned int end = 0; end < 2; ++end)
        {
          const auto &nodes  = facets.nodes[facet];
          const auto  k      = std::find(nodes.begin(), nodes.end(), edge.nodes[end]) - nodes.begin();
          const auto  weight = end == 0 ? 1. - edge.share : edge.share;
          touch.weights[static_cast<std::size_t>(k)] = weight;
          touch.velocity -= weight * Point3(facets.velocity + edge.nodes[end] * facets.velocity_stride);
        }
    }

    /// What forces on the edge's plane do to the nodes of one of its facets by that one's turns. On facets much smaller
    /// than the depth of the plane they stay `largest` times the force.
    void turn_with_facet(const FacetsView &facets, const EdgePlace &edge, const unsigned int carrier,
                         TouchRecord &touch)
    {
      constexpr double largest = 4.;
      const auto      &nodes   = facets.nodes[touch.facet];
      const auto       x       = facet_nodes(facets, touch.facet);
      const auto       find    = [&](const std::uint32_t node) {
        return static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
      };
      const std::size_t a = find(edge.nodes[carrier]), b = find(edge.nodes[1 - carrier]);
      const Point3      along = x[b] - x[a], from_a = 0.25 * (x[0] + x[1] + x[2] + x[3]) - x[a];
      const double      length = along.norm(), height = along.cross(from_a).norm() / length;
      const double      share = along.dot(from_a) / (length * length); // of the foot of the centre
      touch.is_edge           = true;
      touch.turn_normal       = along.cross(from_a).normalized();
      const double about = edge.turns[carrier].about / height, across = edge.turns[carrier].across / length;
      touch.turn_weights.fill(-0.25 * about);
      touch.turn_weights[a] += (1. - share) * about + across;
      touch.turn_weights[b] += share * about - across;
      double most = 0.;
      for (const double weight : touch.turn_weights)
        most = std::max(most, std::abs(weight));
      if (!(most <= largest))
        for (double &weight : touch.turn_weights)
          weight = most < INFINITY ? weight * largest / most : 0.;
    }

    using Touches = std::vector<TouchRecord>::iterator;

    /// The rate of a ridge's depth is the mean of what its facets make of it, whose turns are in each twice.
    void share_rate(TouchRecord &one, TouchRecord &other)
    {
      const double further = 0.5 * (other.velocity - one.velocity).dot(one.normal) / one.normal.squaredNorm();
      one.velocity += further * one.normal;
      other.velocity -= further * one.normal;
      one.is_half = true;
    }

    /// The touches of one point at one place: on a facet, or on both of a ridge, whose turns leave no moment together.
    void complete(const FacetsView &facets, const bool has_friction, const Touches begin, const Touches end)
    {
      Point3 left_over = Point3::Zero();
      for (Touches touch = begin; touch != end; ++touch)
        if (touch->is_edge)
          left_over += left_over_of(facets, *touch) / (end - begin);
      for (Touches touch = begin; touch != end; ++touch)
        {
          touch->left_over = left_over;
          touch->loads     = touch->weights;
          if (has_friction || touch->is_oblique)
            add_spin(facets, has_friction, *touch);
        }
      if (end - begin == 2)
        share_rate(*begin, *(begin + 1));
    }

    /// The facets that carry a touch at an edge, by the block's numbers: the two of a ridge, each a half, as its plane
    /// turns by half of what each turns. None where the edge has become sharp since the last search.
    unsigned int find_carriers(const CandidateBlock &block, const EdgePlace &edge,
                               std::array<std::uint32_t, 2> &carriers)
    {
      unsigned int n = 0;
      for (const std::int32_t facet : edge.facets)
        if (facet >= 0)
          {
            carriers[n] = block.facets.find(static_cast<std::uint32_t>(facet));
            if (carriers[n++] == LocalNumbers::none)
              return 0;
          }
      return n;
    }
  } // namespace

  void record_touches(const NarrowPhase &narrow_phase, const CandidateBlock &block, const PointsView &points,
                      const FacetsView &facets, const bool has_friction, std::vector<TouchRecord> &touches)
  {
    const PairGeometry &pairs = narrow_phase.geometry();
    touches.clear();
    for (const TouchingPair &touch : narrow_phase.touches())
      {
        const std::uint32_t facet  = block.pair_facet[pairs.pair[touch.place]];
        TouchRecord        &record = touches.emplace_back();
        record.normal              = touch.normal;
        record.velocity            = pairs.velocity_of(touch.place);
        record.offset              = pairs.offset_of(touch.place);
        record.weights             = pairs.weights_of(touch.place);
        record.penetration         = touch.penetration;
        record.share               = touch.share;
        record.is_oblique          = touch.is_oblique;
        record.point               = block.points[touch.near];
        record.facet               = block.facets.keys()[facet];
        record.nodes               = block.facet_nodes[facet];
        std::array<std::uint32_t, 2> carriers;
        const unsigned int           n_carriers = find_carriers(block, touch.edge, carriers);
        if (n_carriers == 0 && !has_friction && !touch.is_oblique) // as nearly always: nothing to complete
          {
            record.loads = record.weights;
            continue;
          }
        if (n_carriers == 2)
          touches.push_back(TouchRecord(record)); // a copy: the list may move
        for (unsigned int c = 0; c < n_carriers; ++c)
          {
            TouchRecord &part = touches[touches.size() - n_carriers + c];
            part.nodes        = block.facet_nodes[carriers[c]];
            part.share        = touch.share / n_carriers;
            move_to_edge(points, facets, touch.edge, block.facets.keys()[carriers[c]], part);
            turn_with_facet(facets, touch.edge, c, part);
          }
        complete(facets, has_friction, touches.end() - std::max(1u, n_carriers), touches.end());
      }
  }
} // namespace birdstrike
