#include "../record.h"
#include "strike_harness.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace birdstrike;
using namespace birdstrike::test;

// A free plate hit by a long liquid column, laterally confined: the acoustic solution p = rho c v exp(-t/tau),
// w' = v (1 - exp(-t/tau)), tau = M/(rho c). 4.27 mm of titanium, M = 18.9161 kg/m^2, v = 10 m/s. Exact up to the
// nonlinearity of the liquid (u/c below 1 %).
TEST(FreePlate, FollowsTheAcousticSolution)
{
  const double dx = 1e-3, width = 6. * dx, mass_per_area = 18.9161, v = 10.;
  const double density = 950., c = std::sqrt(2.2e9 / density), tau = mass_per_area / (density * c);
  EXPECT_NEAR(tau, 13.085e-6, 1e-9);

  std::ostringstream text;
  text.precision(17);
  text << "subsection Blade\n set Kind = rigid\n subsection Rigid\n set Length = 0.02\n set Width = 0.02\n"
       << " set Motion = free along normal\n set Mass = " << mass_per_area * width * width << "\n end\n end\n"
       << "subsection Bird\n set Shape = slab\n set Slab lengths = " << width << ", " << width << ", 0.08\n"
       << " set Periodic directions = xy\n set Density = 950\n set Particle spacing = " << dx << "\n"
       << " set Velocity = 0, 0, 10\n set Aim point = 0, 0, -0.05\n set Retire = false\n"
       << " subsection Equation of state\n set Type = linear\n set Bulk modulus = 2.2e9\n end\n end\n"
       << "subsection Time\n set End time = " << 3.5 * tau << "\n end\n"
       << "subsection Output\n set History interval = 0\n end\n";
  const Strike run = run_text(text.str());

  record("w at 2 tau", value_at(run.curves, "tip_mid_chord", 2. * tau));
  record("w at 3 tau", value_at(run.curves, "tip_mid_chord", 3. * tau));
  record("impulse at 3 tau", value_at(run.curves, "contact_impulse_z", 3. * tau) / (width * width));
  // 3 % in the displacement: the particle column touches half a spacing early or late, and c is that of the lattice.
  EXPECT_NEAR(value_at(run.curves, "tip_mid_chord", tau) / 0.048135e-3, 1., 0.05);
  EXPECT_NEAR(value_at(run.curves, "tip_mid_chord", 2. * tau) / 0.148554e-3, 1., 0.03);
  EXPECT_NEAR(value_at(run.curves, "tip_mid_chord", 3. * tau) / 0.268206e-3, 1., 0.03);
  // impulse up to 3 tau: M v (1 - e^-3)
  const double impulse = value_at(run.curves, "contact_impulse_z", 3. * tau) / (width * width);
  EXPECT_NEAR(impulse / (mass_per_area * v * (1. - std::exp(-3.))), 1., 0.01);
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 1.5e-3); // found 0.06 %
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
}
