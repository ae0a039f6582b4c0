#include "structure/histories/section_forces.h"
#include "structure/histories/axes.h"
#include <birdstrike/core/errors.h>

#include <Eigen/SVD>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    double size_of(const BladeMesh<2> &mesh, const std::array<std::uint32_t, 2> &side)
    {
      return (mesh.node(side[1]) - mesh.node(side[0])).norm();
    }
    double size_of(const BladeMesh<3> &mesh, const std::array<std::uint32_t, 4> &side)
    {
      return 0.5 * (mesh.node(side[2]) - mesh.node(side[0])).cross(mesh.node(side[3]) - mesh.node(side[1])).norm();
    }

    double cell_size(const SurfaceMesh &mesh, const std::uint32_t cell)
    {
      return mesh.area_vector(cell).norm();
    }
    /// The Jacobian at the middle: what runs from the middles of sides to those across.
    double cell_size(const VolumeMesh &mesh, const std::uint32_t cell)
    {
      Matrix3<double> across = Matrix3<double>::Zero();
      for (unsigned int side = 0; side < 6; ++side)
        for (const std::uint32_t n : mesh.side_nodes(cell, side))
          across.col(side / 2) += (side % 2 == 0 ? -0.25 : 0.25) * mesh.node(n);
      return std::abs(across.determinant());
    }

    Matrix3<double> rows_of(const Point3 &span, const Point3 &chord, const Point3 &normal)
    {
      Matrix3<double> rows;
      rows << span.transpose(), chord.transpose(), normal.transpose();
      return rows;
    }

    /// As the axes of the blade there, but with the span along the way from root to tip.
    Matrix3<double> find_section_axes(const SurfaceMesh &surface, const BladeRoles &roles, const Point3 &at,
                                      const Point3 &along)
    {
      const Matrix3<double> of_blade = find_blade_axes(surface, roles, at, "Output/Histories/Stations");
      const Point3          raw      = of_blade.row(2);
      const Point3          normal   = (raw - raw.dot(along) * along).normalized();
      Point3                chord    = normal.cross(along);
      chord *= chord.dot(of_blade.row(1)) < 0. ? -1. : 1.;
      return rows_of(along, chord, normal);
    }
  } // namespace

  template <int dim>
  SectionCut<dim>::SectionCut(const BladeMesh<dim> &mesh, const BladeRoles &roles, const double station,
                              const SymmetryPlane plane, const std::vector<double> &stiffness)
    : plane(plane)
  {
    const Point3      way = roles.tip.middle - roles.root.middle, along = way.normalized();
    std::vector<bool> is_beyond(mesh.cells.size());
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      is_beyond[cell] = mesh.blade_of(cell) == 0 &&
                        (station == 0. || (mesh.centroid(cell) - roles.root.middle).dot(along) > station * way.norm());
    find_cut(mesh, is_beyond, stiffness);
    if (station > 0. && (cut.empty() || beyond.empty()))
      throw InputError(fmt::format("Output/Histories/Stations: no row of elements ends at {:g} of the span: all lie on "
                                   "one side.\nGive a share farther from root and tip, or finer elements.",
                                   station));
    if (station == 0.)
      {
        beyond   = roles.root.nodes;
        centroid = roles.root.centroid;
        axes     = rows_of(roles.root.span, roles.root.chord, roles.root.normal);
        return;
      }
    centroid = Point3::Zero();
    for (const Weighted &one : cut)
      centroid += one.weight * mesh.node(one.node);
    if (plane.exists())
      centroid[1] = 0.;
    distance = (centroid - roles.root.middle).dot(along);
    axes     = find_section_axes(mesh.surface(), roles, centroid, along);
  }

  template <int dim>
  void SectionCut<dim>::find_cut(const BladeMesh<dim> &mesh, const std::vector<bool> &is_beyond,
                                 const std::vector<double> &stiffness)
  {
    constexpr unsigned int n_sides = 2 * dim;
    std::vector<int>       sides_of(mesh.nodes.size(), 0); // 1: before, 2: beyond, 3: both
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (const std::uint32_t n : mesh.cells[cell])
        sides_of[n] |= is_beyond[cell] ? 2 : 1;
    std::map<std::uint32_t, double> weight;
    double                          total = 0.;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int side = 0; side < n_sides; ++side)
        if (const std::int32_t other = mesh.neighbors[cell][side]; is_beyond[cell] && other >= 0 && !is_beyond[other])
          {
            const auto   nodes = mesh.side_nodes(cell, side);
            const double mean  = stiffness.empty() ? 1. : 0.5 * (stiffness[cell] + stiffness[other]);
            const double size  = mean * size_of(mesh, nodes);
            total += size;
            for (const std::uint32_t n : nodes)
              weight[n] += size / static_cast<double>(nodes.size());
          }
    for (const auto &[node, share] : weight)
      cut.push_back({node, share / total});
    for (std::uint32_t n = 0; n < sides_of.size(); ++n)
      if (sides_of[n] == 2)
        beyond.push_back(n);
    find_shares(mesh, is_beyond);
    std::set<std::uint32_t> near;
    for (const auto &cell : mesh.cells)
      if (std::any_of(cell.begin(), cell.end(), [&](const std::uint32_t n) { return sides_of[n] == 3; }))
        near.insert(cell.begin(), cell.end());
    attached.assign(near.begin(), near.end());
    for (const std::uint32_t n : attached)
      reference.push_back(mesh.node(n));
  }

  template <int dim>
  void SectionCut<dim>::find_shares(const BladeMesh<dim> &mesh, const std::vector<bool> &is_beyond)
  {
    for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (const std::uint32_t n : mesh.cells[cell])
        if (const auto found = std::ranges::lower_bound(cut, n, {}, &Weighted::node);
            found != cut.end() && found->node == n)
          shares.push_back(
            {static_cast<std::size_t>(found - cut.begin()), cell, cell_size(mesh, cell), is_beyond[cell]});
  }

  /// Of what the elements that are left exert on the nodes of the cut, which share belongs to what lies beyond.
  template <int dim>
  std::vector<double> SectionCut<dim>::weights_of_cut(const IsFree &is_failed) const
  {
    std::vector<double> result(cut.size(), 0.), total(cut.size(), 0.);
    for (const Share &share : shares)
      if (!is_failed || !is_failed(share.cell))
        {
          total[share.place] += share.size;
          result[share.place] += share.is_beyond ? share.size : 0.;
        }
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] /= total[k] > 0. ? total[k] : 1.;
    return result;
  }

  template <int dim>
  Matrix3<double> SectionCut<dim>::fit_rotation(const double *position, const IsFree &is_free) const
  {
    // of half a section each node stands for its image, too; on the plane it is its own
    const auto weight_of = [&](const std::size_t k) {
      return is_free && is_free(attached[k]) ? 0. : plane.exists() && reference[k][1] == 0. ? 0.5 : 1.;
    };
    std::size_t n_left = 0;
    double      total  = 0.;
    Point3      before = Point3::Zero(), now = Point3::Zero();
    for (std::size_t k = 0; k < attached.size(); ++k)
      {
        const double w = weight_of(k);
        n_left += w > 0.;
        total += w;
        before += w * reference[k];
        now += w * Point3(position + 3 * attached[k]);
      }
    if (cut.empty() || n_left < 3)
      return Matrix3<double>::Identity();
    before /= total;
    now /= total;
    if (plane.exists())
      before[1] = now[1] = 0.;
    Matrix3<double> covariance = Matrix3<double>::Zero();
    for (std::size_t k = 0; k < attached.size(); ++k)
      {
        const double w = weight_of(k);
        if (w == 0.)
          continue;
        Point3 a = reference[k] - before, b = Point3(position + 3 * attached[k]) - now;
        covariance += w * b * a.transpose();
        if (plane.exists()) // and its image
          {
            a[1] = -a[1];
            b[1] = -b[1];
            covariance += w * b * a.transpose();
          }
      }
    const Eigen::JacobiSVD<Matrix3<double>> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3<double>                         sign = Matrix3<double>::Identity();
    sign(2, 2)                                   = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    return svd.matrixU() * sign * svd.matrixV().transpose();
  }

  template <int dim>
  SectionForces SectionCut<dim>::compute(const double *force, const double *position, const IsFree is_free,
                                         const IsFree is_failed) const
  {
    constexpr unsigned int n_unknowns = BladeMesh<dim>::n_unknowns;
    Point3                 c          = cut.empty() ? centroid : Point3::Zero();
    double                 gone       = 0.; // weight of nodes that fly free: they are no part of the section
    for (const Weighted &one : cut)
      if (is_free && is_free(one.node))
        gone += one.weight;
      else
        c += one.weight * Point3(position + 3 * one.node);
    if (gone > 0.)
      c = gone < 1. - 1e-9 ? Point3(c / (1. - gone)) : centroid;
    if (plane.exists())
      c[1] = 0.;
    SectionForces result{Point3::Zero(), Point3::Zero(), axes * fit_rotation(position, is_free).transpose()};
    const auto    add = [&](const std::uint32_t n, const double weight) {
      const Point3 f(weight * Point3(force + n_unknowns * n));
      result.force += f;
      result.moment += (Point3(position + 3 * n) - c).cross(f);
      if constexpr (n_unknowns == 6)
        result.moment += weight * Point3(force + n_unknowns * n + 3);
    };
    for (const std::uint32_t n : beyond)
      add(n, is_root() ? 1. : -1.);
    const std::vector<double> weights = weights_of_cut(is_failed);
    for (std::size_t k = 0; k < cut.size(); ++k)
      add(cut[k].node, -weights[k]);
    if (plane.exists()) // vectors cancel across it, axial ones along it
      {
        result.force  = Point3(2. * result.force[0], 0., 2. * result.force[2]);
        result.moment = Point3(0., 2. * result.moment[1], 0.);
      }
    return result;
  }

  template class SectionCut<2>;
  template class SectionCut<3>;
} // namespace birdstrike
