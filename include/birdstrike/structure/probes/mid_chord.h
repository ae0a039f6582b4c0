#pragma once

#include <birdstrike/core/contact_views.h>
#include <birdstrike/core/number.h>
#include <birdstrike/structure/reports.h>

#include <vector>

namespace birdstrike
{
  /// The mid-chord line of a blade as a beam axis: where the surface that the blade offers to contact is cut by the
  /// plane through the middles of root and tip that contains the normal at the tip. Its stations are the facet edges
  /// that the plane crosses. It serves every kind of blade: of a closed skin (one-sided facets) both faces are cut, and
  /// a station takes the mean of the face at +normal and the point of the other face at the same span.
  ///
  /// The line is that of a blade with a straight stacking line and less than 84 degrees of twist between root and tip;
  /// any other blade is cut where the plane meets it. Costs a few multiplications a station; finds no facets anew.
  class MidChord
  {
  public:
    /// The surface must be undeformed, and outlive this object.
    /// `blades`: of each facet of a row, which is cut where it is 0.
    MidChord(const FacetsView &surface, const SpanLine &line, const std::vector<std::uint32_t> &blades = {});

    /// m from the root along the straight line to the tip, ascending; empty if the plane misses the surface.
    const std::vector<double> &span_position() const;

    /// Displacement along the normal (m) at the present positions of the nodes, into one value a station.
    void compute_deflection(std::vector<double> &deflection) const;

  private:
    struct Term
    {
      std::uint32_t node;
      double        weight;
    };
    struct Crossing
    {
      double              span; ///< m
      std::array<Term, 2> ends;
    };
    struct Station
    {
      std::vector<Term> terms;
      double            reference; ///< m, of the undeformed place along the normal
    };

    FacetsView                 surface;
    std::vector<std::uint32_t> blades;
    Point3                     root, along, normal, across; ///< across: unit normal of the cutting plane
    double                     length;
    std::vector<double>        span;
    std::vector<Station>       stations;

    std::vector<Crossing> cut_face(double side) const;
    Crossing              cross(std::uint32_t a, std::uint32_t b) const;
    Point3                node(std::uint32_t n) const;
    double                height(const std::vector<Term> &terms) const;
  };
} // namespace birdstrike
