#include "structure/histories/shell_directors.h"
#include "structure/histories/strain.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    Matrix3<double> base_of(const std::array<Point3, 4> &corners, const Point3 &fibre)
    {
      const Tangents  tangents = Tangents::of(corners);
      Matrix3<double> base;
      base << tangents.first, tangents.second, fibre;
      return base;
    }
  } // namespace

  ShellDirectors::ShellDirectors(const ShellMesh &mesh, const ShellElements &elements, const NodalMechanics<6> &motion)
    : mesh(mesh), elements(elements), motion(motion)
  {
  }

  std::size_t ShellDirectors::add(const std::uint32_t element)
  {
    Watched one;
    one.element   = element;
    one.thickness = elements.state(element).thickness;
    one.normal    = mesh.area_vector(element).normalized();
    one.director.fill(one.normal);
    one.rotation.fill(Point3::Zero());
    watched.push_back(one);
    return watched.size() - 1;
  }

  void ShellDirectors::follow()
  {
    const double *const u = motion.displacements();
    for (Watched &one : watched)
      for (unsigned int c = 0; c < 4; ++c)
        {
          const Point3 now(u + 6 * mesh.cells[one.element][c] + 3), step = now - one.rotation[c];
          if (const double angle = step.norm(); angle > 0.)
            one.director[c] = (Eigen::AngleAxisd(angle, step / angle) * one.director[c]).normalized();
          one.rotation[c] = now;
        }
  }

  void ShellDirectors::archive(Archive &archive)
  {
    std::vector<double> state;
    for (Watched &one : watched)
      for (auto *corners : {&one.director, &one.rotation})
        for (Point3 &vector : *corners)
          state.insert(state.end(), vector.data(), vector.data() + 3);
    archive.list("fibres and rotations", state);
    const double *next = state.data();
    for (Watched &one : watched)
      for (auto *corners : {&one.director, &one.rotation})
        for (Point3 &vector : *corners)
          {
            vector = Point3(next);
            next += 3;
          }
  }

  std::array<Point3, 4> ShellDirectors::corners_at_rest(const std::size_t k, const double zeta) const
  {
    const Watched        &one = watched[k];
    std::array<Point3, 4> x;
    for (unsigned int c = 0; c < 4; ++c)
      x[c] = mesh.node(mesh.cells[one.element][c]) + 0.5 * zeta * one.thickness * one.normal;
    return x;
  }

  std::array<Point3, 4> ShellDirectors::corners(const std::size_t k, const double zeta) const
  {
    const Watched        &one  = watched[k];
    const double          half = 0.5 * zeta * elements.state(one.element).thickness;
    std::array<Point3, 4> x;
    for (unsigned int c = 0; c < 4; ++c)
      x[c] = Point3(motion.positions() + 3 * mesh.cells[one.element][c]) + half * one.director[c];
    return x;
  }

  Matrix3<double> ShellDirectors::deformation_gradient(const std::size_t k, const double zeta) const
  {
    const Watched &one   = watched[k];
    Point3         fibre = Point3::Zero();
    for (const Point3 &director : one.director)
      fibre += 0.25 * director;
    return base_of(corners(k, zeta), fibre.normalized()) * base_of(corners_at_rest(k, zeta), one.normal).inverse();
  }

  Matrix3<double> ShellDirectors::deformation_gradient(const std::size_t k, const double zeta,
                                                       const double volume_strain) const
  {
    const Matrix3<double> F = deformation_gradient(k, zeta);
    const Point3         &n = watched[k].normal;
    // F n <- s F n
    return F + (std::exp(volume_strain) / F.determinant() - 1.) * (F * n) * n.transpose();
  }
} // namespace birdstrike
