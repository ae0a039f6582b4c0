#include <birdstrike/material/radial_return.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  const Elasticity titanium{113.8e9, 0.342};
  const Hardening  perfect; // 880 MPa
} // namespace

TEST(RadialReturn, UniaxialStrain)
{
  Matrix3<double> stress = Matrix3<double>::Zero(), strain = Matrix3<double>::Zero();
  strain(0, 0) = 1.03775e-2;
  add_elastic_stress(titanium, strain, stress);
  EXPECT_NEAR(stress(0, 0), 1832.405e6, 2e4) << "Hugoniot elastic limit, strain given to six digits";
  stress.setZero();
  strain(0, 0) = 0.02 / 40;
  double p     = 0.;
  for (int i = 0; i < 40; ++i)
    {
      add_elastic_stress(titanium, strain, stress);
      p += radial_return(titanium, perfect, p, 880e6, 1., stress).strain;
    }
  EXPECT_NEAR(stress(0, 0), 2987.5105e6, 2987.5e6 * 1e-6);
  EXPECT_NEAR(stress(1, 1), 2107.5105e6, 2107.5e6 * 1e-6);
}

TEST(RadialReturn, MeetsTheHardeningCurve)
{
  Hardening h;
  h.law                  = HardeningLaw::voce;
  h.modulus              = 200e6;
  h.exponent             = 15.;
  Matrix3<double> stress = Matrix3<double>::Zero(), strain;
  strain << 0.01, 0.004, -0.002, 0.004, -0.003, 0.001, -0.002, 0.001, 0.02;
  add_elastic_stress(titanium, strain, stress);
  const auto step = radial_return(titanium, h, 0., 880e6, 1., stress);
  EXPECT_NEAR(von_mises(stress) / (880e6 + 200e6 * (1. - std::exp(-15. * step.strain))), 1., 1e-12);
}

TEST(HughesWinget, AFullTurnGivesTheStressBack)
{
  Matrix3<double> stress, w = Matrix3<double>::Zero();
  stress << 3., 1., -2., 1., 5., 0.5, -2., 0.5, -1.;
  const Matrix3<double> start = stress;
  // the midpoint displacement gradient of a turn by a is antisymmetric with 2 tan(a/2)
  const double t = 2. * std::tan(0.5 * 10. * std::acos(-1.) / 180.);
  w(0, 1)        = -t;
  w(1, 0)        = t;
  for (int i = 0; i < 36; ++i)
    stress = rotate_hughes_winget(w, stress);
  EXPECT_LT((stress - start).cwiseAbs().maxCoeff(), 1e-12 * start.norm());
}

TEST(HughesWinget, ElasticSimpleShearIsJaumanns)
{
  // midpoint gradients: second order in the increment; exact G sin(gamma), G (1 - cos(gamma))
  const double    G      = titanium.shear_modulus();
  Matrix3<double> stress = Matrix3<double>::Zero(), d = Matrix3<double>::Zero(), w = d;
  const int       n = 1000;
  d(0, 1) = d(1, 0) = 0.5 / n;
  w(0, 1)           = 1. / n;
  w(1, 0)           = -1. / n;
  w *= 0.5;
  for (int i = 0; i < n; ++i)
    {
      stress = rotate_hughes_winget(Matrix3<double>(0.5 * w), stress);
      add_elastic_stress(titanium, d, stress);
      stress = rotate_hughes_winget(Matrix3<double>(0.5 * w), stress);
    }
  EXPECT_NEAR(stress(0, 1) / G, 0.841471, 1e-6);
  EXPECT_NEAR(stress(0, 0) / G, 0.459698, 1e-6);
}
