#include "mesh/blade_stations.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/roles.h>

#include <algorithm>
#include <limits>
#include <map>

namespace birdstrike
{
  namespace
  {
    using Side  = SurfaceMesh::BoundarySide;
    using Sides = std::vector<Side>;

    [[noreturn]] void refuse(const std::string &what)
    {
      throw InputError(
        "Blade/Thickness/Maximum: " + what +
        ".\nA profile on a mesh from a file needs Supports/Clamped or Hub along the root, Supports/Tip along the "
        "tip, and two free edges from one to the other. Else give Value, By material or Table.");
    }

    double distance(const Point3 &x, const SurfaceMesh &mesh, const Sides &edges)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const Side &edge : edges)
        {
          const Point3 a = mesh.node(edge.nodes[0]), along = mesh.node(edge.nodes[1]) - a;
          const double t = std::clamp((x - a).dot(along) / along.squaredNorm(), 0., 1.);
          smallest       = std::min(smallest, (x - a - t * along).norm());
        }
      return smallest;
    }

    /// The leading or the trailing edge: its points by s.
    class EdgeLine
    {
    public:
      EdgeLine(const Sides &edges, const SurfaceMesh &mesh, const std::vector<std::array<double, 2>> &stations)
      {
        for (const Side &edge : edges)
          for (const std::uint32_t node : edge.nodes)
            points[stations[node][0]] = mesh.node(node);
      }

      Point3 at(const double s) const
      {
        const auto after = points.lower_bound(s);
        if (after == points.begin())
          return after->second;
        const auto before = std::prev(after);
        if (after == points.end())
          return before->second;
        const double t = (s - before->first) / (after->first - before->first);
        return (1. - t) * before->second + t * after->second;
      }

    private:
      std::map<double, Point3> points;
    };

    bool contains(const std::vector<unsigned int> &ids, const unsigned int id)
    {
      return std::find(ids.begin(), ids.end(), id) != ids.end();
    }

    /// Sides that hang together by their nodes, piece by piece.
    std::vector<Sides> pieces_of(const Sides &edges)
    {
      std::map<std::uint32_t, std::vector<std::size_t>> at;
      for (std::size_t e = 0; e < edges.size(); ++e)
        for (const std::uint32_t node : edges[e].nodes)
          at[node].push_back(e);
      std::vector<Sides> pieces;
      std::vector<bool>  seen(edges.size(), false);
      for (std::size_t first = 0; first < edges.size(); ++first)
        if (!seen[first])
          {
            std::vector<std::size_t> reached{first};
            seen[first] = true;
            for (std::size_t k = 0; k < reached.size(); ++k)
              for (const std::uint32_t node : edges[reached[k]].nodes)
                for (const std::size_t other : at[node])
                  if (!seen[other])
                    {
                      seen[other] = true;
                      reached.push_back(other);
                    }
            pieces.emplace_back();
            for (const std::size_t e : reached)
              pieces.back().push_back(edges[e]);
          }
      return pieces;
    }
  } // namespace

  std::vector<std::array<double, 2>> find_stations(const ShellMesh &mesh, const std::vector<unsigned int> &root_ids,
                                                   const std::vector<unsigned int> &tip_ids)
  {
    Sides root, tip, others;
    for (const Side &side : mesh.boundary)
      (contains(root_ids, side.id) ? root : contains(tip_ids, side.id) ? tip : others).push_back(side);
    const BladeEnd end = BladeRoles(mesh, root_ids, tip_ids, {}).tip;
    if (root.empty() || !end.is_present())
      refuse(root.empty() ? "the blade has no root" : "the blade has no tip");
    const std::vector<Sides> free = pieces_of(others);
    if (free.size() != 2)
      refuse("the edges that are neither root nor tip are " + std::to_string(free.size()) +
             (free.size() == 1 ? " line" : " lines"));

    std::vector<std::array<double, 2>> stations;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      {
        const double from_root = distance(mesh.node(n), mesh, root), from_tip = distance(mesh.node(n), mesh, tip);
        stations.push_back({from_root / (from_root + from_tip), 0.});
      }
    EdgeLine leading(free[0], mesh, stations), trailing(free[1], mesh, stations);
    if ((trailing.at(1.) - leading.at(1.)).dot(end.chord) < 0.)
      std::swap(leading, trailing);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      {
        auto &[s, c]       = stations[n];
        const Point3 a     = leading.at(s);
        const Point3 chord = trailing.at(s) - a;
        c                  = std::clamp((mesh.node(n) - a).dot(chord) / chord.squaredNorm(), 0., 1.);
      }
    return stations;
  }
} // namespace birdstrike
