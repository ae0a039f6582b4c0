#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/run_view.h>

#include <gtest/gtest.h>

#include <set>

using namespace birdstrike;
using namespace birdstrike::test;

namespace
{
  const Overrides coarse_birds{"Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=20",
                               "Blade/Mesh/Elements along chord=6", "Output/History interval=0"};

  const std::string rigid_plate = "subsection Blade\n set Kind = rigid\n subsection Rigid\n"
                                  "  set Length = 1\n set Width = 1\n end\nend\n"
                                  "subsection Bird\n set Mass = 0.1\n set Particle spacing = 0.005\n"
                                  "  set Velocity = 0, 0, 150\n set Aim point = 0, 0, 0\nend\n"
                                  "subsection Time\n set End time = 0.2e-3\nend\n";

  double impulse(const Strike &strike, const std::size_t bird, const std::size_t d)
  {
    return strike.summary.json["birds"][bird]["impulse"][d].get<double>();
  }

  double at_end(const Strike &strike, const std::string &column)
  {
    return strike.curves.at(column).back();
  }

  /// When a column first differs from zero, s.
  double begin_of(const Strike &strike, const std::string &column)
  {
    const auto &time = strike.curves.at("time"), &value = strike.curves.at(column);
    for (std::size_t k = 0; k < time.size(); ++k)
      if (value[k] != 0.)
        return time[k];
    return INFINITY;
  }
} // namespace

// On ground that does not give they know nothing of one another, so that each does what it does alone, but for the
// step: both take that of the faster one (alone, a step of 0.8 changes the impulse of a bird of 5 mm particles by 0.2
// %).
TEST(SeveralBirds, StrikeAsAloneWhereNothingGives)
{
  const Strike both  = run_text(rigid_plate + "subsection Bird 2\n set Enabled = true\n set Mass = 0.05\n"
                                               "  set Velocity = 0, 60, 120\n set Aim point = 0.25, 0, 0\nend\n");
  const Strike first = run_text(rigid_plate);
  const Strike other =
    run_text(rigid_plate, {"Bird/Mass=0.05", "Bird/Velocity=0, 60, 120", "Bird/Aim point=0.25, 0, 0"});
  const double alone = first.summary.number("contact/impulse/2"), of_other = other.summary.number("contact/impulse/2");
  EXPECT_NEAR(impulse(both, 0, 2), alone, 1e-3 * alone);
  EXPECT_NEAR(impulse(both, 1, 2), of_other, 5e-3 * of_other);
  EXPECT_NEAR(both.summary.number("contact/impulse/2"), impulse(both, 0, 2) + impulse(both, 1, 2), 1e-12 * alone);
  EXPECT_DOUBLE_EQ(both.summary.number("bird/mass"),
                   first.summary.number("bird/mass") + other.summary.number("bird/mass"));
}

// Nothing moves at a rigid plate while a bird waits, longer than removal of particles looks ahead: it strikes like the
// first.
TEST(SeveralBirds, WaitForAnyTimeAtARigidPlate)
{
  const Strike late =
    run_text(rigid_plate, {"Bird 2/Enabled=true", "Bird 2/Arrival time=3.5e-3", "Time/End time=4.6e-3"});
  EXPECT_GT(impulse(late, 0, 2), 14.);
  EXPECT_NEAR(impulse(late, 1, 2), impulse(late, 0, 2), 0.01 * impulse(late, 0, 2));
}

TEST(SeveralBirds, AreNamedWhereOneMovesByNoNumber)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm",
                  with(coarse_birds, {"Bird 2/Enabled=true", "Bird 2/Aim point=0.1, 0, 0", "Bird 2/Mass=0.02"}));
  Scene        scene(parameters);
  const Guards guards(parameters, scene);
  EXPECT_THROW(scene.birds.front().bird->set_state([](Point3 &, Point3 &v, double &) { v[0] = NAN; }),
               NumericalFailure);
  EXPECT_THROW(guards.check_motion(scene, 0.), NumericalFailure);
}

