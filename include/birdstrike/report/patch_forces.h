#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>
#include <birdstrike/structure/histories.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace birdstrike
{
  /// Contact forces on parts of the surface (Output/Histories/Patches): those facets whose undeformed centre lies in a
  /// ball or a box. A node counts with the share that they have of the area of its facets, so that patches which cover
  /// the surface without overlap sum up to the whole contact force:
  ///   F = sum_n w_n f_n,   pressure = |sum_n w_n f_n . n_n| / A,   impulse = integral of F,
  /// n_n the mean normal of the node's facets in the patch, A the patch's area, of the present surface; the impulse by
  /// the trapezoidal rule over every evaluation of contact, as the half kicks give it to the blade. A node inside of
  /// bricks, on no facet until erosion bares it, counts whole where it lies in the ball or box itself (but in no
  /// blade's patch of a row); n_n and A stay those of the first facets.
  ///
  /// Of a shell each facet stands for both of its sides. The skin of bricks has two facets there, which look opposite
  /// ways: as the undeformed normals say, each facet of a patch is on one side or the other of the axis that most of
  /// its area faces, or of the rim between them (more than 60 degrees off the axis). Normals n_n are then those of the
  /// one side, turned round on the other, without the rim's, and A is the area of the larger side. So both kinds give
  /// the pressure of a strike from one side, and of strikes from both sides by how much one exceeds the other.
  class PatchForces final : public HistoryTable
  {
  public:
    /// Of the undeformed surface, whose nodes stay where they are in memory. Throws InputError for what cannot be read,
    /// a patch without a facet, and one that a plane of symmetry cuts but is not its own image.
    /// Of a row, each blade is a patch of its own, "blade_1" and so on: `blades` of each facet, and the place of each.
    PatchForces(const std::string &requests, const FacetsView &surface, const std::vector<std::uint32_t> &blades = {},
                const std::vector<unsigned int> &places = {});

    /// After each evaluation of contact; `step` (s) leads to it from the one before, of which there is none at first.
    void update(const NodeForces &forces, double step);
    void start_row(); ///< of the peaks

    void fill(std::span<double> row) const override;
    void archive(Archive &archive) override;

  private:
    struct Weighted
    {
      std::uint32_t node;
      double        weight;
      bool          is_on_plane; ///< of symmetry
    };
    struct Facet
    {
      std::array<std::uint32_t, 4> places; ///< of its nodes, among the patch's
      double                       side;   ///< 1, -1, or 0 on the rim
    };
    struct Patch
    {
      std::vector<Facet>    facets;
      std::vector<Weighted> nodes;
      std::vector<double>   forces; ///< N, [nodes][3], weighted: of the present evaluation
      SymmetryPlane         plane;  ///< to the whole patch
      Point3                force = Point3::Zero(), impulse = Point3::Zero(); ///< N, N s
      double                peak = 0.;                                        ///< N, since the last row
    };
    template <class Holds> ///< holds(facet, its middle); `inside`, of nodes on no facet: none are held without it
    void   add(const std::string &name, const FacetsView &surface, const Holds &holds,
               const std::function<bool(const Point3 &)> &inside = {});
    void   add_columns(const std::string &name, std::size_t n_facets);
    void   find_sides(Patch &patch) const;
    Point3 area_vector(const Patch &patch, const Facet &facet) const; ///< m^2, present
    double pressure(const Patch &patch) const;                        ///< Pa

    const double      *position; ///< [n_nodes][3], m
    std::vector<Patch> patches;
    bool               is_first = true;
  };
} // namespace birdstrike
