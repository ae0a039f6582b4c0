#include "blade_case.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

namespace birdstrike::driven_support_test
{
  namespace
  {
    constexpr double length = 0.3112, section = 0.0889 * 0.00427, density = 4430., young = 113.8e9;
    constexpr double rise = 4e-5, speed = 10.; // s, m/s

    /// A bar (no lateral strain) whose root moves along x; the end of the formula is that of a smooth start to `speed`.
    BladeParameters bar(const std::string &kind)
    {
      BladeParameters p  = test::elastic_plate(60, 1);
      p.kind             = blade_kinds().at(kind);
      p.material.poisson = "0";
      p.supports.clamped = "";
      p.supports.driven  = "0: ux = 10*if(t<4e-5, t/2 - 4e-5/(2*pi)*sin(pi*t/4e-5), t - 2e-5)";
      p.probes           = "quarter: 0.0778 0 0";
      return p;
    }

    double speed_at(const double t)
    {
      return t <= 0. ? 0. : t < rise ? 0.5 * speed * (1. - std::cos(M_PI * t / rise)) : speed;
    }

    double moved_at(const double t)
    {
      return t <= 0.    ? 0.
             : t < rise ? speed * (0.5 * t - rise / (2. * M_PI) * std::sin(M_PI * t / rise))
                        : speed * (t - 0.5 * rise);
    }
  } // namespace

  // d'Alembert: u(x, t) = u_0(t - x/c) until the tip reflects, c = sqrt(E/rho); the root gives the power rho c A v_0^2
  // and the force rho c A v_0. The rise is ten elements long: dispersion of less than 1 %.
  TEST(DrivenSupport, SendsTheExactWaveIntoABar)
  {
    for (const char *kind : {"shell", "solid"})
      {
        ThreadPool   pool(1);
        const auto   blade = make_blade(bar(kind), pool);
        const double c = std::sqrt(young / density), end = 0.8 * length / c;
        const double limit = 0.5 * blade->step_limit().value;
        const auto   n     = static_cast<unsigned int>(std::ceil(end / limit));
        double       work = 0., impulse = 0.;
        for (unsigned int k = 0; k < n; ++k)
          {
            test::advance(*blade, end / n, 1);
            const double v = speed_at((k + 0.5) * end / n);
            work += density * c * section * v * v * end / n;
            impulse += density * c * section * v * end / n;
          }
        const auto           probe  = blade->probes()[0];
        const EnergyReport   energy = blade->energies();
        const MomentumReport m      = blade->momenta();
        EXPECT_NEAR(probe.displacement[0] / moved_at(end - 0.0778 / c), 1., 5e-3) << kind;
        EXPECT_NEAR(probe.velocity[0] / speed_at(end - 0.0778 / c), 1., 1e-2) << kind;
        EXPECT_NEAR(energy.external_work / work, 1., 1e-2) << kind;
        EXPECT_NEAR(-m.support_impulse[0] / impulse, 1., 1e-2) << kind;
        // the ledger: what stresses store is their work within the square of the strains, 2e-3
        EXPECT_NEAR(energy.total(), energy.external_work, 1e-6 * energy.external_work) << kind;
        EXPECT_NEAR(m.momentum[0] + m.support_impulse[0], 0., 1e-10 * impulse) << kind;
      }
  }

  // Round-off of some thousand steps, with all that books work at a driven node: loads, damping, changing steps,
  // rotation.
  TEST(DrivenSupport, ClosesTheLedger)
  {
    for (const char *kind : {"shell", "solid"})
      {
        BladeParameters p  = test::elastic_plate(10, 3);
        p.kind             = blade_kinds().at(kind);
        p.supports.clamped = "";
        p.supports.driven  = "0: uz = 2e-3*sin(2000*t); 0: ux uy = 0";
        if (p.kind == BladeKind::shell)
          p.supports.driven += "; 0: ry = 0.02*(1-cos(3000*t))";
        p.loads.pressure            = "1e5*x";
        p.loads.damping             = 300.;
        p.loads.pressure_boundaries = "0, 5";
        ThreadPool   pool(1);
        const auto   blade  = make_blade(p, pool);
        const double before = test::balance(*blade), limit = blade->step_limit().value;
        const double start = blade->momenta().momentum[2];
        for (const double share : {0.5, 0.8, 0.3})
          test::advance(*blade, share * limit, 700);
        const EnergyReport   energy = blade->energies();
        const MomentumReport m      = blade->momenta();
        EXPECT_GT(std::abs(energy.external_work), 0.1) << kind;
        EXPECT_NEAR(test::balance(*blade), before, 2e-4 * energy.total()) << kind;
        EXPECT_NEAR(m.momentum[2] - start, m.external_impulse[2] - m.support_impulse[2], 1e-9) << kind;
      }
  }

  TEST(DrivenSupport, RefusesWhatItCannotDo)
  {
    ThreadPool pool(1);
    for (const char *text : {"0: uz", "0: uz = 1e-3", "9: uz = t", "0: uq = t", "0: uz = 1e-3*sin("})
      {
        BladeParameters p = test::elastic_plate(4, 2);
        p.supports.driven = text;
        EXPECT_THROW(make_blade(p, pool), InputError) << text;
      }
    BladeParameters p = test::elastic_plate(4, 2);
    p.supports.driven = "1: uy = t";
    p.is_halved       = true;
    EXPECT_THROW(make_blade(p, pool), InputError);
    p                     = test::elastic_plate(4, 2);
    p.kind                = BladeKind::solid;
    p.mass_scaling.method = MassScalingMethod::selective;
    p.supports.driven     = "1: uz = t";
    EXPECT_THROW(make_blade(p, pool), InputError);
  }
  // What is held stays so; an entry that is left without anything to drive would be one that is not read.
  TEST(DrivenSupport, ThatDrivesNothingIsRefused)
  {
    ThreadPool pool(1);
    const auto said_of = [&](const char *clamped, const char *driven, const char *free) {
      BladeParameters p  = bar("shell");
      p.supports.clamped = clamped;
      p.supports.driven  = driven;
      p.supports.free    = free;
      try
        {
          make_blade(p, pool);
        }
      catch (const InputError &error)
        {
          return std::string(error.what());
        }
      return std::string();
    };
    EXPECT_EQ(said_of("", "0: ux = 5*t; 0: uy = t", "1"), "");
    EXPECT_EQ(said_of("0", "2: ux = 5*t", ""), "") << "an edge that shares a corner with what is clamped";
    EXPECT_NE(said_of("0", "0: ux = 5*t", "").find("Driven: '0: ux = 5*t' drives nothing"), std::string::npos);
    EXPECT_NE(said_of("", "1: uz = t; 1: uz = 2*t", "").find("Driven: '1: uz = 2*t' drives nothing"),
              std::string::npos);
    EXPECT_NE(said_of("0", "", "0").find("Free = 0: boundary 0 is constrained by Clamped"), std::string::npos);
  }
} // namespace birdstrike::driven_support_test
