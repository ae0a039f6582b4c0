#include <birdstrike/structure/probes/mid_chord.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Places closer than this share of the length are one: where the plane runs through nodes, several edges meet.
    constexpr double coincidence = 1e-9;

    /// Between the normals of a facet and of the line, for the facet to be one of the two faces and not of a rim.
    constexpr double least_cosine = 0.1;

    Point3 point(const std::array<double, 3> &x)
    {
      return {x[0], x[1], x[2]};
    }
  } // namespace

  MidChord::MidChord(const FacetsView &surface, const SpanLine &line, const std::vector<std::uint32_t> &blades)
    : surface(surface)
    , blades(blades)
    , root(point(line.root))
    , along((point(line.tip) - root).normalized())
    , normal(point(line.normal))
    , across(along.cross(normal).normalized())
    , length((point(line.tip) - root).norm())
  {
    const std::vector<Crossing> upper = cut_face(1.);
    const std::vector<Crossing> lower = surface.two_sided ? std::vector<Crossing>() : cut_face(-1.);
    for (const Crossing &here : upper)
      {
        Station station{{here.ends[0], here.ends[1]}, 0.};
        if (lower.size() > 1)
          {
            const auto   beyond = std::find_if(lower.begin() + 1, lower.end() - 1,
                                               [&](const Crossing &other) { return other.span >= here.span; });
            const auto  &before = *(beyond - 1);
            const double share =
              std::clamp((here.span - before.span) / (beyond->span - before.span), 0., 1.); // of `beyond`
            for (Term &term : station.terms)
              term.weight *= 0.5;
            for (const int end : {0, 1})
              {
                station.terms.push_back({before.ends[end].node, 0.5 * (1. - share) * before.ends[end].weight});
                station.terms.push_back({beyond->ends[end].node, 0.5 * share * beyond->ends[end].weight});
              }
          }
        station.reference = height(station.terms);
        span.push_back(here.span);
        stations.push_back(std::move(station));
      }
  }

  Point3 MidChord::node(const std::uint32_t n) const
  {
    const double *x = surface.position + 3 * static_cast<std::size_t>(n);
    return {x[0], x[1], x[2]};
  }

  double MidChord::height(const std::vector<Term> &terms) const
  {
    double sum = 0.;
    for (const Term &term : terms)
      sum += term.weight * node(term.node).dot(normal);
    return sum;
  }

  MidChord::Crossing MidChord::cross(const std::uint32_t a, const std::uint32_t b) const
  {
    const double at_a = (node(a) - root).dot(across), at_b = (node(b) - root).dot(across);
    const double share = std::clamp(at_a / (at_a - at_b), 0., 1.); // of b
    const Point3 place = (1. - share) * node(a) + share * node(b);
    return {(place - root).dot(along), {{{a, 1. - share}, {b, share}}}};
  }

  std::vector<MidChord::Crossing> MidChord::cut_face(const double side) const
  {
    // Nodes in the plane belong to its emptier side, so that half a blade, which ends at the plane, is cut there too.
    const double tolerance = coincidence * length;
    const auto   offset    = [&](const std::uint32_t n) { return (node(n) - root).dot(across); };
    bool         has_above = false;
    for (std::size_t n = 0; n < surface.n_nodes; ++n)
      has_above = has_above || offset(static_cast<std::uint32_t>(n)) > tolerance;
    const auto is_above = [&](const std::uint32_t n) { return offset(n) > (has_above ? tolerance : -tolerance); };

    std::vector<Crossing> crossings;
    for (std::size_t f = 0; f < surface.n_facets; ++f)
      {
        if (!blades.empty() && blades[f] > 0)
          continue;
        const auto  &c      = surface.nodes[f];
        const Point3 area   = (node(c[2]) - node(c[0])).cross(node(c[3]) - node(c[1]));
        const double cosine = area.dot(normal); // of a shell both faces are one, however it lists its nodes
        if ((surface.two_sided ? std::abs(cosine) : side * cosine) <= least_cosine * area.norm())
          continue;
        for (unsigned int k = 0; k < 4; ++k)
          if (const std::uint32_t a = c[k], b = c[(k + 1) % 4]; is_above(a) != is_above(b))
            crossings.push_back(cross(a, b));
      }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing &a, const Crossing &b) { return a.span < b.span; });
    crossings.erase(std::unique(crossings.begin(), crossings.end(),
                                [&](const Crossing &a, const Crossing &b) { return b.span - a.span < tolerance; }),
                    crossings.end());
    return crossings;
  }

  const std::vector<double> &MidChord::span_position() const
  {
    return span;
  }

  void MidChord::compute_deflection(std::vector<double> &deflection) const
  {
    deflection.resize(stations.size());
    for (std::size_t k = 0; k < stations.size(); ++k)
      deflection[k] = height(stations[k].terms) - stations[k].reference;
  }
} // namespace birdstrike
