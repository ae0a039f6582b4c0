#include "strike_harness.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

#include <algorithm>

// Small scenes that the balance must tell apart: right ones that are none of its business, wrong ones whose error an
// identity would hide.

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  std::string blade_alone(const std::string &blade, const std::string &time)
  {
    return "subsection Time\n" + time + "\nend\nsubsection Output\n set History interval = 0\nend\nsubsection Blade\n" +
           blade + "\nend\nsubsection Bird\n set Enabled = false\nend\n";
  }

  const std::string elastic =
    " subsection Material\n set Name = custom\n set Density = 2700\n set Young's modulus = 70e9\n"
    " set Poisson's ratio = 0\n set Hardening = elastic\n end\n";

  /// A bar of solid-shells, free, that is pushed into itself.
  std::string crushed_bar(const std::string &speed, const std::string &mesh)
  {
    return blade_alone(" set Kind = solid\n subsection Mesh\n set Length = 0.1\n set Chord = 0.02\n" + mesh +
                         " end\n subsection Thickness\n set Value = 0.005\n end\n subsection Material\n"
                         " set Name = Al 6061-T6\n end\n subsection Element\n set Formulation = solid-shell\n end\n"
                         " subsection Loads\n set Initial velocity = -" +
                         speed + "*x/0.1; 0; 0\n end\n",
                       " set End time = 0.00016");
  }
} // namespace

// A sheet that vibrates at two elements a wave, the fastest motion there is: at 0.8 of the stable step leapfrog's
// kinetic energy at whole steps and its half-step product differ by half of all energy. The last step is short, which
// changes the product at once: a third of the energy seemed lost. The step follows the sheet's own strain, in phase
// with it, which takes 0.01 % of the energy a step at 1 m/s: half of that speed leaves room for what is tested.
TEST(Ledger, AShortLastStepLosesNothing)
{
  const Strike run = run_text(blade_alone(
    " set Kind = shell\n subsection Mesh\n set Length = 0.1\n set Chord = 0.01\n set Elements along span = 20\n"
    " set Elements along chord = 2\n end\n subsection Thickness\n set Value = 0.001\n end\n" +
      elastic +
      " subsection Supports\n set Clamped =\n set Free = 0,1,2,3\n end\n subsection Loads\n"
      " set Initial velocity = 0.5*cos(628.3185307179585*x); 0; 0\n end\n",
    " set End time = 2.031e-05"));
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 2e-3)
    << "a thousandth by which the reference lags behind the step";
  EXPECT_GT(std::abs(run.curves.at("staggering").back()), 0.1 * run.summary.number("energy/initial"))
    << "what would seem lost";
  EXPECT_GT(run.curves.at("blade_kinetic").back(), 0.);
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
  EXPECT_LT(run.summary.number("angular_momentum/max_relative_error"), 1e-10);
}

// Where bricks turned inside out at their corners, slivers made plastic work of nothing, which by work less the rest
// was a perfect balance with an elastic energy of -525 J. Now all the motion there was has become plastic work at 0.15
// ms.
TEST(Ledger, ACrushedBarTurnsItsMotionToPlasticWork)
{
  const Strike run     = run_text(crushed_bar("800", " set Elements along span = 40\n set Elements along chord = 8\n"));
  const double initial = run.summary.number("energy/initial");
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 1e-3);
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-10);
  EXPECT_LT(run.summary.number("angular_momentum/max_relative_error"), 1e-10);
  const auto &elastic_energy = run.curves.at("blade_elastic");
  EXPECT_GE(*std::min_element(elastic_energy.begin(), elastic_energy.end()), 0.);
  EXPECT_GT(run.summary.number("energy/parts/blade_plastic"), 0.98 * initial);
  EXPECT_LT(run.summary.number("energy/parts/blade_plastic"), initial);
}

// At 2500 m/s nothing is left of its end: that stops, and names no entry that is not there.
TEST(Ledger, ABarCrushedToNothingStopsInWords)
{
  try
    {
      run_text(crushed_bar("2500", " set Elements along span = 20\n set Elements along chord = 4\n"));
      FAIL() << "the run went through";
    }
  catch (const NumericalFailure &failure)
    {
      const std::string text = failure.what();
      EXPECT_NE(text.find("blade"), std::string::npos);
      EXPECT_NE(text.find("t = "), std::string::npos);
      EXPECT_EQ(text.find("Blade step scale"), std::string::npos) << "no entry of this name exists";
      EXPECT_EQ(text.find("Bird step scale"), std::string::npos) << "there is no bird";
    }
}

// Damping takes momentum: its impulse and moment are external ones.
TEST(Ledger, DampingsImpulseIsBooked)
{
  const Strike run =
    run_shipped("quickstart.prm", {"Blade/Loads/Damping=300", "Time/End time=0.3e-3", "Output/History interval=1e-5"});
  EXPECT_GT(run.summary.number("energy/parts/blade_damped"), 0.01 * run.summary.number("energy/initial"));
  EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-12);
  EXPECT_LT(run.summary.number("angular_momentum/max_relative_error"), 1e-4)
    << "corrected gradients turn the bird a little";
  EXPECT_LT(run.summary.number("energy/max_relative_error"), 5e-3);
}

// Pressure, clamped edge and damping of shells and bricks, no bird: all moments are booked to round-off.
TEST(Ledger, MomentsOfLoadsAndSupportsAreBooked)
{
  for (const std::string kind : {"shell", "solid"})
    {
      const Strike run = run_text(
        blade_alone(" set Kind = " + kind +
                      "\n subsection Mesh\n set Length = 0.2\n set Chord = 0.05\n set Elements along span = 12\n"
                      " set Elements along chord = 4\n end\n subsection Thickness\n set Value = 0.004\n end\n" +
                      elastic + " subsection Loads\n set Pressure = 1e5*(1+10*x)\n set Damping = 100\n end\n",
                    " set End time = 0.5e-3"));
      EXPECT_LT(run.summary.number("momentum/max_relative_error"), 1e-11) << kind;
      EXPECT_LT(run.summary.number("angular_momentum/max_relative_error"), 1e-11) << kind;
      EXPECT_GT(run.summary.number("energy/parts/external_work"), 0.);
      EXPECT_LT(run.summary.number("energy/max_relative_error"), 2e-3) << kind;
    }
}

// Rows of the history look at the balance and change nothing of it.
TEST(Ledger, RowsChangeNoEnergy)
{
  const std::vector<std::string> common{"Time/End time=0.05e-3"};
  auto                           often = common, seldom = common;
  often.push_back("Output/History interval=0");
  seldom.push_back("Output/History interval=1e-3");
  EXPECT_EQ(run_shipped("quickstart.prm", often).summary.json.at("energy").at("parts"),
            run_shipped("quickstart.prm", seldom).summary.json.at("energy").at("parts"));
}

TEST(Ledger, CourantNumbersThatMakeEnergyAreRefused)
{
  for (const std::vector<std::string> &overrides :
       {std::vector<std::string>{"Bird/Courant number=0.7"}, {"Bird/Courant number=0.4", "Time/Bird step scale=1.5"}})
    {
      CaseParameters parameters;
      try
        {
          parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", overrides);
          FAIL();
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find("Bird/Courant number"), std::string::npos);
        }
    }
  CaseParameters allowed;
  EXPECT_NO_THROW(allowed.read(BIRDSTRIKE_SOURCE_DIR "/prm/quickstart.prm", {"Bird/Courant number=0.5"}));
}
