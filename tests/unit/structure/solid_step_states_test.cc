#include "exact_step.h"
#include "matrices.h"
#include "solid_harness.h"

#include <gtest/gtest.h>

#include <random>

namespace solid_step_states_test
{
  using namespace solid_harness;

  // The estimate of the stable step against the exact one of states that a strike leads to. What it leaves out is the
  // stress itself: a compressive principal Kirchhoff stress s adds s to the modulus K + 4/3 G of waves, so that the
  // estimate may lie s/(2 (K + 4/3 G)) above: 0.3 % where titanium yields, 1.7 % compressed by 5 % of its volume. Thin
  // bricks that are pressed find it to five digits (1e-5: its square).
  namespace
  {
    constexpr std::array all_formulations{SolidFormulation::one_point, SolidFormulation::b_bar,
                                          SolidFormulation::solid_shell};

    SolidSection hardening_titanium(const SolidFormulation formulation)
    {
      SolidSection section;
      section.formulation                = formulation;
      section.material.hardening.law     = HardeningLaw::linear;
      section.material.hardening.modulus = 1e9;
      section.linear_viscosity = section.quadratic_viscosity = 0.; // by itself below
      return section;
    }

    Mesh bricks(const unsigned int n, const double height)
    {
      return make_box({n, n, n}, Point3(n, n, n * height));
    }

    Eigen::VectorXd compute_masses(const SolidElements &elements)
    {
      const auto      mass = elements.compute_nodal_masses();
      Eigen::VectorXd all(3 * mass.size());
      for (Eigen::Index d = 0; d < all.size(); ++d)
        all[d] = mass[d / 3];
      return all;
    }

    double wave_modulus(const SolidSection &section)
    {
      const Elasticity &elasticity = section.material.elasticity;
      return elasticity.bulk_modulus() + 4. / 3. * elasticity.shear_modulus();
    }

    /// The largest compressive principal stress of corners (Pa) over the modulus, halved; of the present state.
    double share_of_stress(const Model &model)
    {
      double most = 0.;
      for (std::size_t e = 0; e < model.mesh.cells.size(); ++e)
        for (unsigned int i = 0; i < 8; ++i)
          {
            const auto      s = model.elements.corner_stress(e, i);
            Eigen::Matrix3d stress;
            stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
            most = std::max(most, -test::symmetric_eigenvalues(stress)[0]);
          }
      return 0.5 * most / wave_modulus(model.section);
    }

    /// Estimated over exact step after `u` in 400 steps and a share of it back, so that nothing flows.
    double compute_ratio(Model &model, const Eigen::VectorXd &u, const double back)
    {
      for (int k = 0; k < 400; ++k)
        model.move(u / 400., 1e3);
      model.move(-back * u, 1e3);
      return model.elements.largest_stable_step() /
             exact_step::compute_step(exact_step::compute_tangent(model.elements, model.position),
                                      compute_masses(model.elements));
    }

    Eigen::VectorXd displacements(const Model &model, const Eigen::Matrix3d &gradient)
    {
      Eigen::VectorXd u(model.n_dofs());
      for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
        u.segment<3>(3 * n) = gradient * model.mesh.nodes[n];
      return u;
    }
  } // namespace

  TEST(SolidStepStates, StretchedCrushedShearedAndCompressedBricks)
  {
    struct Deformation
    {
      const char     *name;
      Eigen::Matrix3d gradient;
      double          back;
    };
    const auto diagonal = [](const double x, const double y, const double z) -> Eigen::Matrix3d {
      return Point3(x, y, z).asDiagonal();
    };
    Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
    shear(0, 1)           = 0.7;
    for (const auto formulation : all_formulations)
      for (const unsigned int n : {1u, 2u})
        for (const double height : {1., 0.2})
          for (const Deformation &d :
               {Deformation{"stretched", diagonal(0.5, -0.1835, -0.1835), 1e-3},
                Deformation{"pressed", diagonal(0.29, 0.29, -0.4), 1e-3},
                Deformation{"crushed", diagonal(0.83, 0.83, -0.7), 1e-3}, Deformation{"sheared", shear, 1e-3},
                Deformation{"compressed", diagonal(-0.017, -0.017, -0.017), 0.}})
            {
              Model        model(bricks(n, height), hardening_titanium(formulation));
              const double ratio = compute_ratio(model, displacements(model, d.gradient), d.back);
              EXPECT_LE(ratio, 1. + share_of_stress(model) + 1e-5)
                << d.name << " " << height << " " << int(formulation);
              EXPECT_GT(ratio, n == 1 ? 0.99 : 0.76) << d.name << " " << height << " " << int(formulation);
            }
  }

