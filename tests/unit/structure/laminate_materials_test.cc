#include "../record.h"
#include "blade_case.h"
#include "laminate_case.h"

#include "structure/elements/shell/laminate/failure.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <random>

namespace laminate_materials_test
{
  using namespace laminate_case;

  // Stacks of plies of several materials.
  namespace
  {
    const Ply aluminium = isotropic(72e9, 0.33, 2780.), foam = isotropic(0.1e9, 0.3, 75.);

    const std::vector<Ply> mixed{carbon(), aluminium, foam};

    const std::vector<std::vector<PlyLayer>> stacks{
      {{0., 0.3, 1}, {30., 0.7, 0}},                                            // metal under carbon
      {{45., 0.1, 0}, {-45., 0.1, 0}, {0., 0.6, 2}, {90., 0.2, 1}},             // sandwich, unsymmetric
      {{0., 0.2, 1}, {0., 0.1, 0}, {90., 0.4, 0}, {0., 0.1, 0}, {0., 0.2, 1}}}; // of the kind of GLARE

    /// Of a width of 1 and a thickness of 1: compliance Q^2/(2 K) of the sections' shear stresses, K; by quadrature of
    /// the equilibrium of a beam without Poisson's ratio.
    double beam_shear_stiffness(const std::vector<Ply> &of, const std::vector<PlyLayer> &plies)
    {
      constexpr std::size_t n  = 40000;
      const auto            at = [&](const double z) -> const Ply            &{
        double top = -0.5;
        for (const PlyLayer &ply : plies)
          if (z < (top += ply.share))
            return of[ply.material];
        return of[plies.back().material];
      };
      double a = 0., b = 0., d = 0., f = 0., energy = 0.;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double z = (i + 0.5) / n - 0.5, E = at(z).young_1 / n;
          a += E;
          b += E * z;
          d += E * z * z;
        }
      const double middle = b / a, bending = d - b * b / a;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double z = (i + 0.5) / n - 0.5, grows = -at(z).young_1 * (z - middle) / n / bending;
          energy += (f + 0.5 * grows) * (f + 0.5 * grows) / at(z).shear_13 / n;
          f += grows;
        }
      return 1. / energy;
    }
  } // namespace

  TEST(LaminateMaterials, StiffnessIsThatOfClassicalLaminationTheory)
  {
    for (const auto &plies : stacks)
      {
        const ABD theory = lamination_theory(mixed, plies, 1.);
        for (const unsigned int n_per_ply : {1u, 3u})
          {
            const Laminate of(mixed, plies, Point3::UnitX(), n_per_ply);
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                {
                  EXPECT_NEAR(of.stiffness[i][j], theory.A(i, j), 1e-12 * theory.A.norm());
                  EXPECT_NEAR(of.stiffness[i][j + 3], 2. * theory.B(i, j), 1e-12 * theory.A.norm());
                  EXPECT_NEAR(of.stiffness[i + 3][j + 3], 4. * theory.D(i, j), 1e-12 * theory.A.norm());
                }
            double density = 0.;
            for (const PlyLayer &ply : plies)
              density += ply.share * mixed[ply.material].density;
            EXPECT_NEAR(of.density, density, 1e-12 * density);
          }
      }
  }

  // A strip of two metals that is heated: the forces and moments of free expansion on the section bend it as
  // Timoshenko, "Analysis of bi-metal thermostats", J. Opt. Soc. Am. 11 (1925), eq. 4, says.
  TEST(LaminateMaterials, ABimetalBendsAsTimoshenkoSays)
  {
    const double E1 = 72e9, E2 = 210e9, growth = 1e-5; // (alpha_2 - alpha_1) (t - t_0), of the upper one
    for (const double share : {0.2, 0.5, 0.8})         // of the lower one
      {
        const Laminate of({isotropic(E1, 0., 2780.), isotropic(E2, 0., 7800.)}, {{0., share, 0}, {0., 1. - share, 1}},
                          Point3::UnitX());
        // N and m as means over a thickness of 1; curvature = bend at z = 1/2, over 1/2
        const double m = share / (1. - share), n = E1 / E2, top = 1. - share, arm = 0.5 * share;
        const double force = E2 * growth * top, moment = 2. * force * arm;
        const double curvature = 2. * (of.compliance[3][0] * force + of.compliance[3][3] * moment);
        const double exact =
          6. * growth * (1. + m) * (1. + m) / (3. * (1. + m) * (1. + m) + (1. + m * n) * (m * m + 1. / (m * n)));
        record("curvature, " + std::to_string(int(100. * share + 0.5)) + " %", curvature / exact);
        EXPECT_NEAR(curvature / exact, 1., 1e-12) << share;
      }
  }

  // A cantilever of aluminium under steel, pulled along its mid-plane: w = kappa L^2/2 with kappa = -B N/(A D - B^2).
  TEST(LaminateMaterials, AnUnsymmetricStripBendsWhenPulled)
  {
    const double                t = 1e-3, length = 0.1, width = 0.02;
    const std::vector<Ply>      metals{isotropic(72e9, 0., 2780.), isotropic(210e9, 0., 7800.)};
    const std::vector<PlyLayer> plies{{0., 0.6, 0}, {0., 0.4, 1}};
    const ABD                   of = lamination_theory(metals, plies, t);
    const double                A = of.A(0, 0), B = of.B(0, 0), D = of.D(0, 0), pull = 1.; // N/m
    for (const auto formulation : covariant_formulations)
      {
        Model model(
          make_grid(8, 2, [&](const double x, const double y) { return Point3(length * x, width * (y - 0.5), 0.); }), t,
          section_of(metals, plies, formulation));
        Eigen::VectorXd   load = Eigen::VectorXd::Zero(model.n_dofs());
        std::vector<bool> held(model.n_dofs(), false);
        for (unsigned int j = 0; j <= 2; ++j)
          {
            for (const int d : {0, 1, 2, 3, 4, 5})
              held[6 * 9 * j + d] = true;
            load[6 * (8 + 9 * j)] = pull * width * (j == 1 ? 0.5 : 0.25);
          }
        const Eigen::VectorXd u         = model.solve(load, held);
        const double          curvature = -B / (A * D - B * B) * pull; // k of w = -k x^2/2
        record(std::string(name_of(formulation)) + " deflection", u[6 * 17 + 2] / (-0.5 * curvature * length * length));
        EXPECT_NEAR(u[6 * 17 + 2] / (-0.5 * curvature * length * length), 1., 5e-3) << name_of(formulation);
        EXPECT_NEAR(u[6 * 17] / (D / (A * D - B * B) * pull * length), 1., 5e-3) << name_of(formulation);
      }
  }

  // Faces of carbon on a core without stiffness of its own in the plane: shear is constant in the core, falls as a
  // parabola in the faces. Thin faces: G (1 - f)^2/(1 - 2 f) with f the share of one (Allen 1969).
  TEST(LaminateMaterials, SandwichesShearByEquilibrium)
  {
    Ply face        = carbon(), core;
    face.poisson_12 = 0.;
    core.density    = 50.;
    core.young_1 = core.young_2 = core.shear_12 = 1.; // Pa: none
    core.shear_13 = core.shear_23 = 30e6;
    for (const double f : {0.01, 0.1, 0.25})
      {
        const Laminate of({face, core}, {{0., f, 0}, {0., 1. - 2. * f, 1}, {0., f, 0}}, Point3::UnitX());
        const double   E = face.young_1, c = 0.5 - f, h = 0.5, D = 2. / 3. * E * (h * h * h - c * c * c);
        const double   in_core     = 0.5 * E * (h * h - c * c) / D;
        const auto     of_parabola = [&](const double z) { // integral of (h^2 - z^2)^2
          return h * h * h * h * z - 2. / 3. * h * h * z * z * z + z * z * z * z * z / 5.;
        };
        const double energy = 2. * c * in_core * in_core / core.shear_13 +
                              2. * std::pow(0.5 * E / D, 2) * (of_parabola(h) - of_parabola(c)) / face.shear_13;
        record("shear, faces of " + std::to_string(int(100. * f)) + " %", of.shear[0] * energy);
        EXPECT_NEAR(of.shear[0] * energy, 1., 1e-6) << f;
        if (f < 0.02)
          {
            EXPECT_NEAR(of.shear[0] / (core.shear_13 * (1. - f) * (1. - f) / (1. - 2. * f)), 1., 1e-3);
          }
      }
    std::vector<Ply> without_contraction = mixed;
    for (Ply &ply : without_contraction)
      ply.poisson_12 = 0.;
    for (std::vector<PlyLayer> plies : stacks)
      {
        for (PlyLayer &ply : plies)
          ply.angle = 0.;
        EXPECT_NEAR(Laminate(without_contraction, plies, Point3::UnitX()).shear[0] /
                      beam_shear_stiffness(without_contraction, plies),
                    1., 1e-4);
      }
  }

  // Plies of one material named twice are those of one named once, to the last bit.
  TEST(LaminateMaterials, NamesChangeNothing)
  {
    LaminateParameters plain = LaminateParameters::of_blade(), named = plain;
    plain.ply          = carbon();
    plain.plies        = "0: 0.1; 45: 0.3; 90: 0.2";
    named.materials[2] = {"tape", "", carbon()};
    named.plies        = "0: 0.1: tape; 45: 0.3 : tape; 90: 0.2: tape";
    named.check("Blade/Laminate/");
    const PlyStack a = plain.stack(), b = named.stack();
    ASSERT_EQ(b.materials.size(), 1u);
    const Laminate one(a.materials[0].ply, a.layers, Point3::UnitX()),
      two(b.materials[0].ply, b.layers, Point3::UnitX());
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        EXPECT_EQ(one.stiffness[i][j], two.stiffness[i][j]);
    EXPECT_EQ(plain.density(), named.density());
    EXPECT_EQ(plain.density(), 1600.);
  }

  TEST(LaminateMaterials, AreReadByName)
  {
    BladeParameters p;
    p.laminate.materials[0]      = {"carbon", "", carbon()};
    p.laminate.materials[1]      = {"Al 2024", "", aluminium};
    p.laminate.plies             = "0: 0.4: Al 2024; 45: 0.2: carbon; 0: 0.4: Al 2024";
    p.sections[0].material_ids   = "1";
    p.sections[0].laminate.plies = "0: carbon; 90; -45: carbon";
    p.sections[0].laminate.ply   = foam;
    p.check();
    const auto     of    = p.by_section();
    const PlyStack blade = of.at(0).laminate.stack(), section = of.at(1).laminate.stack();
    ASSERT_EQ(blade.materials.size(), 2u);
    EXPECT_EQ(blade.materials[0].name, "Al 2024");
    EXPECT_EQ(blade.layers[1].material, 1u);
    EXPECT_DOUBLE_EQ(blade.layers[2].share, 0.4);
    EXPECT_NEAR(of.at(0).density(), 0.8 * 2780. + 0.2 * 1600., 1e-9);
    ASSERT_EQ(section.materials.size(), 2u);
    EXPECT_EQ(section.materials[1].ply, foam);
    EXPECT_EQ(section.layers[2].material, 0u);
    for (const char *bad :
         {"0: glass", "0: 1: glass", "0: 1: carbon: 2", "0: carbon: 1", "0: carbon; 0: 1: carbon", "0: 1:"})
      {
        p.laminate.plies = bad;
        EXPECT_THROW(p.check(), InputError) << bad;
      }
  }

  TEST(LaminateMaterials, AreCheckedEachByItself)
  {
    const auto refuses = [](const auto &spoil) {
      LaminateParameters p = LaminateParameters::of_blade();
      p.materials[0]       = {"carbon", "", carbon()};
      p.plies              = "0: carbon; 90: carbon";
      p.check("Blade/Laminate/"); // the laminate's own constants are not needed
      spoil(p);
      EXPECT_THROW(p.check("Blade/Laminate/"), InputError);
    };
    refuses([](LaminateParameters &p) { p.materials[0].ply.shear_23 = 0.; });
    refuses([](LaminateParameters &p) { p.materials[0].ply.strength.shear = 1e6; });
    refuses([](LaminateParameters &p) { p.materials[1].ply = carbon(); });
    refuses([](LaminateParameters &p) { p.materials[1] = p.materials[0]; });
    refuses([](LaminateParameters &p) { p.materials[0].name = "1.5"; });
    refuses([](LaminateParameters &p) { p.plies = "0: carbon; 90"; });
    refuses([](LaminateParameters &p) { p.smallest_step = 0.1; });
  }

  // Failure of one material only: the other keeps what it has, and never fails.
  TEST(LaminateMaterials, EachFailsByItsOwnStrengths)
  {
    Ply weak      = carbon();
    weak.strength = {1e9, 1e9, 50e6, 200e6, 80e6, 0.};
    const std::vector<PlyLayer> plies{{0., 0.5, 0}, {0., 0.5, 1}};
    Laminate                    law({weak, aluminium}, plies, Point3::UnitX());
    ASSERT_TRUE(law.can_fail());
    LaminateState<double> state{};
    PlyDamage<double>     damage[2]{};
    state.strain[0] = 0.99e9 / 138e9;
    EXPECT_FALSE(begins_to_fail(law, state));
    state.strain[0] = 0.05;
    EXPECT_TRUE(begins_to_fail(law, state));
    for (int step = 0; step < 10; ++step)
      update_failing_plies(law, 0.2, state, damage);
    EXPECT_EQ(damage[0].fibre(), 1.);
    EXPECT_EQ(damage[1].fibre(), 0.);
    EXPECT_EQ(damage[1].matrix(), 0.);
    const PlyStiffness<double> metal(aluminium, 1., 1.);
    EXPECT_NEAR(state.stress[0], 0.5 * metal.q11 * 0.05, 1e-6 * metal.q11);
    EXPECT_NEAR(state.stress[3], 0.25 * metal.q11 * 0.05, 1e-6 * metal.q11); // in the upper half
    // released: all that the carbon held, trapezoidal
    EXPECT_FALSE(Laminate({carbon(), aluminium}, plies, Point3::UnitX()).can_fail());
  }

  // One element each, of any shape and thickness: never above the true step. Plates swing at the bound and keep their
  // energy.
  TEST(LaminateMaterials, StepsHold)
  {
    std::mt19937                           random(11);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (const auto formulation : all_formulations)
      for (const auto &plies : stacks)
        for (const double thickness : {0.01, 0.1, 0.5})
          for (int k = 0; k < 8; ++k)
            {
              Mesh mesh = make_grid(1, 1, [](const double x, const double y) { return Point3(x, y, 0.); });
              for (auto &x : mesh.nodes)
                x +=
                  k < 2 ? Point3(0., 0., 0.) : Point3(0.3 * number(random), 0.3 * number(random), 0.1 * number(random));
              Model        model(mesh, thickness, section_of(mixed, plies, formulation));
              const double dt = model.elements.step_limit().value;
              EXPECT_LE(0.5 * std::sqrt(exact_eigenvalue(model)) * dt, 1. + 1e-6) << name_of(formulation) << k;
            }
    for (const auto formulation : covariant_formulations)
      {
        BladeParameters p        = test::elastic_plate(14, 5);
        p.laminate.materials     = {{{"carbon", "", carbon()}, {"metal", "", aluminium}, {"core", "", foam}, {}}};
        p.laminate.plies         = "45: 1: carbon; 0: 6: core; 90: 2: metal";
        p.element.formulation    = formulation;
        p.loads.initial_velocity = "0; 0; 30*(x/0.3112)^2 + 40*x*y";
        ThreadPool   pool;
        const auto   blade  = make_blade(p, pool);
        const double before = test::balance(*blade), dt = blade->step_limit().value;
        test::advance(*blade, dt, 2000);
        EXPECT_NEAR(test::balance(*blade) / before, 1., 3e-3) << name_of(formulation);
      }
  }
} // namespace laminate_materials_test