// A bird that comes after the end is not there: not a bit of what happens before hangs on it.
TEST(SeveralBirds, NoBitHangsOnOneThatWaits)
{
  const Overrides short_run = with(coarse_birds, {"Time/End time=0.2 ms"});
  const Strike    alone     = run_shipped("frontal.prm", short_run);
  const Strike    both =
    run_shipped("frontal.prm",
                with(short_run, {"Bird 2/Enabled=true", "Bird 2/Arrival time=0.3 ms", "Bird 2/Aim point=0.1, 0, 0"}));
  for (const char *column : {"time", "contact_impulse_z", "blade_kinetic", "blade_elastic", "tip_mid_chord"})
    EXPECT_EQ(alone.curves.at(column), both.curves.at(column)) << column;
  EXPECT_EQ(both.summary.number("skipped/birds that wait/count") > 0., true);
}

// A bird touches at its arrival time where the blade has not moved: here it is 40 mm thick. Two steps, for the touch is
// seen by the step that ends after it, and half a millimetre at 177 m/s by which the others have moved it by then.
TEST(SeveralBirds, ArriveWhenTheyAreDue)
{
  const Strike strike = run_shipped(
    "frontal.prm",
    with(coarse_birds, {"Blade/Thickness/Value=0.04", "Time/End time=0.35 ms", "Bird 2/Enabled=true",
                        "Bird 2/Arrival time=0.15 ms", "Bird 2/Aim point=0.06, 0, 0", "Bird 3/Enabled=true",
                        "Bird 3/Arrival time=0.25 ms", "Bird 3/Mass=0.02", "Bird 3/Aim point=0.13, 0.02, 0"}));
  const double step = 2e-6;
  EXPECT_NEAR(begin_of(strike, "bird_2_impulse_z"), 0.15e-3, step);
  EXPECT_NEAR(begin_of(strike, "bird_3_impulse_z"), 0.25e-3, step + 0.5e-3 / 177.4);
  EXPECT_LT(strike.summary.number("energy/max_relative_error"), 5e-3); // alone 2.7e-3, of so coarse a bird
  EXPECT_LT(strike.summary.number("momentum/max_relative_error"), 1e-12);
  EXPECT_LT(strike.summary.number("angular_momentum/max_relative_error"), 1e-4);
}

// The tip's peak under the first bird is none of the run's while another is still to come: alone it is passed at 9 ms.
TEST(SeveralBirds, AreAwaitedWhereTheTipPeakEndsTheRun)
{
  const Strike strike = run_shipped(
    "quickstart.prm", {"Bird/Particle spacing=0.008", "Blade/Mesh/Elements along span=20",
                       "Blade/Mesh/Elements along chord=6", "Time/End time=30 ms", "Time/Stop at tip peak=true",
                       "Bird/Velocity=0, 0, 100", "Bird 2/Enabled=true", "Bird 2/Arrival time=16 ms"});
  EXPECT_EQ(strike.summary.text("end/reason"), "tip peak passed");
  EXPECT_GT(strike.summary.number("end/time"), 16e-3);
  EXPECT_GT(impulse(strike, 1, 2), 0.5 * impulse(strike, 0, 2));
}

