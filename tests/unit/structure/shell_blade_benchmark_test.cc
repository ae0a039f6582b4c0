#include "../record.h"
#include "blade_case.h"
#include "frequencies.h"

#include "structure/deformable_blade.h"

#include <gtest/gtest.h>

#include <algorithm>

/// Published and independently computed cases for the whole shell blade: mesh, mass, supports, elements, stepping.
namespace birdstrike::shell_blade_benchmark_test
{
  namespace
  {
    using test::advance;
    using test::balance;
    using test::elastic_plate;
    using test::natural_frequencies;

    // Benchmark A4, Mindlin plate (Ritz, converged): 1 % in bending, 3 % in torsion on 28 x 8 elements.
    TEST(ShellBladeBenchmark, CantileverPlateFrequencies)
    {
      const double exact[6]     = {36.863, 230.15, 254.00, 645.67, 791.08, 1268.3}; // B1 B2 T1 B3 T2 B4
      const double tolerance[6] = {0.01, 0.01, 0.03, 0.01, 0.03, 0.01};
      for (const std::string formulation : {"physical", "fully integrated"})
        {
          auto p                = elastic_plate(28, 8);
          p.element.formulation = element_formulations().at(formulation);
          const auto found      = natural_frequencies(p);
          for (unsigned int k = 0; k < 6; ++k)
            {
              record(formulation + " mode_" + std::to_string(k + 1), found[k]);
              EXPECT_NEAR(found[k] / exact[k], 1., tolerance[k]) << formulation << ", mode " << k + 1;
            }
        }
    }

    // Second order in the element size (A4): the error of the first bending mode falls by four, two allowed for the
    // limit's own digits.
    TEST(ShellBladeBenchmark, FrequenciesConverge)
    {
      const auto coarse = natural_frequencies(elastic_plate(7, 2)), fine = natural_frequencies(elastic_plate(14, 4));
      EXPECT_LT(std::abs(fine[0] - 36.863), 0.5 * std::abs(coarse[0] - 36.863) + 0.02);
      EXPECT_LT(std::abs(fine[1] - 230.15), 0.5 * std::abs(coarse[1] - 230.15) + 0.2);
    }

    // The same first mode from the motion: the static shape under a tip load is close to it, and periods are counted
    // between zero crossings of the tip. 1 % as above.
    TEST(ShellBladeBenchmark, FirstModeInTime)
    {
      ThreadPool pool;
      auto       p             = elastic_plate(14, 4);
      p.loads.initial_velocity = "0; 0; 0.1*(1.5*(x/0.3112)^2 - 0.5*(x/0.3112)^3)";
      ShellBlade          blade(p, pool);
      const double        dt = 0.9 * blade.step_limit().value;
      std::vector<double> crossings;
      double              last = 0.;
      for (unsigned int step = 1; crossings.size() < 11; ++step)
        {
          advance(blade, dt, 1);
          const double tip = blade.tip_deflection().mid_chord;
          if (step > 1 && tip * last < 0.)
            crossings.push_back(dt * (step - tip / (tip - last)));
          last = tip;
          ASSERT_LT(step * dt, 0.3);
        }
      const double frequency = 5. / (crossings[10] - crossings[0]);
      EXPECT_NEAR(frequency / 36.863, 1., 0.01);
    }

    struct Strip
    {
      double initial, largest, time_of_largest, final, hourglass, worst_balance;
    };

    /// Benchmark A10: half of a clamped 6061-T6 strip, 5020 in/s over its middle.
    BladeParameters strip_parameters(const unsigned int n_span, const unsigned int n_chord)
    {
      const double    inch = 0.0254, psi = 6894.757;
      BladeParameters p;
      p.mesh.length            = 5. * inch;
      p.mesh.chord             = 1.2 * inch;
      p.mesh.n_span            = n_span;
      p.mesh.n_chord           = n_chord;
      p.thickness.value        = std::to_string(0.125 * inch);
      p.material.density       = std::to_string(2.61e-4 * 1.0686895e7);
      p.material.young         = std::to_string(1.04e7 * psi);
      p.material.poisson       = std::to_string(0.3);
      p.material.hardening     = "perfect";
      p.material.yield         = std::to_string(41400. * psi);
      p.supports.clamped       = "1";
      p.supports.held          = "0: ux ry rz";
      p.supports.tip           = "0";
      p.loads.initial_velocity = "0; 0; if(x < 0.02541, 127.508, 0)";
      return p;
    }

