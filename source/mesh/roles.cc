#include <birdstrike/mesh/roles.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    struct SideGeometry
    {
      double size;   ///< m or m^2
      Point3 middle; ///< m
      Point3 off;    ///< of a shell inwards, of a solid the area vector outwards, m^2
      double weight; ///< in the mean over an end
      Point3 normal; ///< of the blade at this side
    };

    /// Of the surface as the mesh has it: of a solid its cells' third axis.
    Point3 normal_of(const SurfaceMesh &mesh, const std::size_t cell)
    {
      return mesh.area_vector(cell).normalized();
    }
    Point3 normal_of(const VolumeMesh &mesh, const std::size_t cell)
    {
      Point3 third_axis = Point3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        third_axis += mesh.node(mesh.cells[cell][k + 4]) - mesh.node(mesh.cells[cell][k]);
      return (0.25 * third_axis).normalized();
    }

    /// Of n candidates of the described blade of a row that whose place is nearest; n without any.
    template <class IsCandidate, class Place>
    std::size_t find_nearest(const std::size_t n, const Point3 &x, const IsCandidate &is_candidate, const Place &place)
    {
      std::size_t nearest  = n;
      double      smallest = INFINITY;
      for (std::size_t k = 0; k < n; ++k)
        if (is_candidate(k))
          if (const double d = (place(k) - x).squaredNorm(); d < smallest)
            {
              smallest = d;
              nearest  = k;
            }
      return nearest;
    }

    /// Whether a normal at the end of the blade that runs with the mesh's looks at the struck side.
    template <int dim>
    bool looks_at_struck_side(const BladeMesh<dim> &mesh, const Point3 &at_end, const Approach &approach)
    {
      if (approach.velocity.squaredNorm() == 0.)
        return looks_at_strike(at_end, approach.velocity);
      bool runs_through = true;
      if constexpr (dim == 3)
        runs_through = mesh.layers > 0;
      const auto is_described = [&](const std::size_t cell) { return mesh.blade_of(cell) == 0; };
      if (runs_through)
        {
          const std::size_t cell = find_nearest(mesh.cells.size(), approach.place, is_described,
                                                [&](const std::size_t c) { return mesh.centroid(c); });
          return looks_at_strike(normal_of(mesh, cell), approach.velocity);
        }
      if constexpr (dim == 3)
        {
          constexpr double least_sine = 0.01; // of the angle to a face that is struck, as in looks_at_strike
          const auto outward = [&](const std::size_t f) { return area_vector(mesh, mesh.boundary[f]).normalized(); };
          const std::size_t face = find_nearest(
            mesh.boundary.size(), approach.place,
            [&](const std::size_t f) {
              return is_described(mesh.boundary[f].cell) &&
                     outward(f).dot(approach.velocity) < -least_sine * approach.velocity.norm();
            },
            [&](const std::size_t f) { return middle(mesh, mesh.boundary[f]); });
          if (face < mesh.boundary.size())
            if (const double with = -outward(face).dot(at_end); std::abs(with) > least_sine)
              return with < 0.;
        }
      return looks_at_strike(at_end, approach.velocity);
    }

    SideGeometry geometry_of(const SurfaceMesh &mesh, const SurfaceMesh::BoundarySide &edge, const SpanEnd end)
    {
      const Point3 a = mesh.node(edge.nodes[0]), b = mesh.node(edge.nodes[1]), middle = 0.5 * (a + b);
      const Point3 area   = mesh.area_vector(edge.cell);
      const double length = (b - a).norm();
      if (end == SpanEnd::tip)
        return {length, middle, mesh.centroid(edge.cell) - middle, 1., area};
      return {length, middle, inwards(mesh, edge), length, area.normalized()};
    }

    SideGeometry geometry_of(const VolumeMesh &mesh, const VolumeMesh::BoundarySide &face, SpanEnd)
    {
      const Point3 outward = area_vector(mesh, face);
      return {outward.norm(), middle(mesh, face), outward, outward.norm(), normal_of(mesh, face.cell)};
    }

    /// The thin principal direction of faces about their centroid: the second of three by second moment, after the one
    /// out of their plane.
    Point3 thin_axis(const VolumeMesh &mesh, const std::vector<std::size_t> &faces, const Point3 &centroid)
    {
      Matrix3<double> moment = Matrix3<double>::Zero();
      for (const std::size_t f : faces)
        for (const std::uint32_t n : mesh.boundary[f].nodes)
          {
            const Point3 arm = mesh.node(n) - centroid;
            moment += area_vector(mesh, mesh.boundary[f]).norm() * arm * arm.transpose();
          }
      if (!mesh.symmetry_nodes.empty()) // with the mirror image
        moment(0, 1) = moment(1, 0) = moment(1, 2) = moment(2, 1) = 0.;
      const Point3 axis = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(moment).eigenvectors().col(1);
      return sign_by_axes(axis, {{2, 1, 0}}) * axis;
    }

    void make_orthonormal(BladeEnd &end)
    {
      end.normal.normalize();
      end.chord = chord_along(end.normal, end.span);
      end.span  = (end.span - end.span.dot(end.normal) * end.normal).normalized();
    }
  } // namespace

  Point3 inwards(const SurfaceMesh &mesh, const SurfaceMesh::BoundarySide &edge)
  {
    const Point3 a = mesh.node(edge.nodes[0]), b = mesh.node(edge.nodes[1]), along = (b - a).normalized();
    const Point3 off = mesh.centroid(edge.cell) - 0.5 * (a + b);
    return (off - off.dot(along) * along).normalized();
  }

  /// Sides and nodes with these ids of one blade of a row, 0 the one that is described.
  template <int dim>
  void BladeEnd::collect(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &ids, const std::uint32_t blade)
  {
    nodes = mesh.nodes_on(ids);
    if (!mesh.blades.empty())
      {
        std::vector<bool> is_on_it(mesh.nodes.size(), false);
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
          for (const std::uint32_t n : mesh.cells[cell])
            is_on_it[n] = is_on_it[n] || mesh.blade_of(cell) == blade;
        std::erase_if(nodes, [&](const std::uint32_t n) { return !is_on_it[n]; });
      }
    sides.clear();
    for (std::size_t s = 0; s < mesh.boundary.size(); ++s)
      if (const auto &side = mesh.boundary[s];
          mesh.blade_of(side.cell) == blade && std::find(ids.begin(), ids.end(), side.id) != ids.end())
        sides.push_back(s);
  }

  template <int dim>
  BladeEnd BladeEnd::of_blade(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &ids,
                              const std::uint32_t blade, const Matrix3<double> &R, const Point3 &centre) const
  {
    BladeEnd other = *this;
    if (!is_present())
      return other;
    other.collect(mesh, ids, blade);
    other.middle   = centre + R * (middle - centre);
    other.centroid = centre + R * (centroid - centre);
    for (Point3 *axis : {&other.span, &other.chord, &other.normal})
      *axis = R * *axis;
    return other;
  }

  template <int dim>
  BladeEnd::BladeEnd(const BladeMesh<dim> &mesh, const SpanEnd end, const std::vector<unsigned int> &ids,
                     const std::vector<double> &stiffness)
  {
    collect(mesh, ids, 0);
    double size = 0., carried = 0., weight = 0.;
    for (const std::size_t s : sides)
      {
        const SideGeometry g = geometry_of(mesh, mesh.boundary[s], end);
        const double       c = end == SpanEnd::root && !stiffness.empty() ? stiffness[mesh.boundary[s].cell] : 1.;
        size += g.size;
        carried += c * g.size;
        middle += g.size * g.middle;
        centroid += c * g.size * g.middle;
        span += c * (dim == 2 ? g.weight : 1.) * g.off;
        normal += c * g.weight * g.normal;
        weight += c * g.weight * g.normal.norm();
      }
    middle /= size;
    centroid /= carried;
    if (!mesh.symmetry_nodes.empty()) // of the whole
      middle[1] = centroid[1] = span[1] = normal[1] = 0.;
    if constexpr (dim == 3)
      if (mesh.layers == 0 && !sides.empty())
        normal = weight * thin_axis(mesh, sides, middle);
    if (sides.empty() || span.norm() < 1e-6 * carried || normal.norm() < 1e-6 * weight)
      {
        *this = {}; // nothing here, or all around: no single end to speak of
        return;
      }
    if constexpr (dim == 3) // both are sums over areas, this span outwards
      {
        normal.normalize();
        span = -span.normalized();
      }
    make_orthonormal(*this);
  }

  template <int dim>
  BladeRoles::BladeRoles(const BladeMesh<dim> &mesh, const std::vector<unsigned int> &root_ids,
                         const std::vector<unsigned int> &tip_ids, const Approach &approach,
                         const std::vector<double> &stiffness)
    : root(mesh, SpanEnd::root, root_ids, stiffness), tip(mesh, SpanEnd::tip, tip_ids)
  {
    bool runs_through = true;
    if constexpr (dim == 3)
      runs_through = mesh.layers > 0;
    if (!runs_through && root.normal.dot(tip.normal) < 0.)
      root.turn();
    if (looks_at_struck_side(mesh, tip.is_present() ? tip.normal : root.normal, approach))
      {
        root.turn();
        tip.turn();
      }
    constexpr double least_cosine = 0.5; // of ends that face one another, not of two edges that meet
    if (root.is_present() && tip.is_present() && root.span.dot(tip.span) < -least_cosine &&
        chord_at(tip.normal, -tip.span).dot(tip.chord) < 0.)
      tip.chord = -tip.chord;
  }

  void BladeRoles::take_row(const MeshParameters::Row &row)
  {
    turns.clear();
    if (row.n_blades == 1)
      return;
    centre = Point3(row.centre.data());
    for (const double angle : row.angles())
      turns.push_back(Eigen::AngleAxisd(angle, Point3(row.axis.data()).normalized()).toRotationMatrix());
  }

  Matrix3<double> BladeRoles::turn_at(const Point3 &point) const
  {
    const auto distance_of = [&](const Matrix3<double> &turn) {
      const Point3 own = centre + turn.transpose() * (point - centre) - root.middle;
      const Point3 way = tip.is_present() ? Point3(tip.middle - root.middle) : root.span;
      return (own - std::clamp(own.dot(way) / way.squaredNorm(), 0., 1.) * way).norm();
    };
    return turns.empty() ? Matrix3<double>(Matrix3<double>::Identity())
                         : *std::ranges::min_element(turns, {}, distance_of);
  }

  Point3 BladeRoles::chord_at(const Point3 &normal, const Point3 &span) const
  {
    if (!root.is_present())
      return chord_along(normal, span);
    // normals are those of one side from root to tip, so that normal, span and chord have one sense of rotation
    const bool is_right_handed = root.normal.cross(root.span).dot(root.chord) > 0.;
    return (is_right_handed ? 1. : -1.) * normal.cross(span).normalized();
  }

  template BladeEnd::BladeEnd(const BladeMesh<2> &, SpanEnd, const std::vector<unsigned int> &,
                              const std::vector<double> &);
  template BladeEnd::BladeEnd(const BladeMesh<3> &, SpanEnd, const std::vector<unsigned int> &,
                              const std::vector<double> &);
  template BladeEnd BladeEnd::of_blade(const BladeMesh<2> &, const std::vector<unsigned int> &, std::uint32_t,
                                       const Matrix3<double> &, const Point3 &) const;
  template BladeEnd BladeEnd::of_blade(const BladeMesh<3> &, const std::vector<unsigned int> &, std::uint32_t,
                                       const Matrix3<double> &, const Point3 &) const;
  template BladeRoles::BladeRoles(const BladeMesh<2> &, const std::vector<unsigned int> &,
                                  const std::vector<unsigned int> &, const Approach &, const std::vector<double> &);
  template BladeRoles::BladeRoles(const BladeMesh<3> &, const std::vector<unsigned int> &,
                                  const std::vector<unsigned int> &, const Approach &, const std::vector<double> &);
} // namespace birdstrike
