#pragma once

#include <birdstrike/contact/self_search.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What a node remembers of a facet that it is near: where it came from, and the spring between them.
  struct SelfSide
  {
    std::array<std::uint32_t, 4> nodes{};         ///< of the facet: it may get another number, or its neighbour's turn
    std::int8_t                  sign        = 0; ///< +1 on the normal's side, -1 on the other, 0 beyond a free edge
    bool                         is_known    = false;
    bool                         is_touching = false;
    double                       reference   = 0.;    ///< m, overlap at first sight: carries no force
    double                       depth       = 0.;    ///< m, in the last call; 0 without a force
    double                       stiffness   = 0.;    ///< N/m, of this touch; 0 before it
    std::uint32_t                touch       = 0;     ///< its number + 1 among the touches of the last call; 0: none
    Point3                       outward{0., 0., 0.}; ///< of a one-sided surface: away from it when last seen outside
  };

  /// A node of the surface in touch with a facet of it.
  struct SelfTouch
  {
    std::uint32_t                point = 0;
    unsigned int                 side  = 0;          ///< of the point's two
    std::array<std::uint32_t, 4> nodes{};            ///< of the facet
    std::array<double, 4>        weights{};          ///< of the closest point q
    Point3                       normal{0., 0., 0.}; ///< the direction in which the point is pushed
    double                       penetration = 0.;   ///< d, m, > 0
    double                       share = 0.;      ///< of its force: a second side sets in as it turns against the first
    double force = 0., damping = 0., stored = 0.; ///< N, part of it by the damper, J: set by the law
    bool   goes_on = false;                       ///< in the call after
  };

  /// Finds the touches: which facets a node meets, on which side, how deep.
  ///
  /// A node meets the nearest facet that is not its own neighbourhood, and the nearest that is opposed to it (between
  /// two sheets). Depth is measured from the middle surface,
  ///   d = t_p/2 + t_q/2 - s |p - q|,
  /// with s = -1 once the node has passed to the other side of a sheet, so that it is pushed back to where it came
  /// from; of a solid's skin (half thickness 0) only what was outside before can be inside. What overlaps at first
  /// sight, or once facets between have failed, carries no force, and later only as far as it goes deeper. Nor does
  /// what a depth leaps by where the nearest facet changes, as a fold's rim comes to count: it comes by the node's own
  /// way.
  class SelfTouches
  {
  public:
    /// `is_changed`: the facets are others than in the call before.
    void update(const FacetsView &facets, const SurfaceTopology &topology, const SelfSearch &search, double step,
                bool is_changed);

    void archive(Archive &archive);

    void skip() ///< a call in which nothing is near
    {
      ++call;
    }

    const std::vector<SelfTouch> &touches() const ///< sorted by point
    {
      return found;
    }
    std::vector<SelfTouch> &touches()
    {
      return found;
    }
    SelfSide &side_of(const SelfTouch &touch)
    {
      return records[touch.point].sides[touch.side];
    }
    std::uint64_t n_tested() const ///< closest points computed in this call
    {
      return tested;
    }

  private:
    struct Record
    {
      std::array<SelfSide, 2> sides{};
      std::uint64_t           last_call = 0; // older ones have left
    };
    struct Near
    {
      std::uint32_t         facet;
      ClosestPoint<double>  closest;
      double                distance, height; // m, height along the facet's normal
      Point3                normal;           // of the facet, unit
      std::array<double, 4> weights() const
      {
        return closest.weights;
      }
    };
    struct Scene
    {
      const FacetsView      &facets;
      const SurfaceTopology &topology;
      double                 step, no_distance, known_from; // s, m, m
      bool                   is_changed;
    };

    void        evaluate(const Scene &scene, const SelfSearch::Candidate &candidate, double reach);
    void        decide(const Scene &scene, std::uint32_t point);
    std::size_t nearest(const Scene &scene, const Record &before) const;
    std::size_t opposed(const Scene &scene, std::size_t first, double reach) const;
    bool        is_local_minimum(const Scene &scene, std::size_t place) const;
    SelfSide    remembered(const Scene &scene, const Near &near, const Record &before);
    bool touch(const Scene &scene, std::uint32_t point, const Near &near, const Record &before, SelfTouch &result,
               SelfSide &side);

    std::vector<Record>    records; // [n_nodes]; empty until something comes near
    std::vector<Near>      group;   // of the present point
    std::vector<SelfTouch> found;
    std::uint64_t          call = 0, tested = 0;
  };
} // namespace birdstrike
