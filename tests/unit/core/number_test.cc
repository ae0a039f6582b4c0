#include <birdstrike/core/number.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  template <class Number>
  Number triple_product(const Vector3<Number> &a, const Vector3<Number> &b, const Vector3<Number> &c)
  {
    return a.cross(b).dot(c);
  }
} // namespace

TEST(Number, AFormulaGivesTheSameOnLanesAsOnDoubles)
{
  Vector3<Lanes> a, b, c;
  for (int i = 0; i < 3; ++i)
    {
      a[i] = Lanes([i](const auto k) { return 1. + i + 0.1 * k; });
      b[i] = Lanes([i](const auto k) { return 2. - i * i + 0.3 * k; });
      c[i] = Lanes([i](const auto k) { return 0.5 * i - 0.2 * k; });
    }
  const Lanes volume = triple_product(a, b, c);
  for (std::size_t k = 0; k < n_lanes; ++k)
    {
      Point3 ak, bk, ck;
      for (int i = 0; i < 3; ++i)
        {
          ak[i] = a[i][k];
          bk[i] = b[i][k];
          ck[i] = c[i][k];
        }
      // one fused multiply-add more or less in either version
      EXPECT_NEAR(volume[k], triple_product(ak, bk, ck), 1e-13);
    }
}

TEST(Number, SelectTakesEachLaneByItsMask)
{
  const Lanes a([](const auto k) { return k; });
  const Lanes chosen = select(a < Lanes(2.), Lanes(-1.), a);
  for (std::size_t k = 0; k < n_lanes; ++k)
    EXPECT_EQ(chosen[k], k < 2 ? -1. : static_cast<double>(k));
  EXPECT_EQ(select(true, 1., 2.), 1.);
}