  // Corners moved at random by up to a quarter of an edge; points fail at a plastic strain of 0.15, and whole bricks
  // beside others that live.
  TEST(SolidStepStates, DistortedAndPartlyFailedBricks)
  {
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (const auto formulation : all_formulations)
      {
        std::size_t n_gone_beside = 0, n_partly = 0;
        double      mean = 0.;
        int         n    = 0;
        for (const bool can_fail : {false, true})
          for (const double size : {0.05, 0.15, 0.25})
            for (int sample = 0; sample < 8; ++sample)
              {
                const double height  = sample % 4 < 2 ? 1. : 0.2;
                SolidSection section = hardening_titanium(formulation);
                if (can_fail && formulation != SolidFormulation::solid_shell)
                  section.material.failure.law = FailureLaw::plastic_strain;
                section.material.failure.plastic_strain = 0.15;
                Model           model(bricks(1 + sample % 2, height), section);
                Eigen::VectorXd u(model.n_dofs());
                for (Eigen::Index d = 0; d < u.size(); ++d)
                  u[d] = size * (d % 3 == 2 ? height : 1.) * number(random);
                const double ratio    = compute_ratio(model, u, 1e-3 / size);
                const auto   n_failed = model.elements.n_failed(), n_elements = model.mesh.cells.size();
                if (n_failed == n_elements)
                  continue;
                for (std::size_t e = 0; e < n_elements; ++e)
                  n_partly += !model.elements.is_failed(e) && model.elements.n_failed_points(e) > 0;
                n_gone_beside += n_failed;
                EXPECT_LE(ratio, 1. + share_of_stress(model)) << int(formulation) << " " << size << " " << sample;
                mean += ratio;
                ++n;
              }
        EXPECT_TRUE(n_partly > 3 || formulation != SolidFormulation::b_bar);
        EXPECT_TRUE(n_gone_beside > 3 || formulation == SolidFormulation::solid_shell);
        EXPECT_GT(mean / n, 0.7) << "what safety costs grows with the distortion";
      }
  }

  // A disturbance of a cube that closes in meets the tangent of the bulk viscosity, of its quadratic part twice the
  // secant, half a step late: (K + 2 C/dt - 4 M/dt^2) v = 0 at the largest stable step. With the secant the estimate
  // was 10 % too long where opposite faces close at 1 % of the wave speed, 28 % at 3 %.
  TEST(SolidStepStates, CubesThatCloseInWithBulkViscosity)
  {
    for (const auto formulation : {SolidFormulation::one_point, SolidFormulation::b_bar})
      for (const double linear : {0., 0.06})
        for (const double quadratic : {0., 1.2})
          for (const double closing : {0., 0.01, 0.03, 0.1})
            {
              const auto make = [&](const bool is_viscous) {
                SolidSection section        = make_section(1., 0.3, formulation);
                section.linear_viscosity    = is_viscous ? linear : 0.;
                section.quadratic_viscosity = is_viscous ? quadratic : 0.;
                return std::make_unique<Model>(bricks(1, 1.), section);
              };
              const auto      model = make(true);
              const double    speed = std::sqrt(wave_modulus(model->section)), dt = 0.01 / speed;
              Eigen::VectorXd u(24);
              for (int n = 0; n < 8; ++n)
                u.segment<3>(3 * n) = -closing * speed * dt * (model->mesh.nodes[n] - Point3(.5, .5, .5));
              const auto tangent = [&](const bool is_viscous) {
                Eigen::MatrixXd K(24, 24);
                for (int d = 0; d < 24; ++d)
                  {
                    const Eigen::VectorXd small = Eigen::VectorXd::Unit(24, d) * 1e-7;
                    K.col(d) = (make(is_viscous)->move(u - small, dt) - make(is_viscous)->move(u + small, dt)) / 2e-7;
                  }
                return test::symmetric_part(K);
              };
              const Eigen::MatrixXd K = tangent(false), C = dt * (tangent(true) - K);
              double                low = 0., high = 10.;
              for (int i = 0; i < 40; ++i) // of steps h: the largest eigenvalue of M^-1 (h^2 K + 2 h C) is to be 4
                {
                  const double          h                                      = 0.5 * (low + high);
                  const Eigen::MatrixXd of_step                                = 8. * (h * h * K + 2. * h * C);
                  (test::symmetric_eigenvalues(of_step)[23] > 4. ? high : low) = h;
                }
              model->move(u, dt);
              const double ratio = model->elements.largest_stable_step() / low;
              // the stress of this hundredth of a step and the viscous pressure; 1e-5 of differences at the kink of the
              // square
              EXPECT_LE(ratio, 1. + 0.1 * closing + 1e-5) << linear << " " << quadratic << " " << closing;
              EXPECT_GT(ratio, 0.99) << linear << " " << quadratic << " " << closing;
            }
  }

