#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/volume_mesh.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace birdstrike
{
  namespace
  {
    using Jacobian = Eigen::Matrix<double, 3, 3>;

    /// dx/dxi of the trilinear map of a cell at a point of the unit cube.
    Jacobian jacobian(const VolumeMesh &mesh, const std::size_t cell, const double xi, const double eta,
                      const double zeta)
    {
      const double at[3] = {xi, eta, zeta};
      Jacobian     result(Jacobian::Zero());
      for (unsigned int k = 0; k < 8; ++k)
        {
          double weight[3], slope[3];
          for (unsigned int d = 0; d < 3; ++d)
            {
              const bool is_upper = k >> d & 1;
              weight[d]           = is_upper ? at[d] : 1. - at[d];
              slope[d]            = is_upper ? 1. : -1.;
            }
          const Point3 x = mesh.node(mesh.cells[cell][k]);
          result.col(0) += slope[0] * weight[1] * weight[2] * x;
          result.col(1) += weight[0] * slope[1] * weight[2] * x;
          result.col(2) += weight[0] * weight[1] * slope[2] * x;
        }
      return result;
    }

    template <typename Face>
    bool carries(const Face &face, const std::vector<unsigned int> &ids)
    {
      return std::find(ids.begin(), ids.end(), face.id) != ids.end();
    }

    template <typename Value>
    void sort_uniquely(std::vector<Value> &values)
    {
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
    }
  } // namespace

  Point3 VolumeMesh::node(const std::size_t n) const
  {
    return Point3(nodes[n][0], nodes[n][1], nodes[n][2]);
  }

  Point3 VolumeMesh::centroid(const std::size_t cell) const
  {
    Point3 sum = Point3::Zero();
    for (const std::uint32_t n : cells[cell])
      sum += node(n);
    return 0.125 * sum;
  }

  double VolumeMesh::volume(const std::size_t cell) const
  {
    // The Jacobian of a trilinear map is quadratic in each coordinate: two Gauss points are exact.
    const double gauss[2] = {0.5 - 0.5 / std::sqrt(3.), 0.5 + 0.5 / std::sqrt(3.)};
    double       sum      = 0.;
    for (const double xi : gauss)
      for (const double eta : gauss)
        for (const double zeta : gauss)
          sum += 0.125 * jacobian(*this, cell, xi, eta, zeta).determinant();
    return sum;
  }

  double VolumeMesh::smallest_edge(const std::size_t cell) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (unsigned int k = 0; k < 8; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        if (!(k >> d & 1))
          smallest = std::min(smallest, (node(cells[cell][k | 1u << d]) - node(cells[cell][k])).norm());
    return smallest;
  }

  std::vector<std::uint32_t> VolumeMesh::nodes_on(const std::vector<unsigned int> &ids) const
  {
    std::vector<std::uint32_t> found;
    for (const auto *list : {&faces, &symmetry_faces})
      for (const BoundaryFace &face : *list)
        if (carries(face, ids))
          found.insert(found.end(), face.nodes.begin(), face.nodes.end());
    sort_uniquely(found);
    return found;
  }

  bool VolumeMesh::has_boundary_id(const unsigned int id) const
  {
    const auto has = [id](const BoundaryFace &face) { return face.id == id; };
    return std::any_of(faces.begin(), faces.end(), has) ||
           std::any_of(symmetry_faces.begin(), symmetry_faces.end(), has);
  }

  std::vector<unsigned int> VolumeMesh::boundary_ids() const
  {
    std::vector<unsigned int> ids;
    for (const auto *list : {&faces, &symmetry_faces})
      for (const BoundaryFace &face : *list)
        ids.push_back(face.id);
    sort_uniquely(ids);
    return ids;
  }

  std::uint32_t VolumeMesh::nearest_node(const Point3 &p) const
  {
    std::uint32_t nearest  = 0;
    double        distance = std::numeric_limits<double>::infinity();
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
      if (const double d = (node(n) - p).squaredNorm(); d < distance)
        {
          distance = d;
          nearest  = n;
        }
    return nearest;
  }

  void check_shape(const VolumeMesh &mesh)
  {
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
        for (unsigned int k = 0; k < 8; ++k)
          {
            const double det = jacobian(mesh, cell, k & 1, k >> 1 & 1, k >> 2 & 1).determinant();
            smallest         = std::min(smallest, det);
            largest          = std::max(largest, det);
          }
        const Point3 p = mesh.centroid(cell);
        if (!(smallest > 1e-10 * largest))
          throw InputError(
            "Mesh: cell " + std::to_string(cell) + " at (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
            std::to_string(p[2]) +
            ") m has a corner without volume (folded, inside out or collapsed).\n"
            "The Jacobian of every hexahedron must be positive at its corners; repair or re-mesh there.");
      }
  }
} // namespace birdstrike
