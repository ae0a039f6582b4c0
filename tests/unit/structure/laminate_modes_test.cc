#include "../record.h"
#include "blade_case.h"
#include "laminate_case.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

namespace laminate_modes_test
{
  using namespace laminate_case;

  // Natural frequencies and static equilibrium of blades of plies, by the program's own solvers.
  namespace
  {
    VibrationModes modes_of(const BladeParameters &p, const std::size_t n)
    {
      ThreadPool pool(1);
      const auto blade = make_blade(p, pool);
      blade->find_equilibrium();
      return blade->compute_modes(n);
    }

    /// A square of side 1 m, simply supported as Navier's series wants.
    BladeParameters simply_supported(const std::string &plies, const double thickness, const Ply &ply,
                                     const unsigned int n)
    {
      BladeParameters p  = test::elastic_plate(n, n);
      p.mesh.length      = 1.;
      p.mesh.chord       = 1.;
      p.thickness.value  = std::to_string(thickness);
      p.laminate.plies   = plies;
      p.laminate.ply     = ply;
      p.supports.clamped = "";
      p.supports.held    = "0: uy uz rx; 1: uy uz rx; 2: ux uz ry; 3: ux uz ry";
      return p;
    }
  } // namespace

  // Noor (1973) as usually quoted, three-dimensional elasticity, [0/90/90/0], a/h = 5: w a^2/h sqrt(rho/E2) by E1/E2.
  // First-order theory with 5/6 has 10.82 for 40.
  TEST(LaminateModes, ThickPlatesAreNearElasticity)
  {
    for (const auto &[ratio, exact] : {std::pair(10., 8.2103), std::pair(20., 9.5603), std::pair(40., 10.752)})
      for (const ShellFormulation formulation : covariant_formulations)
        {
          Ply             ply   = of_ratio(ratio, 0.6, 0.5);
          BladeParameters p     = simply_supported("[0/90]s", 0.2, ply, 24);
          p.element.formulation = formulation;
          const double found    = 2. * M_PI * modes_of(p, 1).modes[0].frequency / 0.2;
          record(std::string(name_of(formulation)) + " E1/E2 = " + std::to_string(int(ratio)), found / exact);
          EXPECT_NEAR(found / exact, 1., 0.02) << name_of(formulation) << ratio;
        }
  }

  // Thin: classical theory of a specially orthotropic plate (Jones 1999, eq. 5.94),
  // w^2 = pi^4 (D11 m^4 + 2 (D12 + 2 D66) m^2 n^2 + D22 n^4)/(rho h).
  TEST(LaminateModes, ThinPlatesAreThoseOfClassicalTheory)
  {
    const double        h   = 0.002;
    const Ply           ply = carbon();
    std::vector<double> exact;
    const ABD           of = lamination_theory(ply, equal_plies({0., 90., 90., 0.}), h);
    for (const auto &[m, n] : {std::pair(1, 1), std::pair(1, 2), std::pair(2, 1), std::pair(2, 2), std::pair(1, 3)})
      exact.push_back(0.5 * M_PI *
                      std::sqrt((of.D(0, 0) * m * m * m * m + 2. * (of.D(0, 1) + 2. * of.D(2, 2)) * m * m * n * n +
                                 of.D(1, 1) * n * n * n * n) /
                                (ply.density * h)));
    std::sort(exact.begin(), exact.end());
    for (const ShellFormulation formulation : covariant_formulations)
      {
        BladeParameters p     = simply_supported("0; 90; 90; 0", h, ply, 40);
        p.element.formulation = formulation;
        const auto found      = modes_of(p, 5).modes;
        for (std::size_t k = 0; k < exact.size(); ++k)
          EXPECT_NEAR(found[k].frequency / exact[k], 1., k == 0 ? 3e-3 : 1.2e-2) << name_of(formulation) << k;
      }
  }

  // Symmetry of the whole: plies mirrored about the span make a mirrored blade with the same frequencies; fibres along
  // the span make it stiffer than those across.
  TEST(LaminateModes, KnowWhereTheFibresLie)
  {
    const auto first = [](const std::string &plies) {
      BladeParameters p = test::elastic_plate(20, 6);
      p.laminate.plies  = plies;
      p.laminate.ply    = carbon();
      return modes_of(p, 2).modes;
    };
    const auto along = first("0"), across = first("90"), left = first("[30/10]s"), right = first("[-30/-10]s");
    EXPECT_NEAR(along[0].frequency / across[0].frequency, std::sqrt(138. / 9.), 0.02);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(left[k].frequency / right[k].frequency, 1., 1e-7);
  }

  TEST(LaminateModes, SectionsOfMetalAndOfPliesShareNodes)
  {
    BladeParameters p           = test::elastic_plate(20, 6);
    p.laminate.plies            = "[0/45/-45/90]s";
    p.laminate.ply              = carbon();
    p.mesh.material_boxes       = "0 -1 -1 1 -0.029 1: 7";
    p.sections[0].material_ids  = "7";
    p.sections[0].material      = p.material;
    p.sections[0].material.name = "Ti-6Al-4V";
    ThreadPool pool;
    const auto blade = make_blade(p, pool);
    EXPECT_NEAR(blade->mass() / (0.3112 * 0.0889 * 0.00427 * (4430. / 6. + 1600. * 5. / 6.)), 1., 1e-10);
    p.loads.initial_velocity = "0; 0; 20*(x/0.3112)^2";
    const auto   moving      = make_blade(p, pool);
    const double before      = test::balance(*moving);
    test::advance(*moving, 0.9 * moving->step_limit().value, 1000);
    EXPECT_NEAR(test::balance(*moving) / before, 1., 2e-3);

    // a section of other plies, with the blade's ply
    p.sections[0].material       = MetalParameters{BladeParameters::Section::same};
    p.sections[0].laminate.plies = "90";
    EXPECT_EQ(p.by_section().at(1).laminate.ply, carbon());
    EXPECT_NEAR(make_blade(p, pool)->mass() / (0.3112 * 0.0889 * 0.00427 * 1600.), 1., 1e-10);
  }
} // namespace laminate_modes_test
