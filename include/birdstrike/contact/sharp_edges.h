#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// How a depth over an edge of facet 0 or 1 falls with the turns of that facet (edge_profile.h): by `about` phi +
  /// `across` eta, m, with the angle phi by which the facet's centre turns about its edge a-b, towards its normal n,
  /// and eta = (u_b - u_a).n/|b - a|.
  struct EdgeTurn
  {
    double about = 0., across = 0.;
  };

  /// A place on an edge: what carries the edge's plane, so that forces on the plane act there.
  struct EdgePlace
  {
    std::array<std::int32_t, 2> facets{{-1, -1}}; ///< at the edge, whose turns the plane follows; -1: none, or one only
    std::array<std::uint32_t, 2> nodes{};         ///< of the edge
    double                       share = 0.;      ///< from the first node (0) to the second (1), and beyond either
    Point3                       offset{0., 0., 0.}; ///< from there to the point, m
    std::array<EdgeTurn, 2>      turns{};            ///< for a force of which each facet carries its part
  };

  /// A point p over or beside a facet, and what a surface without edges would make of it; SharpEdges::cut() corrects
  /// it.
  struct EdgeTouch
  {
    enum class Feature
    {
      face,
      edge_face, ///< of a shell, which has no facets there
      beyond     ///< between the two faces of an edge: nothing is in the way
    };

    Point3 offset{0., 0., 0.};     ///< p - q from the closest point q of the facet, m
    double height         = 0.;    ///< of p above q, with the sign of its side of the surface, m
    double half_thickness = 0.;    ///< at q, m
    double size           = 0.;    ///< V^(1/3), m
    bool   is_beyond      = false; ///< q lies on a free edge
    bool was_on_edge_face = false; ///< in touch with it in the last call; behind it, within the thickness, it still is

    double    overlap = 0.;       ///< in: of a surface without edges; out: of the face. m
    Point3    normal{0., 0., 0.}; ///< likewise, outwards
    Feature   feature    = Feature::face;
    bool      is_oblique = false; ///< the normal does not pass through q
    double    limit      = 1e300; ///< depth below the plane of the edge that bounds the face, m
    Point3    limit_normal{0., 0., 0.};
    EdgePlace place{};     ///< of the plane, and of the edge face, where they are not at q
    EdgeTurn  face_turn{}; ///< of the edge face; those of the plane stand in `place`

    Point3 slope{0., 0., 0.}; ///< in: of a face's half thickness along the surface (thickness_slope.h)
  };

  /// The sharp edges of a surface and what they take off the offset (edge_profile.h): free edges of shells, where the
  /// edge face is as high as the shell is thick, and ridges between faces of a solid's skin. Edges on a plane of
  /// symmetry are none. Facets further than the reach from any edge have nothing to do with it.
  class SharpEdges
  {
  public:
    /// Finds the edges within `reach` of each facet. Done again when facets come and go, and for a skin, whose ridges
    /// sharpen, with every call: every few steps are often enough, for how sharp they are is seen when a point is
    /// there.
    void update(const FacetsView &facets, double reach);

    void archive(Archive &archive);

    bool are_near(const std::uint32_t facet) const
    {
      return first[facet] != first[facet + 1];
    }

    /// The facets at the edges that are near any of some facets.
    void find_facets_at_edges(const std::vector<std::uint32_t> &facets, std::vector<std::uint32_t> &found) const;

    void cut(const FacetsView &facets, std::uint32_t facet, const Point3 &closest, EdgeTouch &touch) const;

  private:
    struct Edge
    {
      std::array<std::uint32_t, 2> nodes;
      std::array<std::int32_t, 2>  facets; // the second is -1 at a free edge
    };
    struct Foot; // of a perpendicular on an edge

    void find_edges(const FacetsView &facets);
    void add_ridge(const FacetsView &facets, std::uint32_t facet, unsigned int side);
    void spread(const FacetsView &facets, double reach);
    bool is_sharp(const FacetsView &facets, const Edge &edge) const; // now
    /// Of two edges that bound what lies around their common corner alike, as those of a plane facet do, and turn with
    /// it otherwise: the one that the point is further beyond, and of a straight rim that of the facet itself.
    static bool is_before(const FacetsView &facets, std::uint32_t facet, const Edge &one, const Edge &other,
                          const Point3 &from_corner, double tied);
    void        cut_rim(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const;
    void        cut_ridge(const FacetsView &facets, const Foot &foot, EdgeTouch &touch) const;

    std::uint64_t              revision    = 0;
    double                     known_reach = -1.;
    std::vector<Edge>          edges;
    std::vector<std::uint32_t> first, near; // edges near facet f: near[first[f]] ...
    std::vector<Point3>        normals;     // [n_facets], unit

    // of spread(), kept so that it allocates nothing
    std::vector<std::array<std::uint32_t, 2>> found; // facet, edge
    std::vector<std::int32_t>                 front;
    std::vector<std::uint32_t>                seen; // [n_facets]
  };
} // namespace birdstrike