    /// 1.2 ms of it; lengths in inches.
    Strip run_strip(const unsigned int n_span, const unsigned int n_chord, const std::string &formulation)
    {
      const double    inch  = 0.0254;
      BladeParameters p     = strip_parameters(n_span, n_chord);
      p.element.formulation = element_formulations().at(formulation);
      ThreadPool   pool;
      ShellBlade   blade(p, pool);
      const double dt       = 0.8 * blade.step_limit().value;
      const auto   n_steps  = static_cast<unsigned int>(1.2e-3 / dt);
      unsigned int n_summed = 0;
      Strip        strip{balance(blade), 0., 0., 0., 0., 0.};
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          advance(blade, dt, 1);
          const double w = blade.tip_deflection().mid_chord / inch;
          if (w > strip.largest)
            {
              strip.largest         = w;
              strip.time_of_largest = step * dt;
            }
          if (4 * step > 3 * n_steps)
            {
              strip.final += w;
              ++n_summed;
            }
          strip.worst_balance = std::max(strip.worst_balance, std::abs(balance(blade) / strip.initial - 1.));
        }
      strip.final /= n_summed;
      strip.hourglass = blade.energies().hourglass / strip.initial;
      return strip;
    }

    // On 20 x 2 elements a Belytschko-Tsay peer finds 0.756 in at most and 0.725 in at rest; another code and another
    // stabilisation: 3 %. The target 0.70 +- 0.03 in is that of the strip, so of a mesh whose nodal patch is less wide.
    TEST(ShellBladeBenchmark, ImpulsivelyLoadedStrip)
    {
      for (const std::string formulation : {"Belytschko-Tsay", "physical", "fully integrated"})
        {
          const Strip coarse = run_strip(20, 2, formulation), fine = run_strip(40, 4, formulation);
          EXPECT_NEAR(coarse.initial, 555.0 * 0.1129848, 0.1);
          EXPECT_NEAR(coarse.largest / 0.756, 1., 0.03);
          EXPECT_NEAR(coarse.final / 0.725, 1., 0.03);
          EXPECT_NEAR(fine.largest / 0.738, 1., 0.03);
          EXPECT_NEAR(fine.final, 0.70, 0.03);
          EXPECT_LT(std::abs(coarse.hourglass), 0.005);
          EXPECT_EQ(coarse.hourglass == 0., formulation == "fully integrated");
          // energies from stresses: a law in rates is no potential at plastic strains of a fifth, found 0.53 %
          EXPECT_LT(coarse.worst_balance, 8e-3);
          record(formulation + " peak", coarse.largest);
          record(formulation + " final", fine.final);
        }
    }

    /// Present distance (m) of the two ends of the plate's middle line.
    double middle_length(const NodeArrays &nodes)
    {
      const double *a = nodes.position, *b = nodes.position;
      for (std::size_t n = 0; n < nodes.n; ++n)
        if (std::abs(nodes.reference[3 * n + 1]) < 1e-12)
          {
            if (nodes.reference[3 * n] < 1e-12)
              a = nodes.position + 3 * n;
            if (nodes.reference[3 * n] > 0.31119)
              b = nodes.position + 3 * n;
          }
      return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }

    // Benchmark B6 and trap 0.1: three turns at 2000 rad/s about the plate's normal and about a tumbling axis. Strains
    // on the end geometry would shrink it by 6.6 % and lose 15 % of the energy; a sudden spin stretches it by twice the
    // static omega^2 rho L^2/(12 E) = 0.126 %.
    TEST(ShellBladeBenchmark, SpinningPlate)
    {
      for (const std::string spin : {"0; 0; 2000", "1154.7; 1154.7; 1154.7"})
        {
          auto p                   = test::free_plate(14, 4);
          p.loads.initial_spin     = spin;
          p.loads.initial_velocity = spin[0] == '0' ? "0; -311.2; 0" : "0; -179.67132; 179.67132";
          ThreadPool   pool;
          ShellBlade   blade(p, pool);
          const double dt = 0.9 * blade.step_limit().value, initial = balance(blade);
          const auto   nodes  = blade.nodes();
          const auto   length = [&nodes] { return middle_length(nodes); };
          const double start  = length();
          double       worst = 0., longest = start, shortest = start;
          const auto   before = blade.momenta();
          for (double t = 0.; t < 3. * 2. * M_PI / 2000.; t += dt)
            {
              advance(blade, dt, 1);
              worst    = std::max(worst, std::abs(balance(blade) / initial - 1.));
              longest  = std::max(longest, length());
              shortest = std::min(shortest, length());
            }
          const auto after = blade.momenta();
          double     drift = 0., size = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              drift = std::hypot(drift, after.angular_momentum[d] - before.angular_momentum[d]);
              size  = std::hypot(size, before.angular_momentum[d]);
            }
          EXPECT_LT(worst, 1e-4);
          EXPECT_LT(longest / start - 1., 2.5 * 1.26e-3);
          EXPECT_GT(shortest / start - 1., -0.5e-3);
          EXPECT_LT(drift, 1e-12 * size);
        }
    }

    // Benchmark E3, force of a bird on a rigid wall (100.5 g, 177.4 m/s) at 70 % of the span, no feedback; the peer's
    // 14 x 4 elements. Its own meshes agree within 2 % from 2 ms on, this pressure patch is made of whole elements: 5
    // %.
    TEST(ShellBladeBenchmark, PrescribedBirdForce)
    {
      for (const std::string formulation : {"physical", "fully integrated"})
        {
          SCOPED_TRACE(formulation);
          auto p                = elastic_plate(28, 8);
          p.element.formulation = element_formulations().at(formulation);
          p.material.hardening  = "linear";
          p.material.yield      = "880e6";
          p.material.modulus    = "1.25e9";
          // Force 38.869 kN for 458.69 us on ten elements of 11.114 x 11.1125 mm whose centroids lie in the disc.
          const double area = 10. * (0.3112 / 28) * (0.0889 / 8), force = 38869.;
          p.loads.pressure =
            "if((x-0.21784)^2 + y^2 < 0.02034^2 && t < 458.69e-6, " + std::to_string(force / area) + ", 0)";
          ThreadPool   pool;
          ShellBlade   blade(p, pool);
          const double dt = 0.9 * blade.step_limit().value;
          double       tip[2];
          advance(blade, dt, std::lround(2e-3 / dt));
          tip[0] = 1e3 * blade.tip_deflection().mid_chord;
          advance(blade, dt, std::lround(3e-3 / dt));
          tip[1]            = 1e3 * blade.tip_deflection().mid_chord;
          const auto energy = blade.energies();
          record(formulation + " 2 ms", tip[0]);
          record(formulation + " 5 ms", tip[1]);
          EXPECT_NEAR(tip[0] / 91.3, 1., 0.05);
          EXPECT_NEAR(tip[1] / 257.6, 1., 0.05);
          EXPECT_NEAR(blade.momenta().external_impulse[2] / 17.83, 1., 0.01); // less the cosine of the follower load
          EXPECT_GT(energy.plastic, 0.5 * energy.external_work);
          EXPECT_LT(std::abs(balance(blade)), 1e-4 * energy.external_work);
        }
    }
  } // namespace
} // namespace birdstrike::shell_blade_benchmark_test
