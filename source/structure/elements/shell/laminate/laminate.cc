#include "structure/elements/shell/laminate/laminate.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;

    /// Reduced stiffness of a ply in the laminate's axes, on (e_11, e_22, 2 e_12).
    Matrix3<double> turned_stiffness(const Ply &ply, const double c, const double s)
    {
      const PlyStiffness<double> q(ply, 1., 1.);
      Matrix3<double>            own, turn;
      own << q.q11, q.q12, 0., q.q12, q.q22, 0., 0., 0., q.q66;
      turn << c * c, s * s, c * s, s * s, c * c, -c * s, -2. * c * s, 2. * c * s, c * c - s * s; // of strains
      return turn.transpose() * own * turn;
    }

    Eigen::Matrix2d turned_shear(const Ply &ply, const double c, const double s)
    {
      Eigen::Matrix2d turn;
      turn << c, -s, s, c;
      return turn * Eigen::Vector2d(ply.shear_13, ply.shear_23).asDiagonal() * turn.transpose();
    }

    Matrix6 as_matrix(const double (&m)[6][6])
    {
      return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(&m[0][0]);
    }

    void store(const Matrix6 &m, double (&into)[6][6])
    {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
          into[i][j] = 0.5 * (m(i, j) + m(j, i));
    }
  } // namespace

  Laminate::Laminate(const std::vector<Ply> &of_plies, const std::vector<PlyLayer> &plies, const Point3 &reference,
                     const unsigned int n_per_ply)
    : materials(of_plies.begin(), of_plies.end())
    , n_plies(plies.size())
    , reference(reference)
    , density(of_plies[0].density)
  {
    Matrix6 C    = Matrix6::Zero();
    double  from = 0.;
    for (const PlyLayer &of : plies)
      {
        const double angle = of.angle * M_PI / 180.;
        // exactly along and across: their coupling is none
        const bool   is_turned = std::remainder(of.angle, 90.) != 0.;
        const double c         = is_turned ? std::cos(angle) : std::round(std::cos(angle)),
                     s         = is_turned ? std::sin(angle) : std::round(std::sin(angle));
        for (unsigned int k = 0; k < n_per_ply; ++k)
          layers.push_back({2. * (from + of.share * k / n_per_ply) - 1.,
                            2. * (from + of.share * (k + 1) / n_per_ply) - 1., c, s, of.material,
                            static_cast<std::size_t>(&of - plies.data())});
        from += of.share;
        density += of.share * (of_plies[of.material].density - of_plies[0].density);
      }
    layers.back().top = 1.;
    for (const Layer &layer : layers)
      {
        const Matrix3<double> q = turned_stiffness(of(layer).ply, layer.cos, layer.sin);
        const double          a = layer.bottom, b = layer.top;
        C.topLeftCorner<3, 3>() += 0.5 * (b - a) * q;
        C.topRightCorner<3, 3>() += 0.25 * (b * b - a * a) * q;
        C.bottomRightCorner<3, 3>() += (b * b * b - a * a * a) / 6. * q;
      }
    // a symmetric stack has no coupling, not that of rounding
    if (C.topRightCorner<3, 3>().norm() < 1e-13 * C.topLeftCorner<3, 3>().norm())
      C.topRightCorner<3, 3>().setZero();
    C.bottomLeftCorner<3, 3>() = C.topRightCorner<3, 3>().transpose();
    store(C, stiffness);
    store(C.inverse(), compliance);
    const Matrix3<double> A = C.topLeftCorner<3, 3>(), B = C.topRightCorner<3, 3>(), D = C.bottomRightCorner<3, 3>();
    const Matrix3<double> A_inverse = A.inverse();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        membrane_alone[i][j] = A_inverse(i, j);
    coupling = std::max(0., (D.inverse() * B * A_inverse * B).eigenvalues().real().maxCoeff());
    set_shear();
  }

  void Laminate::set_shear()
  {
    const Matrix6 S = as_matrix(compliance);
    // growth of (e, b) along 1 by Q_1 = 1, along 2 by Q_2 = 1, of a thickness of 1: m = 2 M
    const Vector6    along[2] = {2. * S.col(3), 2. * S.col(4)};
    Eigen::Matrix2d  F = Eigen::Matrix2d::Zero(), sum = Eigen::Matrix2d::Zero();
    constexpr double gauss[3]  = {-0.77459666924148338, 0., 0.77459666924148338},
                     weight[3] = {5. / 9., 8. / 9., 5. / 9.};
    for (const Layer &layer : layers)
      {
        const Matrix3<double> q        = turned_stiffness(of(layer).ply, layer.cos, layer.sin);
        const Eigen::Matrix2d softest  = turned_shear(of(layer).ply, layer.cos, layer.sin).inverse();
        const auto            shear_at = [&](const double h) {
          Eigen::Matrix2d f = F;
          for (int d = 0; d < 2; ++d)
            {
              const Point3 stress = q * ((h - layer.bottom) * along[d].head<3>() +
                                         0.5 * (h * h - layer.bottom * layer.bottom) * along[d].tail<3>());
              f(d, d) -= 0.5 * stress[d];
              f(1 - d, d) -= 0.5 * stress[2];
            }
          return f;
        };
        for (int g = 0; g < 3; ++g)
          {
            const Eigen::Matrix2d f = shear_at(layer.middle() + gauss[g] * layer.share());
            sum += 0.5 * weight[g] * layer.share() * f.transpose() * softest * f;
          }
        F = shear_at(layer.top);
      }
    const Eigen::Matrix2d H = sum.inverse();
    shear[0]                = H(0, 0);
    shear[1]                = H(1, 1);
    shear[2]                = 0.5 * (H(0, 1) + H(1, 0));
    largest_shear           = 0.5 * (shear[0] + shear[1]) + std::hypot(0.5 * (shear[0] - shear[1]), shear[2]);
  }

  Laminate::Uniaxial Laminate::uniaxial(const double c, const double s) const
  {
    const Point3    stress(c * c, s * s, c * s);
    Matrix3<double> S;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        S(i, j) = membrane_alone[i][j];
    const Point3 e     = S * stress;
    const double along = e.dot(stress);
    return {1. / along, (s * s * e[0] + c * c * e[1] - c * s * e[2]) / along,
            (2. * c * s * (e[1] - e[0]) + (c * c - s * s) * e[2]) / along};
  }

  Laminate::Beam Laminate::beam(const double c, const double s) const
  {
    Eigen::Matrix<double, 6, 2> stress = Eigen::Matrix<double, 6, 2>::Zero();
    stress.block<3, 1>(0, 0) = stress.block<3, 1>(3, 1) = Point3(c * c, s * s, c * s);
    const Eigen::Matrix2d K = (stress.transpose() * as_matrix(compliance) * stress).inverse();
    return {K(0, 0), 0.5 * (K(0, 1) + K(1, 0)), K(1, 1)};
  }

  double Laminate::shear_along(const double c, const double s) const
  {
    return c * c * shear[0] + s * s * shear[1] + 2. * c * s * shear[2];
  }

  const Laminate::Layer &Laminate::at(const double height) const
  {
    return *std::find_if(layers.begin(), layers.end() - 1, [&](const Layer &layer) { return height <= layer.top; });
  }
} // namespace birdstrike