  // Thin bricks with more inertia through the thickness, pressed and sheared afterwards: rotations turn the axis, and
  // the factors were those of the shape at rest.
  TEST(SolidStepStates, MassScaledBricksThatDeform)
  {
    for (const auto formulation : all_formulations)
      for (const double height : {0.5, 0.1})
        for (const double shear : {0., 0.4})
          for (const double stretch : {-0.3, 0.3})
            {
              Model             model(bricks(2, height), hardening_titanium(formulation));
              const std::size_t n = model.mesh.nodes.size();
              model.elements.scale_masses(std::vector<MassScale>(8, {2, 0.8 / (height * height)}));
              Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
              for (std::size_t e = 0; e < 8; ++e)
                for (unsigned int a = 0; a < 4; ++a)
                  {
                    const double m = model.elements.edge_mass(e), k = 0.5 * m * (0.8 / (height * height) - 1.);
                    const auto   i = model.mesh.cells[e][a], j = model.mesh.cells[e][a + 4];
                    M(i, i) += m + k;
                    M(j, j) += m + k;
                    M(i, j) -= k;
                    M(j, i) -= k;
                  }
              Eigen::Matrix3d gradient = Point3(stretch, 0., -stretch / (1. + stretch)).asDiagonal();
              gradient(0, 2)           = shear;
              const Eigen::VectorXd u  = displacements(model, gradient);
              for (int k = 0; k < 400; ++k)
                model.move(u / 400., 1e3);
              model.move(-1e-3 * u, 1e3);
              const Eigen::MatrixXd A =
                test::divide_components(exact_step::compute_tangent(model.elements, model.position), M);
              const double ratio =
                model.elements.largest_stable_step() / exact_step::compute_step(A, Eigen::VectorXd::Ones(A.rows()));
              EXPECT_LE(ratio, 1. + share_of_stress(model)) << height << " " << shear << " " << stretch;
              EXPECT_GT(ratio, 0.6) << height << " " << shear << " " << stretch;
            }
  }

  // In time: a block stays bounded 1 % below the exact step and grows without limit 2 % above it, so that what the
  // entry Time/Step scale may be raised to is exact over estimated step; recorded for the table of tests/stress.
  TEST(SolidStepStates, GrowthBeginsWhereTheTangentSays)
  {
    for (const auto formulation : all_formulations)
      for (const unsigned int n : {1u, 2u})
        {
          Model        model(bricks(n, 1.), hardening_titanium(formulation));
          const auto   mass     = compute_masses(model.elements);
          const double estimate = model.elements.largest_stable_step(),
                       exact =
                         exact_step::compute_step(exact_step::compute_tangent(model.elements, model.position), mass);
          EXPECT_LT(exact_step::compute_growth(model.elements, model.position, mass, 0.99 * exact), 100.);
          EXPECT_GT(exact_step::compute_growth(model.elements, model.position, mass, 1.02 * exact), 1e10);
          RecordProperty("largest_scale_of_formulation_" + std::to_string(int(formulation)) + "_of_" +
                           std::to_string(n),
                         std::to_string(exact / estimate));
          EXPECT_GE(exact / estimate, 1. - 1e-6);
        }
  }
} // namespace solid_step_states_test
