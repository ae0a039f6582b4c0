#include "structure/nodes/supports.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/blade_shape.h>
#include <birdstrike/mesh/roles.h>
#include <birdstrike/structure/surface_map.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace birdstrike
{
  namespace
  {
    class BuiltInMap final : public SurfaceMap
    {
    public:
      explicit BuiltInMap(const MeshParameters &parameters) : shape(parameters)
      {
      }
      Point3 position(const double span, const double chord) const override
      {
        return shape.position(span, chord);
      }
      Point3 chord_direction(const double span) const override
      {
        return {0., std::cos(shape.stagger(span)), std::sin(shape.stagger(span))};
      }
      std::array<double, 2> shares(const Point3 &point) const override
      {
        return shape.coordinates(point.data());
      }
      Point3 normal(const double span, const double chord) const override
      {
        return shape.normal(span, chord);
      }

    private:
      BladeShape shape;
    };

    /// Where a plane cuts the line between two points, whose heights over it are given.
    void add_crossing(const Point3 &a, const double at_a, const Point3 &b, const double at_b,
                      std::vector<Point3> &points)
    {
      if ((at_a < 0.) != (at_b < 0.))
        points.push_back(a + at_a / (at_a - at_b) * (b - a));
    }

    class MapOfCuts final : public SurfaceMap
    {
    public:
      MapOfCuts(const SurfaceMesh &surface, const BladeRoles &roles)
        : root(roles.root.middle), span_line(roles.tip.middle - root)
      {
        for (const auto &cell : surface.cells)
          facets.push_back(
            {surface.node(cell[0]), surface.node(cell[1]), surface.node(cell[2]), surface.node(cell[3])});
        constexpr std::size_t n_cuts = 65; // a degree from one to the next where sections turn as those of blades do
        Point3                along  = roles.root.chord;
        for (std::size_t k = 0; k < n_cuts; ++k)
          {
            if (const std::vector<Point3> line = find_line(double(k) / (n_cuts - 1)); !line.empty())
              along = long_axis(line, along);
            chords.push_back(along);
          }
      }

      Point3 position(const double span, const double chord) const override
      {
        const Section       section = cut(span);
        const Point3        along   = section.trailing - section.leading;
        const double        height  = along.dot(section.leading) + within(chord) * along.squaredNorm();
        std::vector<Point3> points;
        for (std::size_t k = 0; k + 1 < section.line.size(); k += 2)
          add_crossing(section.line[k], section.line[k].dot(along) - height, section.line[k + 1],
                       section.line[k + 1].dot(along) - height, points);
        if (points.empty())
          return section.leading + chord * along;
        Point3 sum = Point3::Zero();
        for (const Point3 &p : points)
          sum += p;
        return sum / static_cast<double>(points.size());
      }

      Point3 chord_direction(const double span) const override
      {
        const Section section = cut(span);
        return (section.trailing - section.leading).normalized();
      }

      std::array<double, 2> shares(const Point3 &point) const override
      {
        const double  span    = std::clamp((point - root).dot(span_line) / span_line.squaredNorm(), 0., 1.);
        const Section section = cut(span);
        const Point3  along   = section.trailing - section.leading;
        return {{span, std::clamp((point - section.leading).dot(along) / along.squaredNorm(), 0., 1.)}};
      }

      Point3 normal(const double span, const double chord) const override
      {
        static constexpr double step        = 0.02; // coarser than round-off, finer than elements of a usable mesh
        const auto              from        = [](const double share) { return std::clamp(share, step, 1. - step); };
        const Point3            along_span  = position(from(span) + step, chord) - position(from(span) - step, chord);
        const Point3            along_chord = position(span, from(chord) + step) - position(span, from(chord) - step);
        return along_span.cross(along_chord).normalized();
      }

    private:
      struct Section
      {
        std::vector<Point3> line; ///< two ends of each piece
        Point3              leading, trailing;
      };

      Point3                             root, span_line;
      std::vector<std::array<Point3, 4>> facets;
      std::vector<Point3> chords; ///< of cuts at equal distances from root to tip, as that of the root runs

      /// The ends themselves may lie a hair beside their plane.
      static double within(const double share)
      {
        return std::clamp(share, 1e-6, 1. - 1e-6);
      }

      /// The direction in which the pieces of a cut are longest, the principal one of their second moment, to the side
      /// of another.
      static Point3 long_axis(const std::vector<Point3> &line, const Point3 &along)
      {
        const auto each_piece = [&line](const auto &f) {
          for (std::size_t k = 0; k < line.size(); k += 2)
            f(Point3(0.5 * (line[k] + line[k + 1])), (line[k + 1] - line[k]).norm());
        };
        Point3 sum    = Point3::Zero();
        double length = 0.;
        each_piece([&](const Point3 &middle, const double size) {
          sum += size * middle;
          length += size;
        });
        Matrix3<double> moment = Matrix3<double>::Zero();
        each_piece([&](const Point3 &middle, const double size) {
          const Point3 arm = middle - sum / length;
          moment += size * arm * arm.transpose();
        });
        const Point3 axis = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(moment).eigenvectors().col(2);
        return axis.dot(along) < 0. ? Point3(-axis) : axis;
      }

      /// The middle of what of a cut lies farthest along a direction: a point, or the end of a body.
      static Point3 find_edge(const std::vector<Point3> &line, const Point3 &along)
      {
        double most = -INFINITY, least = INFINITY;
        for (const Point3 &p : line)
          {
            most  = std::max(most, along.dot(p));
            least = std::min(least, along.dot(p));
          }
        const double tolerance = 1e-3 * (most - least);
        Point3       low = Point3::Constant(INFINITY), high = -low;
        for (const Point3 &p : line)
          if (along.dot(p) > most - tolerance)
            {
              low  = low.cwiseMin(p);
              high = high.cwiseMax(p);
            }
        return 0.5 * (low + high);
      }

      /// Two ends of each piece of a cut.
      std::vector<Point3> find_line(const double span) const
      {
        const Point3        through = root + within(span) * span_line;
        const auto          height  = [&](const Point3 &p) { return (p - through).dot(span_line); };
        std::vector<Point3> line;
        for (const auto &corner : facets)
          for (const std::array<int, 3> &triangle : {std::array<int, 3>{{0, 1, 2}}, {{0, 2, 3}}})
            {
              std::vector<Point3> ends;
              for (int k = 0; k < 3; ++k)
                {
                  const Point3 &a = corner[triangle[k]], &b = corner[triangle[(k + 1) % 3]];
                  add_crossing(a, height(a), b, height(b), ends);
                }
              if (ends.size() == 2)
                line.insert(line.end(), ends.begin(), ends.end());
            }
        return line;
      }

      Section cut(const double span) const
      {
        Section section;
        section.line = find_line(span);
        if (section.line.empty())
          throw InputError(
            "Bird/Aim span fraction: the mesh of the blade has no section there, square to the line from "
            "the middle of its root to the middle of its tip.\nGive Bird/Aim point.");
        const double last = static_cast<double>(chords.size() - 1);
        const Point3 axis = long_axis(section.line, chords[std::lround(within(span) * last)]);
        section.leading   = find_edge(section.line, -axis);
        section.trailing  = find_edge(section.line, axis);
        return section;
      }
    };

    template <int dim>
    std::unique_ptr<const SurfaceMap> make_map_of_cuts(const BladeParameters &parameters)
    {
      const BladeMesh<dim> mesh(parameters);
      const Supports       supports(parameters.supports, mesh);
      const BladeRoles     roles(mesh, supports.root_ids, supports.tip_ids, {});
      if (!roles.root.is_present() || !roles.tip.is_present())
        return nullptr;
      return std::make_unique<MapOfCuts>(mesh.surface(), roles);
    }
  } // namespace

  std::unique_ptr<const SurfaceMap> make_surface_map(const BladeParameters &parameters)
  {
    if (parameters.kind == BladeKind::none ||
        (parameters.kind == BladeKind::rigid && parameters.rigid.surface == RigidSurface::rectangle))
      return nullptr;
    if (parameters.mesh.generator != MeshGenerator::file)
      return std::make_unique<BuiltInMap>(parameters.mesh);
    if (parameters.is_halved)
      return nullptr;
    return parameters.kind == BladeKind::solid ? make_map_of_cuts<3>(parameters) : make_map_of_cuts<2>(parameters);
  }
} // namespace birdstrike