// A blade in equilibrium on a hub that turns about the bird's velocity meets it alike whenever it comes: rolled by the
// angle that the hub has turned, the whole strike is the same one, turned. (Which particle touches first, and in which
// steps, hangs on the path before, which this one has flown: impulses differ by 1e-3.)
TEST(SeveralBirds, MeetATurningBladeAlikeWheneverTheyCome)
{
  const std::string file = BIRDSTRIKE_SOURCE_DIR "/tests/data/spinning-blade.prm";
  // a quarter of the steps: where in a step particles first touch an edge changes the impulse by 0.2 to 0.9 % at the
  // default ones, by 0.02 % so
  const Overrides rows{"Output/History interval=0", "Time/Step scale=0.25", "Time/Bird step scale=0.25"};
  const double    angle = 600. * 0.5e-3; // rad
  const Strike    now   = run_file(file, with(rows, {"Time/End time=0.6 ms"}));
  const Strike    later = run_file(file, with(rows, {"Time/End time=1.1 ms", "Bird/Arrival time=0.5 ms",
                                                     "Bird/Roll=" + std::to_string(angle * 180. / M_PI)}));
  EXPECT_NEAR(begin_of(later, "contact_impulse_y"), 0.5e-3, 4e-6);
  const double c = std::cos(angle), s = std::sin(angle), scale = std::abs(at_end(now, "contact_impulse_z"));
  const double x = at_end(now, "contact_impulse_x"), z = at_end(now, "contact_impulse_z");
  EXPECT_NEAR(at_end(later, "contact_impulse_x"), c * x + s * z, 1e-3 * scale);
  EXPECT_NEAR(at_end(later, "contact_impulse_y"), at_end(now, "contact_impulse_y"), 1e-3 * scale);
  EXPECT_NEAR(at_end(later, "contact_impulse_z"), c * z - s * x, 1e-3 * scale);
  const double deflection = value_at(now.curves, "tip_mid_chord", 0.3e-3); // about its first maximum, 2.2 mm
  EXPECT_NEAR(value_at(later.curves, "tip_mid_chord", 0.8e-3), deflection, 0.01 * std::abs(deflection));
}

// Particles of both birds touch the same elements of a light skin, which dampers of each of them alone turn round
// within a step if they do not share the nodes (LightTarget). Against a tenth of the step, with which any law of
// contact agrees.
TEST(SeveralBirds, TakeEnergyTogetherFromLightSkin)
{
  const std::string skin = BIRDSTRIKE_SOURCE_DIR "/tests/scenes/thin-skin.prm";
  const Overrides   two{"Bird/Mass=0.9",        "Bird/Aim point=0.25, -0.045, 0",  "Bird/Velocity=0, 60, 104",
                      "Bird 2/Enabled=true",  "Bird 2/Aim point=0.25, 0.045, 0", "Bird 2/Velocity=0, -60, 104",
                      "Time/End time=0.2e-3", "Output/History interval=1e-5"};
  const Strike      strike  = run_file(skin, two);
  const Strike      fine    = run_file(skin, with(two, {"Time/Step scale=0.1", "Time/Bird step scale=0.1"}));
  const double      kinetic = fine.summary.number("energy/parts/blade_kinetic");
  EXPECT_NEAR(strike.summary.number("energy/parts/blade_kinetic"), kinetic, 0.05 * kinetic);
  EXPECT_GT(strike.summary.number("energy/parts/contact_dissipated"), 0.);
  EXPECT_LT(strike.summary.number("energy/max_relative_error"), 3e-3);
}

TEST(SeveralBirds, ShowTheirParticlesInOneField)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm",
                  with(coarse_birds, {"Bird 2/Enabled=true", "Bird 2/Aim point=0.1, 0, 0", "Bird 2/Mass=0.02"}));
  Scene          scene(parameters);
  BirdStrike     strike(parameters, scene);
  const Observed observed;
  const Balance  balance(1.);
  RunView        run{parameters, observed, balance, balance, nullptr, nullptr, false};
  for (const Projectile &each : scene.birds)
    run.birds.push_back(each.report(true));
  const FieldSnapshot all = run.bird_snapshot();
  EXPECT_EQ(all.points.size(), 3 * run.n_particles());
  std::map<std::string, std::set<double>> values;
  for (const Field &field : all.fields)
    if (field.n_components == 1)
      values[field.name].insert(field.values.begin(), field.values.end());
  EXPECT_EQ(values["id"].size(), run.n_particles()) << "each has its own";
  EXPECT_EQ(values["bird"], (std::set<double>{1., 2.}));
}

TEST(SeveralBirds, AreRefusedInOneAnother)
{
  CaseParameters parameters;
  parameters.read(BIRDSTRIKE_SOURCE_DIR "/prm/frontal.prm", with(coarse_birds, {"Bird 2/Enabled=true"}));
  try
    {
      Scene scene(parameters);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("'Bird 2': this bird starts inside that of section 'Bird'"),
                std::string::npos)
        << error.what();
    }
}
