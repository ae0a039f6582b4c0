#include "mesh/seams/find_seams.h"
#include "mesh/seams/rim_chain.h"

#include <birdstrike/core/closest_point.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Side = Rim::Side;

    constexpr double joined_within = 1e-3; ///< see find_seams
    const double     cos_30        = std::sqrt(0.75);

    Point3 along(const Rim &rim, const Side &edge)
    {
      return (rim.x[edge.nodes[1]] - rim.x[edge.nodes[0]]).normalized();
    }

    /// Whether a side at a node is the other lip of one that the node lies on.
    bool is_other_lip(const Rim &rim, const Side &side, const Side &at_node)
    {
      const double cosine = side.inward.dot(at_node.inward);
      if (rim.n_corners == 4)
        return cosine < -cos_30;
      return cosine < cos_30 && std::abs(along(rim, side).dot(along(rim, at_node))) > cos_30;
    }

    /// From the nearest point of a side to a node.
    Point3 offset_from(const Rim &rim, const Side &side, const Point3 &p)
    {
      std::array<Point3, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners[k] = rim.x[side.nodes[k]];
      if (rim.n_corners == 4)
        return compute_closest_point(p, corners).offset;
      const Point3 edge = corners[1] - corners[0], from = p - corners[0];
      return from - std::clamp(from.dot(edge) / edge.squaredNorm(), 0., 1.) * edge;
    }

    /// Of a node beside a side without it.
    struct Meeting
    {
      double        size;   ///< m, the smaller of both
      double        gap;    ///< m
      std::uint32_t corner; ///< of the side, the nearest
      double        to_corner;
      bool          is_on_it; ///< hangs, if the mesh goes on there
    };

    Meeting meet(const Rim &rim, const std::uint32_t node, const Side &side)
    {
      Meeting      found{std::min(side.size, rim.size_at(node)), 0., side.nodes[0], INFINITY, false};
      const Point3 offset = offset_from(rim, side, rim.x[node]);
      found.gap           = offset.norm();
      for (unsigned int k = 0; k < rim.n_corners; ++k)
        if (const double d = (rim.x[side.nodes[k]] - rim.x[node]).norm(); d < found.to_corner)
          {
            found.to_corner = d;
            found.corner    = side.nodes[k];
          }
      const double up    = rim.n_corners == 2 ? std::abs(offset.dot(rim.normal[side.nodes[0]])) : 0.;
      const double aside = std::sqrt(std::max(0., found.gap * found.gap - up * up));
      found.is_on_it     = found.gap < (1. - 1e-6) * found.to_corner && aside <= joined_within * found.size &&
                       up <= joined_within * found.size + rim.bow(side);
      return found;
    }

    class Search
    {
    public:
      explicit Search(const Rim &rim) : rim(rim)
      {
      }

      Seams find()
      {
        find_chains();
        find_beside();
        Seams seams;
        for (const auto &[node, side] : hanging)
          seams.hanging.push_back({node, side});
        seams.open = count_open();
        return seams;
      }

    private:
      using Pair = std::array<std::uint32_t, 2>;

      struct Gap
      {
        double width, size; ///< m
      };

      const Rim                             &rim;
      std::map<std::uint32_t, std::uint32_t> hanging; ///< nodes, and a side of each
      std::map<Pair, Gap>                    pairs, beside;

      void find_chains()
      {
        const RimEdges edges(rim);
        for (std::uint32_t s = 0; s < rim.sides.size(); ++s)
          for (unsigned int k = 0; k + (rim.n_corners == 2) < rim.n_corners; ++k)
            {
              const Side &side = rim.sides[s];
              for (const std::uint32_t node :
                   RimChain(rim, edges, side, side.nodes[k], side.nodes[(k + 1) % rim.n_corners]).nodes())
                hanging.emplace(node, s);
            }
      }

      /// Around each side as far as a node may be away and count.
      std::vector<dealii::BoundingBox<3>> make_boxes() const
      {
        std::vector<dealii::BoundingBox<3>> boxes;
        for (const Side &side : rim.sides)
          {
            const double reach = std::max(OpenSeams::near * side.size, joined_within * side.size + rim.bow(side));
            Point3       low = Point3::Constant(INFINITY), high = -low;
            for (const std::uint32_t n : side.nodes)
              {
                low  = low.cwiseMin(rim.x[n]);
                high = high.cwiseMax(rim.x[n]);
              }
            boxes.emplace_back(std::pair(dealii::Point<3>(low[0] - reach, low[1] - reach, low[2] - reach),
                                         dealii::Point<3>(high[0] + reach, high[1] + reach, high[2] + reach)));
          }
        return boxes;
      }

      void find_beside()
      {
        namespace index  = boost::geometry::index;
        const auto boxes = make_boxes();
        const auto tree  = dealii::pack_rtree_of_indices(boxes);
        for (std::uint32_t node = 0; node < rim.x.size(); ++node)
          if (!rim.sides_at(node).empty())
            for (const auto s : tree | index::adaptors::queried(index::intersects(
                                         dealii::Point<3>(rim.x[node][0], rim.x[node][1], rim.x[node][2]))))
              if (!rim.is_of_cell(node, rim.sides[s]))
                look_at(node, static_cast<std::uint32_t>(s));
      }

      void look_at(const std::uint32_t node, const std::uint32_t s)
      {
        const Side   &side  = rim.sides[s];
        const Meeting found = meet(rim, node, side);
        const double  near  = OpenSeams::near * found.size;
        if (found.to_corner <= near)
          {
            const auto [first, second] = std::minmax(node, found.corner);
            pairs.insert({Pair{first, second}, Gap{found.to_corner, found.size}});
            return;
          }
        if ((!found.is_on_it && found.gap > near) ||
            std::ranges::none_of(rim.sides_at(node),
                                 [&](const std::uint32_t other) { return is_other_lip(rim, side, rim.sides[other]); }))
          return;
        if (found.is_on_it)
          hanging.emplace(node, s);
        else
          beside.insert({Pair{node, s}, Gap{found.gap, found.size}});
      }

      static void take_larger(OpenSeams::Found &found, const Gap &gap, const Point3 &at, const Pair &labels)
      {
        ++found.n;
        if (found.n > 1 && gap.width <= found.largest_gap)
          return;
        found.largest_gap = gap.width;
        found.share       = gap.width / gap.size;
        found.at          = at;
        found.labels      = {labels[0], labels[1]};
      }

      OpenSeams count_open() const
      {
        OpenSeams               open;
        std::set<std::uint32_t> is_paired;
        for (const auto &[pair, gap] : pairs)
          {
            take_larger(open.pairs, gap, rim.x[pair[0]], pair);
            is_paired.insert(pair.begin(), pair.end());
          }
        for (const auto &[pair, gap] : beside)
          if (is_paired.insert(pair[0]).second) // each node once
            take_larger(open.beside, gap, rim.x[pair[0]], {pair[0], rim.sides[pair[1]].cell});
        return open;
      }
    };
  } // namespace

  Seams find_seams(const Rim &rim)
  {
    return Search(rim).find();
  }
} // namespace birdstrike
