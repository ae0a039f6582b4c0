#include <birdstrike/contact/surface_patches.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t most_facets = 32;
    constexpr double      same_way    = 0.9;       // cosine of a facet's normal and the seed's
    constexpr double      widest_cone = M_PI / 3.; // half angle in which a surface does not meet itself

    Point3 unit(const Point3 &a)
    {
      const double length = a.norm();
      return length > 0. ? Point3(a / length) : Point3(0., 0., 0.);
    }

    double angle_between(const Point3 &a, const Point3 &b)
    {
      return std::acos(std::clamp(a.dot(b), -1., 1.));
    }
  } // namespace

  void SurfacePatches::update(const FacetsView &facets, const std::vector<double> &reference, const double range)
  {
    patches.clear();
    owner_of_facet.assign(facets.n_facets, no_patch);
    normals.resize(facets.n_facets);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      normals[f] = unit(compute_area_vector(facet_nodes(facets, f)));
    for (std::uint32_t f = 0; f < facets.n_facets; ++f)
      if (owner_of_facet[f] == no_patch)
        grow(facets, f);
    collect_nodes(facets);
    find_neighbors(facets, reference, range);
    find_edge(facets);
  }

  void SurfacePatches::grow(const FacetsView &facets, const std::uint32_t seed)
  {
    const auto number = static_cast<std::uint32_t>(patches.size());
    auto      &front  = patches.emplace_back().facets; // in the order in which they are reached
    front.push_back(seed);
    owner_of_facet[seed] = number;
    for (std::size_t k = 0; k < front.size(); ++k)
      {
        auto next_ones =
          facets.neighbor[front[k]]; // whichever corner a facet's list begins with, and whichever way round
        std::sort(next_ones.begin(), next_ones.end());
        for (const std::int32_t next : next_ones)
          if (next >= 0 && front.size() < most_facets && owner_of_facet[static_cast<std::size_t>(next)] == no_patch &&
              normals[static_cast<std::size_t>(next)].dot(normals[seed]) > same_way)
            {
              owner_of_facet[static_cast<std::size_t>(next)] = number;
              front.push_back(static_cast<std::uint32_t>(next));
            }
      }
  }

  void SurfacePatches::collect_nodes(const FacetsView &facets)
  {
    owner_of_point.assign(facets.n_nodes, no_patch);
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      {
        Patch &patch = patches[p];
        for (const std::uint32_t f : patch.facets)
          patch.nodes.insert(patch.nodes.end(), facets.nodes[f].begin(), facets.nodes[f].end());
        std::sort(patch.nodes.begin(), patch.nodes.end());
        patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
        for (const std::uint32_t node : patch.nodes)
          if (owner_of_point[node] == no_patch)
            {
              owner_of_point[node] = p;
              patch.points.push_back(node);
            }
      }
    has_loose = std::find(owner_of_point.begin(), owner_of_point.end(), no_patch) != owner_of_point.end();
  }

  void SurfacePatches::find_neighbors(const FacetsView &facets, const std::vector<double> &reference,
                                      const double range)
  {
    std::vector<std::vector<std::uint32_t>> of_node(facets.n_nodes), adjacent(patches.size());
    std::vector<Box>                        boxes(patches.size());
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (const std::uint32_t node : patches[p].nodes)
        {
          for (const std::uint32_t other : of_node[node])
            {
              adjacent[p].push_back(other);
              adjacent[other].push_back(p);
            }
          of_node[node].push_back(p);
          boxes[p].add(&reference[3 * node]);
        }
    for (auto &list : adjacent)
      {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
      }
    // boxes alone would leave it to the axes which patches are neighbours
    const auto are_near = [&](const std::uint32_t a, const std::uint32_t b) {
      if (boxes[a].separation(boxes[b]) > range)
        return false;
      for (const std::uint32_t i : patches[a].nodes)
        for (const std::uint32_t j : patches[b].nodes)
          if ((Point3(&reference[3 * i]) - Point3(&reference[3 * j])).squaredNorm() <= range * range)
            return true;
      return false;
    };
    std::vector<std::uint32_t> seen(patches.size(), no_patch);
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      {
        std::vector<std::uint32_t> found{p};
        seen[p] = p;
        for (std::size_t k = 0; k < found.size(); ++k)
          for (const std::uint32_t next : adjacent[found[k]])
            if (seen[next] != p && (found[k] == p || are_near(p, next)))
              {
                seen[next] = p;
                found.push_back(next);
              }
        std::sort(found.begin(), found.end());
        patches[p].neighbors = std::move(found);
      }
  }

  void SurfacePatches::find_edge(const FacetsView &facets)
  {
    // of as many as a patch has, but not of a patch: how it has grown must not matter
    std::vector<double> areas(facets.n_facets);
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      areas[f] = compute_area_vector(facet_nodes(facets, f)).norm();
    std::sort(areas.begin(), areas.end());
    areas.resize(std::min(areas.size(), most_facets));
    edge = areas.empty()
             ? 1e300
             : std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.) / static_cast<double>(areas.size()));
  }

  void SurfacePatches::look(const FacetsView &facets)
  {
    facet_boxes.assign(facets.n_facets, Box());
    for (Patch &patch : patches)
      {
        patch.box = Box();
        Point3 sum(0., 0., 0.);
        for (const std::uint32_t f : patch.facets)
          {
            for (const std::uint32_t node : facets.nodes[f])
              facet_boxes[f].add(facets.position + 3 * node);
            patch.box.add(facet_boxes[f]);
            normals[f] = unit(compute_area_vector(facet_nodes(facets, f)));
            sum += normals[f];
          }
        patch.normal    = unit(sum);
        double smallest = 1.;
        for (const std::uint32_t f : patch.facets)
          smallest = std::min(smallest, normals[f].dot(patch.normal));
        patch.half_angle = std::acos(std::clamp(smallest, -1., 1.));
      }
  }

  void SurfacePatches::find_close(const FacetsView &facets, const double reach, std::vector<Pair> always)
  {
    close.clear();
    flat.clear();
    std::sort(always.begin(), always.end());
    Box all;
    for (const Patch &patch : patches)
      all.add(patch.box);
    unsigned int axis = 0; // swept along the longest side
    for (unsigned int d = 1; d < 3; ++d)
      if (all.high[d] - all.low[d] > all.high[axis] - all.low[axis])
        axis = d;
    order.resize(patches.size());
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      order[p] = p;
    std::sort(order.begin(), order.end(), [&](const std::uint32_t a, const std::uint32_t b) {
      const double low_a = patches[a].box.low[axis], low_b = patches[b].box.low[axis];
      return low_a != low_b ? low_a < low_b : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i; j < order.size(); ++j)
        {
          const Patch &one = patches[order[i]], &other = patches[order[j]];
          if (other.box.low[axis] > one.box.high[axis] + reach)
            break;
          if (one.box.separation(other.box) > reach)
            continue;
          const Pair pair{{std::min(order[i], order[j]), std::max(order[i], order[j])}};
          if (std::binary_search(always.begin(), always.end(), pair) || may_meet(facets, pair[0], pair[1]))
            close.push_back(pair);
          else if (are_neighbors(pair[0], pair[1]))
            flat.push_back(pair);
        }
    std::sort(close.begin(), close.end());
    std::sort(flat.begin(), flat.end());
  }

  bool SurfacePatches::may_meet(const FacetsView &facets, const std::uint32_t a, const std::uint32_t b) const
  {
    const Patch &one = patches[a], &other = patches[b];
    if (are_neighbors(a, b))
      return cone_angle(one, other) > widest_cone;
    return facets.two_sided || !(is_behind(facets, one, other) && is_behind(facets, other, one));
  }

  bool SurfacePatches::are_neighbors(const std::uint32_t a, const std::uint32_t b) const
  {
    return std::binary_search(patches[a].neighbors.begin(), patches[a].neighbors.end(), b);
  }

  double SurfacePatches::cone_angle(const Patch &one, const Patch &other) const
  {
    return std::max({one.half_angle, other.half_angle,
                     0.5 * (angle_between(one.normal, other.normal) + one.half_angle + other.half_angle)});
  }

  bool SurfacePatches::is_behind(const FacetsView &facets, const Patch &one, const Patch &other) const
  {
    const auto height = [&](const std::uint32_t node) {
      return one.normal.dot(Eigen::Map<const Point3>(facets.position + 3 * node));
    };
    double lowest = 1e300, highest = -1e300;
    for (const std::uint32_t node : one.nodes)
      lowest = std::min(lowest, height(node));
    for (const std::uint32_t node : other.nodes)
      highest = std::max(highest, height(node));
    return highest <= lowest;
  }
} // namespace birdstrike
