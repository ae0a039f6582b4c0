#include "structure/deformable_blade.h"
#include "structure/stress_fields.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "blade_case.h"

namespace birdstrike::blade_fields_test
{
  namespace
  {
    using test::free_plate;

    const Field &field(const FieldSnapshot &snapshot, const std::string &name)
    {
      const auto found =
        std::find_if(snapshot.fields.begin(), snapshot.fields.end(), [&](const Field &of) { return of.name == name; });
      if (found == snapshot.fields.end())
        throw std::out_of_range(name);
      return *found;
    }

    TEST(StressFields, PrincipalStressesAreThoseOfMohrsCircle)
    {
      // shear of 3 in xy on tension of 8 in x: 4 +- 5, and 0; shear of 7 in yz; pressure; the order of zx
      const std::vector<std::array<double, 6>> stresses{
        {8., 0., 0., 3., 0., 0.}, {0., 0., 0., 0., 7., 0.}, {-2., -2., -2., 0., 0., 0.}, {8., 0., 0., 0., 0., 3.}};
      std::vector<Field> fields;
      add_stress_fields("_top", stresses, fields);
      ASSERT_EQ(fields.size(), 3u);
      EXPECT_EQ(fields[0].name, "stress_top");
      EXPECT_EQ(fields[0].n_components, 6u);
      EXPECT_EQ(fields[0].values[4 + 6], 7.);
      const std::vector<double> largest{9., 7., -2., 9.}, smallest{-1., -7., -2., -1.};
      for (std::size_t k = 0; k < stresses.size(); ++k)
        {
          EXPECT_NEAR(fields[1].values[k], largest[k], 1e-14 * 10.) << k; // round-off of an eigenvalue
          EXPECT_NEAR(fields[2].values[k], smallest[k], 1e-14 * 10.) << k;
        }
    }

    template <class Kind>
    class BladeFields : public testing::Test
    {
    };
    using Kinds = testing::Types<ShellKind, SolidKind>;
    TYPED_TEST_SUITE(BladeFields, Kinds);

    TYPED_TEST(BladeFields, NameNodesAndElementsAndFitTheMesh)
    {
      BladeParameters p = free_plate(4, 3);
      p.kind            = std::is_same_v<TypeParam, SolidKind> ? BladeKind::solid : BladeKind::shell;
      ThreadPool                       pool(1);
      const DeformableBlade<TypeParam> blade(p, pool);
      const FieldSnapshot              snapshot = blade.snapshot();
      const std::size_t                n = snapshot.points.size() / 3, n_cells = snapshot.cells.size() >> snapshot.dim;
      EXPECT_EQ(n_cells, 12u);
      for (const Field &of : snapshot.fields)
        EXPECT_EQ(of.values.size(), (of.on_cells ? n_cells : n) * of.n_components) << of.name;
      for (const auto &[name, count] : {std::pair{"node", n}, std::pair{"element", n_cells}})
        {
          const Field &number = field(snapshot, name);
          EXPECT_TRUE(number.is_number);
          for (std::size_t k = 0; k < count; ++k)
            EXPECT_EQ(number.values[k], static_cast<double>(k));
        }
    }

    // A uniform pressure is, in consistent nodal forces, p times the nodes' shares of the area: 1, 2 or 4 quarters of
    // the 3 x 4 equal facets. The free plate then accelerates with p/(rho t) in its mean; every node by its own mass.
    TYPED_TEST(BladeFields, PressureAndAccelerationFollowFromNodalForces)
    {
      constexpr double pressure = 2e6;
      BladeParameters  p        = free_plate(4, 3);
      p.kind                    = std::is_same_v<TypeParam, SolidKind> ? BladeKind::solid : BladeKind::shell;
      ThreadPool                 pool(1);
      DeformableBlade<TypeParam> blade(p, pool);
      blade.compute_internal_forces();
      const auto       before = blade.snapshot();
      const NodeForces forces = blade.clear_contact_forces();
      const double     facet  = 0.3112 * 0.0889 / 12.;
      const auto       share  = [&](const std::size_t node) {
        const double x = before.points[3 * node], y = before.points[3 * node + 1];
        const auto   is_at = [](const double a, const double b) { return std::abs(a - b) < 1e-9; };
        return facet / ((is_at(x, 0.) || is_at(x, 0.3112)) + 1.) / (is_at(std::abs(y), 0.0889 / 2.) + 1.);
      };
      const std::size_t n = before.points.size() / 3;
      for (std::size_t node = 0; node < n; ++node)
        if (before.points[3 * node + 2] <= 0.)
          forces.of(node)[2] = pressure * share(node);
      const FieldSnapshot after = blade.snapshot();
      double              force = 0., momentum_rate = 0.;
      for (std::size_t node = 0; node < n; ++node)
        {
          const bool is_struck = before.points[3 * node + 2] <= 0.;
          // edges of a body belong to two faces: only nodes within the face have its normal
          const bool is_inside = share(node) == facet;
          if (is_inside || TypeParam::dim == 2)
            {
              EXPECT_NEAR(field(after, "contact_pressure").values[node], is_struck ? pressure : 0., 1e-12 * pressure)
                << node;
            }
          force += field(after, "contact_force").values[3 * node + 2];
          momentum_rate += field(after, "acceleration").values[3 * node + 2] * 4430. * 0.00427 * share(node) /
                           (TypeParam::dim == 2 ? 1. : 2.);
        }
      EXPECT_NEAR(force / (pressure * 0.3112 * 0.0889), 1., 1e-12);
      EXPECT_NEAR(momentum_rate / force, 1., 1e-9); // the masses of the mesh are integrated, not rounded to these
    }
  } // namespace
} // namespace birdstrike::blade_fields_test
