#include "structure/histories/element_points.h"
#include "structure/histories/strain.h"
#include <birdstrike/core/errors.h>

#include <Eigen/LU>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  ShellPoints::ShellPoints(const WatchedBlade<ShellKind> &blade)
    : mesh(blade.mesh), elements(blade.elements), directors(blade.mesh, blade.elements, blade.motion)
  {
  }

  void ShellPoints::add(const std::uint32_t element, const double layer)
  {
    directors.add(element);
    height.push_back(elements.nearest_height(element, layer));
  }

  std::string ShellPoints::describe(const std::size_t k) const
  {
    const std::uint32_t   e     = directors.element(k);
    const std::string     where = describe_element(mesh, e);
    const ThicknessPoints rule  = elements.thickness_points(e);
    if (const Laminate *plies = elements.laminate(e))
      return fmt::format("{}, ply {} of {} from the bottom ({:.3g} of half the thickness)", where,
                         plies->at(height[k]).ply + 1, plies->n_plies, height[k]);
    const auto point = std::find(rule.position.begin(), rule.position.begin() + rule.n, height[k]);
    return fmt::format("{}, integration point {} of {} through the thickness ({:.3g} of half of it)", where,
                       point - rule.position.begin() + 1, rule.n, height[k]);
  }

  PointValues ShellPoints::values(const std::size_t k) const
  {
    const std::uint32_t e = directors.element(k);
    PointValues         now;
    now.thickness               = elements.state(e).thickness;
    const ShellPointState state = elements.point_state(e, height[k]);
    now.plastic_strain          = state.plastic_strain;
    now.is_failed               = elements.is_failed(e);
    if (now.is_failed)
      return now;
    now.stress = state.stress;
    now.strain =
      logarithmic_strain(elements.laminate(e) ? directors.deformation_gradient(k, height[k])
                                              : directors.deformation_gradient(k, height[k], state.volume_strain));
    return now;
  }

  namespace
  {
    /// Derivatives of the trilinear map of a brick, columns, at the middle (0) or at the middle of a face across
    /// `axis`.
    Matrix3<double> derivatives(const std::array<Point3, 8> &x, const unsigned int axis, const double position)
    {
      Matrix3<double> columns = Matrix3<double>::Zero();
      for (unsigned int c = 0; c < 8; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double along = c >> axis & 1u ? 1. : -1.;
            columns.col(d) += (c >> d & 1u ? 0.125 : -0.125) * (d == axis ? 1. : 1. + along * position) * x[c];
          }
      return columns;
    }
  } // namespace

  SolidPoints::SolidPoints(const WatchedBlade<SolidKind> &blade) : blade(blade)
  {
  }

  void SolidPoints::add(const std::uint32_t element, const double layer)
  {
    if (layer != 0. && std::abs(layer) != 1.)
      throw InputError(
        fmt::format("Output/Histories/Elements: layer {:g} of a brick.\nAllowed: 0 (the element's mean), "
                    "-1 and 1 (the middles of its faces); shells take any share between.",
                    layer));
    Watched one{element, static_cast<int>(layer), 2, false};
    if (blade.roles.root.is_present())
      {
        std::array<Point3, 8> x;
        for (unsigned int c = 0; c < 8; ++c)
          x[c] = blade.mesh.node(blade.mesh.cells[element][c]);
        const Matrix3<double> edges = derivatives(x, 0, 0.).colwise().normalized();
        const Point3          normal =
          find_blade_axes(blade.mesh.surface(), blade.roles, blade.mesh.centroid(element), "Output/Histories/Elements")
            .row(2);
        const Point3 cosine = edges.transpose() * normal;
        cosine.cwiseAbs().maxCoeff(&one.axis);
        one.is_turned = cosine[one.axis] < 0.;
      }
    watched.push_back(one);
  }

  std::string SolidPoints::describe(const std::size_t k) const
  {
    static constexpr std::array<const char *, 3> places{
      {", middle of the face at minus the normal", ", mean", ", middle of the face at plus the normal"}};
    return describe_element(blade.mesh, watched[k].element) + places[watched[k].layer + 1];
  }

  PointValues SolidPoints::values(const std::size_t k) const
  {
    const Watched &one = watched[k];
    PointValues    now;
    const double   position = one.is_turned ? -one.layer : one.layer;
    now.is_failed           = blade.elements.is_failed(one.element);
    const auto take         = [&](const auto &state) {
      now.plastic_strain = state.plastic_strain;
      now.stress         = state.stress;
    };
    if (one.layer == 0)
      take(blade.elements.state(one.element));
    else
      take(blade.elements.face_state(one.element, {one.axis, position}));
    if (now.is_failed)
      {
        now.stress = {};
        return now;
      }
    std::array<Point3, 8> rest, x;
    for (unsigned int c = 0; c < 8; ++c)
      {
        const std::uint32_t n = blade.mesh.cells[one.element][c];
        rest[c]               = blade.mesh.node(n);
        x[c]                  = Point3(blade.motion.positions() + 3 * n);
      }
    now.strain =
      logarithmic_strain(derivatives(x, one.axis, position) * derivatives(rest, one.axis, position).inverse());
    return now;
  }
} // namespace birdstrike
