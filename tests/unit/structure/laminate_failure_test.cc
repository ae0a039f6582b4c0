#include "blade_case.h"
#include "laminate_case.h"

#include "structure/deformable_blade.h"
#include "structure/elements/shell/laminate/failure.h"

#include <birdstrike/core/archive.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace laminate_failure_test
{
  using namespace laminate_case;

  // Chang and Chang's failure of plies: where it begins, what is left, and that its energy is booked.
  namespace
  {
    Ply brittle()
    {
      Ply ply      = carbon();
      ply.strength = {2e9, 1.2e9, 50e6, 200e6, 80e6, 0.};
      return ply;
    }

    ShellSection brittle_section(const std::vector<double> &angles, const ShellFormulation formulation,
                                 const double degradation_time = 20e-6)
    {
      ShellSection section;
      section.formulation        = formulation;
      auto laminate              = std::make_shared<Laminate>(brittle(), equal_plies(angles), Point3::UnitX());
      laminate->degradation_time = degradation_time;
      section.laminate           = laminate;
      return section;
    }

    /// What a square of 10 mm, 1 mm thick, does as its sides are moved: mean force per width (N/m) along the first or,
    /// in shear, across it.
    struct Square
    {
      Model           model;
      double          work = 0.;
      Eigen::VectorXd force;

      explicit Square(const ShellSection &section)
        : model(make_grid(1, 1, [](const double x, const double y) { return Point3(0.01 * x, 0.01 * y, 0.); }), 1e-3,
                section)
        , force(Eigen::VectorXd::Zero(24))
      {
      }

      /// Engineering strains of one step, of 1 us unless told otherwise.
      void strain(const double xx, const double yy, const double xy, const double dt = 1e-6)
      {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
        for (std::size_t n = 0; n < 4; ++n)
          {
            const Point3 &x = model.mesh.nodes[n];
            u[6 * n]        = xx * x[0] + 0.5 * xy * x[1];
            u[6 * n + 1]    = yy * x[1] + 0.5 * xy * x[0];
          }
        const Eigen::VectorXd next = model.move(u, dt);
        work -= 0.5 * (force + next).dot(u);
        force = next;
      }
      std::array<double, 3> stress() const ///< mean, Pa, in the element's frame, along x
      {
        auto s = model.elements.state(0).membrane_force;
        for (double &n : s)
          n /= 1e-3;
        return s;
      }
      double booked() const
      {
        return model.elements.elastic_energy() + model.elements.hourglass_energy() + model.elements.plastic_work() +
               model.elements.eroded_energy();
      }
    };

    enum Mode
    {
      fibre_tension,
      fibre_compression,
      matrix_tension,
      matrix_compression
    };
  } // namespace

  // Each mode in a stress of its own: the largest stress is the strength, to the strain of a step. Shear is opened a
  // little: a sheared square contracts to second order, which would count as compression.
  TEST(LaminateFailure, BeginsAtTheStrengths)
  {
    struct Case
    {
      Mode   mode;
      double xx, yy, xy;
      int    component;
      double strength;
    };
    const double nu = 0.3, nu_21 = 0.3 * 9. / 138.;
    for (const auto formulation : covariant_formulations)
      for (const Case &of :
           {Case{fibre_tension, 1., -nu, 0., 0, 2e9}, Case{fibre_compression, -1., nu, 0., 0, -1.2e9},
            Case{matrix_tension, -nu_21, 1., 0., 1, 50e6}, Case{matrix_compression, nu_21, -1., 0., 1, -200e6},
            Case{matrix_tension, 0., 0.01, 1., 2, 80e6}})
        {
          Square       square(brittle_section({0.}, formulation));
          const double step = 2e-5;
          double       peak = 0.;
          for (int k = 0; k < 1500 && square.model.elements.failed_shares(0)[of.mode] == 0.; ++k)
            {
              square.strain(step * of.xx, step * of.yy, step * of.xy);
              if (square.model.elements.failed_shares(0)[of.mode] == 0.)
                peak = square.stress()[of.component];
            }
          // resultants are those of the deformed area: up to 2 % strain
          EXPECT_NEAR(peak / of.strength, 1., 0.025) << name_of(formulation) << of.mode;
          const auto shares = square.model.elements.failed_shares(0);
          for (int m = 0; m < 4; ++m)
            EXPECT_EQ(shares[m], m == of.mode ? 1. : 0.) << name_of(formulation) << of.mode << m;
        }
  }

  // Torn fibres leave nothing, and the element goes; crushed fibres leave the matrix until they count as failed; a
  // cracked matrix leaves the fibres. All that the forces have done is booked.
  TEST(LaminateFailure, BooksWhatPliesRelease)
  {
    for (const auto formulation : covariant_formulations)
      for (const std::vector<double> &angles : {std::vector<double>{0.}, {0., 90.}, {0., 45., -45., 90.}})
        for (const auto &[xx, yy, xy] : {std::tuple(1., 0., 0.), {-1., 0., 0.}, {0.3, 0.2, 1.}, {0., 1., 0.}})
          {
            Square square(brittle_section(angles, formulation));
            double largest = 0.;
            for (int k = 0; k < 3000 && square.model.elements.n_failed() == 0; ++k)
              {
                square.strain(2e-5 * xx, 2e-5 * yy, 2e-5 * xy);
                largest = std::max(largest, square.work);
                EXPECT_NEAR(square.booked(), square.work, 2e-4 * largest) << name_of(formulation) << angles.size() << k;
              }
            EXPECT_GT(square.model.elements.eroded_energy(), 0.02 * largest) << name_of(formulation) << angles.size();
            EXPECT_GE(square.model.elements.elastic_energy(), 0.);
            if (square.model.elements.n_failed() > 0)
              {
                EXPECT_EQ(square.force.norm(), 0.);
                EXPECT_EQ(square.model.elements.elastic_energy(), 0.);
              }
          }
  }

  // The time that a ply takes to fail is not counted in steps: the same path in steps of 2, 1 and 1/8 us releases the
  // same to the first order, and at once is at once. While its stiffness falls from 1 to 0 over the time T, fibres
  // pulled on at the rate r from the strain e_0 = X_t/E_1 release E_1 (e_0^2/2 + e_0 r T/2 + (r T)^2/6) by volume.
  TEST(LaminateFailure, DegradesOverATimeWhateverTheSteps)
  {
    for (const auto formulation : covariant_formulations)
      for (const double time : {40e-6, 0.})
        {
          std::vector<double> released;
          for (const double dt : {2e-6, 1e-6, 0.125e-6})
            {
              Square       square(brittle_section({0.}, formulation, time));
              const double rate = 20., along = 0.3; // 1/s
              while (square.model.elements.n_failed() == 0)
                square.strain(rate * dt, -along * rate * dt, 0., dt);
              released.push_back(square.model.elements.eroded_energy() / (0.01 * 0.01 * 1e-3));
            }
          const double rt = 20. * time, e_0 = 2e9 / 138e9,
                       expected = 138e9 * (0.5 * e_0 * e_0 + 0.5 * e_0 * rt + rt * rt / 6.);
          EXPECT_NEAR(released.back() / expected, 1., 0.02) << name_of(formulation) << time;
          for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(released[k] / released[2], 1., k == 0 ? 0.01 : 0.005) << name_of(formulation) << time << k;
        }
  }

  // Fibres along tear at X_t/E_1; those across do not. What has failed counts by its thickness, however many plies it
  // is written as.
  TEST(LaminateFailure, AnElementGoesByTheThicknessThatHasFailed)
  {
    for (const auto formulation : covariant_formulations)
      for (const auto &[along, n_along, n_across, goes] :
           {std::tuple(0.2, 4, 1, false), {0.6, 1, 5, true}, {0.5, 1, 1, true}, {0.5, 3, 7, true}})
        {
          std::vector<PlyLayer> plies;
          for (int k = 0; k < n_along; ++k)
            plies.push_back({0., along / n_along});
          for (int k = 0; k < n_across; ++k)
            plies.push_back({90., (1. - along) / n_across});
          auto laminate              = std::make_shared<Laminate>(brittle(), plies, Point3::UnitX());
          laminate->degradation_time = 20e-6;
          laminate->failed_share     = 0.5;
          ShellSection section;
          section.formulation = formulation;
          section.laminate    = laminate;
          Square square(section);
          while (square.work == 0. || square.model.elements.failed_shares(0)[fibre_tension] == 0.)
            square.strain(2e-5, 0., 0.);
          for (int k = 0; k < 25; ++k)
            square.strain(2e-5, 0., 0.);
          EXPECT_EQ(square.model.elements.is_failed(0), goes) << name_of(formulation) << along << n_along;
          if (!goes)
            {
              EXPECT_NEAR(square.model.elements.failed_shares(0)[fibre_tension], along, 1e-12);
            }
        }
  }

  TEST(LaminateFailure, ACrackedMatrixLeavesTheFibres)
  {
    for (const auto formulation : covariant_formulations)
      {
        Square square(brittle_section({0., 90.}, formulation));
        while (square.model.elements.failed_shares(0)[matrix_tension] == 0.)
          square.strain(2e-5, 0., 0.);
        for (int k = 0; k < 20; ++k)
          square.strain(2e-5, 0., 0.);
        EXPECT_NEAR(square.model.elements.failed_shares(0)[matrix_tension], 0.5, 1e-12) << "the plies across";
        const double before = square.stress()[0];
        square.strain(1e-5, 0., 0.);
        // half of the section is fibres along, with their own matrix
        const double q11 = 138e9 / (1. - 0.09 * 9. / 138.);
        EXPECT_NEAR((square.stress()[0] - before) / 1e-5 / (0.5 * q11), 1., 0.02) << name_of(formulation);
      }
  }

  // A quick blow on a strip of plies: some fail, some elements go, and the balance holds. Half way the state is
  // archived, and goes on to the last bit.
  TEST(LaminateFailure, ABladeKeepsItsBalanceAndGoesOnFromAnArchive)
  {
    for (const ShellFormulation formulation : covariant_formulations)
      {
        BladeParameters p           = test::elastic_plate(14, 5);
        p.laminate.plies            = "[0/45/-45/90]s";
        p.laminate.ply              = brittle();
        p.laminate.degradation_time = 7e-6;
        p.laminate.smallest_step    = 0.1;
        p.laminate.failed_share     = 0.3;
        p.element.formulation       = formulation;
        p.loads.initial_velocity    = "250 * min(1, max(0, x/0.05 - 2)); 0; 60*(x/0.3112)^2";
        ThreadPool   pool(2);
        const auto   blade  = make_blade(p, pool);
        const double before = test::balance(*blade), dt = 0.3 * blade->largest_stable_step();
        test::advance(*blade, dt, 300);
        ArchivedState state;
        Archive       written = Archive::writing(state);
        blade->archive(written);
        const auto again = make_blade(p, pool);
        Archive    read  = Archive::reading(state);
        again->archive(read);
        test::advance(*blade, dt, 300);
        test::advance(*again, dt, 300);
        const FailureReport failure = blade->failure();
        EXPECT_GT(failure.n_elements, 0u) << name_of(formulation);
        EXPECT_GT(failure.matrix_mass, 0.);
        EXPECT_GT(failure.fibre_mass, 0.);
        EXPECT_GT(blade->energies().eroded, 0.01 * before);
        EXPECT_NEAR(test::balance(*blade) / before, 1., 3e-3) << name_of(formulation);
        ArchivedState one, other;
        Archive       of_one = Archive::writing(one), of_other = Archive::writing(other);
        blade->archive(of_one);
        again->archive(of_other);
        EXPECT_EQ(find_difference(one, other), "");
      }
  }

  // Plies whose matrix is gone carry nothing across: the element goes where its own plies are strained by the limit,
  // opened, crushed or sheared, and all work is booked. One ply whose fibres hold the strain keeps it.
  TEST(LaminateFailure, TakesAwayWhatFailsByMatrixAlone)
  {
    struct Case
    {
      std::vector<double> angles;
      double              xx, yy, xy;
      bool                breaks;
    };
    constexpr double limit = 0.1, step = 1e-4;
    for (const auto formulation : covariant_formulations)
      for (const Case &of :
           {Case{{90.}, 1., 0., 0., true}, Case{{90.}, -1., 0., 0., true}, Case{{90., 90.}, 0., 0.01, 1., true},
            Case{{0., 90.}, 0., 1., 0., true}, Case{{90.}, 0., 1e-2, 0., false}})
        {
          ShellSection section         = brittle_section(of.angles, formulation);
          auto         plies           = std::make_shared<Laminate>(*section.laminate);
          plies->matrix_failure_strain = limit;
          section.laminate             = plies;
          Square square(section);
          double strain = 0., largest = 0.;
          for (int k = 0; k < 1500 && square.model.elements.n_failed() == 0; ++k)
            {
              square.strain(step * of.xx, step * of.yy, step * of.xy);
              strain += step * std::max({std::abs(of.xx), std::abs(of.yy), std::abs(of.xy)});
              largest = std::max(largest, square.work);
              EXPECT_NEAR(square.booked(), square.work, 1e-3 * largest);
            }
          EXPECT_EQ(square.model.elements.n_failed(), of.breaks ? 1U : 0U) << name_of(formulation) << of.angles.size();
          if (of.breaks) // increments are of the present length: logarithms, 5 % of a tenth
            {
              EXPECT_NEAR(strain / limit, 1., 0.1) << name_of(formulation) << of.angles.size();
            }
        }
  }

  // Coupons of one direction, pulled or pressed to a strain of a half: the peak of their stress is Chang and Chang's,
  // the run reaches its end, and the step stays of its size.
  TEST(LaminateFailure, CouponsThatFailByMatrixAloneAreResults)
  {
    struct Case
    {
      const char *plies;
      double      sign, strength; // Pa
    };
    // Y_t; off axis c = cos, s = sin: (s^2/Y_t)^2 + (c s/S)^2 = 1/sigma^2; pressed, with b = s^2, d = c s:
    // (b/2S)^2 sigma^2 - ((Y_c/2S)^2 - 1) b sigma/Y_c ... = 1
    const auto pressed = [](const double angle) {
      const double c = std::cos(angle * M_PI / 180.), s = std::sin(angle * M_PI / 180.), Yc = 200e6, S = 80e6;
      const double square = std::pow(s * s / (2. * S), 2) + std::pow(c * s / S, 2),
                   linear = (std::pow(Yc / (2. * S), 2) - 1.) * s * s / Yc;
      return (linear + std::sqrt(linear * linear + 4. * square)) / (2. * square);
    };
    for (const Case &of : {Case{"[90]", 1., 50e6}, Case{"[90]", -1., pressed(90.)}, Case{"[45]", -1., pressed(45.)},
                           Case{"[60]", -1., pressed(60.)}})
      {
        BladeParameters p           = birdstrike::test::elastic_plate(10, 4);
        p.mesh.length               = 0.05;
        p.mesh.chord                = 0.02;
        p.thickness.value           = "0.002";
        p.laminate                  = LaminateParameters::of_blade();
        p.laminate.plies            = of.plies;
        p.laminate.ply              = brittle();
        p.laminate.degradation_time = 5e-6;
        p.supports.clamped          = "";
        p.supports.tip              = "";
        p.supports.driven           = fmt::format("0: ux = 0; 1: ux = {}*2000*t^2", of.sign);
        p.supports.held_boxes       = "-1 -1 -1 1 1 1: uz rx ry";
        ThreadPool                   pool(1);
        ShellBlade                   blade(p, pool);
        const birdstrike::NodeArrays nodes = blade.nodes();
        const double                 dt    = 0.9 * blade.largest_stable_step();
        const auto                   force = [&] { // of the elements on the end that rests
          double sum = 0.;
          for (std::size_t n = 0; n < nodes.n; ++n)
            sum += nodes.reference[3 * n] < 1e-6 ? nodes.force[6 * n] : 0.;
          return of.sign * sum;
        };
        double peak = 0.;
        for (double time = 0.; time < 3.5e-3; time += 20. * dt)
          {
            birdstrike::test::advance(blade, dt, 20);
            peak = std::max(peak, force());
            ASSERT_GT(blade.largest_stable_step(), 0.3 * dt) << of.plies << of.sign << ' ' << time;
          }
        // pulled at 1.5 m/s when it breaks: inertia of a third of a MPa, and steps of 20 between samples
        EXPECT_NEAR(peak / (0.02 * 0.002 * of.strength), 1., 0.05) << of.plies << of.sign;
        EXPECT_GT(blade.failure().n_elements, 3U) << of.plies << of.sign;
      }
  }
} // namespace laminate_failure_test
