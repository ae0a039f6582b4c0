#include "folded_sheet.h"
#include "strike_harness.h"

#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/core/archive.h>
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <random>

using namespace birdstrike;
using namespace birdstrike::test;

// A run that is archived in memory at some step and read by a new scene of the same case goes on as if nothing had
// been: after more steps both archives are the same to the last bit. What influences the next step and is not archived
// shows.
namespace
{
  struct Running
  {
    CaseParameters              parameters;
    std::unique_ptr<Scene>      scene;
    std::unique_ptr<BirdStrike> strike;

    explicit Running(const std::string &file, const Overrides &overrides)
    {
      parameters.read(file, overrides);
      parameters.output.console_interval = 1e9;
      scene                              = std::make_unique<Scene>(parameters);
      strike                             = std::make_unique<BirdStrike>(parameters, *scene);
    }
    void advance(const unsigned int n)
    {
      for (unsigned int k = 0; k < n; ++k)
        strike->advance();
    }
    ArchivedState write()
    {
      ArchivedState state;
      Archive       archive = Archive::writing(state);
      strike->archive(archive);
      return state;
    }
    void read(const ArchivedState &state)
    {
      Archive archive = Archive::reading(state);
      strike->archive(archive);
      archive.finish();
    }
  };

  struct Case
  {
    std::string  name, file;
    Overrides    overrides;
    unsigned int from, to; ///< steps, among which one is drawn to archive at
    /// A quantity that must not be zero by then: what the case is here for has happened.
    std::string  happened = "bird 1/contact/report/touching";
    unsigned int threads  = 1; ///< of the run that goes on
  };

  std::ostream &operator<<(std::ostream &out, const Case &of)
  {
    return out << of.name;
  }

  double largest(const ArchivedQuantity &quantity)
  {
    double most = 0.;
    for (const double value : quantity.real)
      most = std::max(most, std::abs(value));
    for (const std::uint64_t value : quantity.whole)
      most = std::max(most, static_cast<double>(value));
    return most;
  }

  std::string shipped(const std::string &name)
  {
    return BIRDSTRIKE_SOURCE_DIR "/prm/" + name + ".prm";
  }

  const Overrides   coarse_bird{"Bird/Particle spacing=0.006"};
  const Overrides   coarse{"Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=20",
                         "Blade/Mesh/Elements along chord=6"};
  const Overrides   solid = with(coarse, {"Blade/Kind=solid"});
  const Overrides   plate{"Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=20",
                        "Blade/Mesh/Elements along chord=20"};
  const Overrides   sheath_fails{"Bird/Velocity=0, 0, 400", "Blade/Section 1/Material/Failure=plastic strain",
                               "Blade/Section 1/Material/Failure strain=0.005"};
  const Overrides   composite{"Bird/Particle spacing=0.008", "Blade/Mesh/Elements along span=22",
                            "Blade/Mesh/Elements along chord=9"};
  const Overrides   second_bird{"Bird 2/Enabled=true", "Bird 2/Arrival time=0.4 ms", "Bird 2/Aim point=0.15, 0.01, 0",
                              "Bird 2/Density=900", "Bird 2/Particle spacing=0.005"};
  const std::string formulation = "Blade/Element/Formulation=";

  const Case cases[] = {
    {"BirdFree", shipped("bird-free"), coarse_bird, 20, 60, "bird 1/bird/particles/velocity"},
    {"RigidPlate", shipped("rigid-plate"), coarse_bird, 20, 200},
    {"FreeRigidPlate", shipped("rigid-plate"),
     with(coarse_bird, {"Blade/Rigid/Motion=free along normal", "Blade/Rigid/Mass=0.05"}), 20, 200, "plate/speed"},
    {"BladeImpulse", shipped("blade-impulse"), {}, 20, 200, "blade/elements/section 0/points/plastic strain"},
    {"FanBlade", shipped("fan-blade"), coarse, 20, 200},
    {"FanBladeSolid", shipped("fan-blade"), solid, 20, 200},
    {"FanBladeComposite", shipped("fan-blade-composite"), composite, 100, 300,
     "blade/elements/section 0/laminate/plies/modes", 2},
    {"Frontal", shipped("frontal"), coarse, 20, 400, "blade/elements/section 0/points/plastic strain", 2},
    {"FrontalSolid", shipped("frontal"), solid, 20, 400, "bird 1/contact/report/touching", 2},
    {"Oblique", shipped("oblique"), coarse, 20, 300},
    {"ObliqueSolid", shipped("oblique"), solid, 20, 300},
    {"Quickstart", shipped("quickstart"), coarse, 20, 300},
    {"Sheath", shipped("sheath"), coarse, 300, 400, "blade/elements/section 1/points/plastic strain"},
    {"SheathSolid", shipped("sheath"), solid, 300, 400, "blade/elements/section 1/layers/plastic strain", 2},
    {"Perforation", shipped("perforation"), with(plate, {"Bird/Velocity=0, 0, 400"}), 60, 120,
     "blade/elements/section 0/failed"},
    {"PerforationSolid", shipped("perforation"), with(plate, {"Blade/Kind=solid", "Bird/Velocity=0, 0, 400"}), 60, 120,
     "blade/elements/section 0/failed"},
  };

  const Case features[] = {
    {"Half", shipped("frontal"), with(coarse, {"Case/Symmetry plane=y"}), 20, 300},
    {"Histories", shipped("frontal"),
     with(coarse, {"Output/Histories/Gauges=g: 0.02 0 0", "Output/Histories/Elements=e: 0.02 0 0 | 1",
                   "Output/Histories/Patches=p: 0.2 0 0 0.05"}),
     20, 300, "patches/forces, impulses and peaks"},
    {"SolidHalf", shipped("frontal"), with(solid, {"Case/Symmetry plane=y"}), 20, 300},
    {"RemovedFlyOn", shipped("frontal"), with(coarse, {"Output/Removed particles=fly on"}), 400, 500,
     "observed/removed particles/position"},
    {"BelytschkoTsay", shipped("frontal"), with(coarse, {formulation + "Belytschko-Tsay"}), 20, 300},
    {"FullyIntegrated", shipped("frontal"), with(coarse, {formulation + "fully integrated"}), 20, 300},
    {"OnePointBricks", shipped("frontal"), with(solid, {formulation + "one point", "Blade/Mesh/Layers=2"}), 20, 200},
    {"BBar", shipped("frontal"), with(solid, {formulation + "B-bar"}), 20, 200},
    {"SolidShell", shipped("frontal"), with(solid, {formulation + "solid-shell"}), 100, 400,
     "blade/elements/section 0/layers/plastic strain"},
    {"MassScaling", shipped("frontal"), with(solid, {"Blade/Mesh/Layers=2", "Blade/Mass scaling/Method=selective"}), 20,
     200},
    {"Loads", shipped("oblique"), with(coarse, {"Blade/Loads/Damping=200", "Blade/Loads/Pressure=1e5"}), 20, 200},
    {"Driven", shipped("oblique"),
     with(coarse, {"Blade/Supports/Clamped=", "Blade/Supports/Driven=0: ux uz ry = 1e-4*sin(6e4*t)",
                   "Blade/Loads/Damping=200"}),
     20, 200},
    {"StandardParticles", shipped("oblique"), with(coarse, {"Bird/Formulation=standard"}), 20, 200},
    {"Reconstruction", shipped("oblique"), with(coarse, {"Bird/Reconstruction=linear"}), 20, 200},
    {"SubCycledBlade", shipped("frontal"),
     with(solid, {"Blade/Mesh/Layers=3", "Bird/Particle spacing=0.01", formulation + "one point"}), 20, 100,
     "stepper/steps not done"},
    {"SubCycledBird",
     shipped("frontal"),
     {"Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=8", "Blade/Mesh/Elements along chord=2"},
     20,
     200,
     "stepper/steps not done"},
    {"Retired", shipped("oblique"), with(coarse, {"Bird/Retirement margin=0.005"}), 300, 500,
     "bird 1/bird/retired/particles"},
    {"BirdGone", shipped("oblique"), with(coarse, {"Bird/Retirement margin=0.005"}), 900, 1000,
     "bird 1/gone energy/retired"},
    {"SecondBirdWaits", shipped("frontal"), with(coarse, second_bird), 20, 100, "bird 2/waits"},
    {"SecondBirdStrikes", shipped("frontal"), with(coarse, second_bird), 400, 500, "bird 2/contact/report/touching", 2},
    {"RowOfBlades",
     shipped("fan-row"),
     {"Bird/Particle spacing=0.005", "Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=6",
      "Blade/Mesh/Row/Rigid=3", "Blade/Spin/Speed=600 - 1e4*t"},
     100,
     300,
     "observed/blade 1/root moment",
     2},
    {"SolidRowOfBlades",
     shipped("fan-row"),
     {"Blade/Kind=solid", "Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=10",
      "Blade/Mesh/Elements along chord=5", "Blade/Mesh/Row/Rigid=1"},
     100,
     300,
     "observed/blade 3/root moment",
     2},
    {"Collapse", shipped("perforation"), with(plate, {"Blade/Material/Smallest step=0.8", "Bird/Velocity=0, 0, 400"}),
     60, 120, "blade/elements/section 0/failed"},
    {"SolidCollapse", shipped("perforation"),
     with(plate, {"Blade/Kind=solid", "Blade/Material/Smallest step=0.8", "Bird/Velocity=0, 0, 400"}), 60, 120,
     "blade/elements/section 0/failed"},
    {"SheathThatFails", shipped("sheath"), with(coarse, sheath_fails), 60, 140, "blade/elements/section 1/failed"},
    {"SolidSheathThatFails", shipped("sheath"), with(solid, sheath_fails), 60, 140, "blade/elements/section 1/failed"},
    {"SingleRate", shipped("frontal"), with(coarse, {"Time/Multirate=false"}), 20, 200},
    {"FullyIntegratedPerforation", shipped("perforation"),
     with(plate, {"Bird/Velocity=0, 0, 400", formulation + "fully integrated"}), 60, 120,
     "blade/elements/section 0/failed"},
    {"FullyIntegratedPlies", shipped("fan-blade-composite"), with(composite, {formulation + "fully integrated"}), 100,
     300, "blade/elements/section 0/laminate/plies/modes"},
    {"BBarPerforation", shipped("perforation"),
     with(plate, {"Blade/Kind=solid", "Bird/Velocity=0, 0, 400", formulation + "B-bar"}), 60, 120,
     "blade/elements/section 0/failed"},
  };

  class Resumed : public testing::TestWithParam<Case>
  {
  };

  void expect_the_same(const Case &of)
  {
    std::seed_seq      seed(of.name.begin(), of.name.end()); // random, and always the same
    std::mt19937       draw(seed);
    const unsigned int n = std::uniform_int_distribution<unsigned int>(of.from, of.to)(draw), more = 60;
    Running            whole(of.file, with(of.overrides, {"Time/Threads=1"}));
    whole.advance(n);
    const ArchivedState middle = whole.write();
    ASSERT_TRUE(middle.contains(of.happened)) << of.happened;
    EXPECT_GT(largest(middle.at(of.happened)), 0.) << of.happened << " at step " << n;

    Running resumed(of.file,
                    with(of.overrides, {"Time/Threads=" + std::to_string(of.threads), "Time/Force threads=true"}));
    resumed.read(middle);
    EXPECT_EQ(find_difference(middle, resumed.write()), "") << "read at step " << n;
    whole.advance(more);
    resumed.advance(more);
    EXPECT_EQ(find_difference(whole.write(), resumed.write()), "") << more << " steps after step " << n;
  }

  std::string name_of(const testing::TestParamInfo<Case> &info)
  {
    return info.param.name;
  }
} // namespace

TEST_P(Resumed, GoesOnToTheLastBit)
{
  expect_the_same(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Shipped, Resumed, testing::ValuesIn(cases), name_of);
INSTANTIATE_TEST_SUITE_P(Feature, Resumed, testing::ValuesIn(features), name_of);

TEST(ArchiveOfAnotherCase, IsRefusedInWords)
{
  Running             shells(shipped("frontal"), coarse), bricks(shipped("frontal"), solid);
  const ArchivedState state = shells.write();
  try
    {
      bricks.read(state);
      FAIL() << "was read";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("'blade/motion/nodes'"), std::string::npos) << error.what();
    }
}

TEST(ResumedFold, GoesOnToTheLastBit)
{
  std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-fold-XXXXXX").string();
  const std::filesystem::path folder  = mkdtemp(pattern.data());
  for (const bool is_solid : {false, true})
    {
      std::ofstream(folder / "folded.msh") << folded_sheet::folded_mesh(is_solid);
      std::ofstream(folder / "case.prm") << folded_sheet::folded_case(is_solid, (folder / "folded.msh").string());
      const std::string file = (folder / "case.prm").string();
      Running           probe(file, {});
      unsigned int      n = 10;
      for (; n < 1000 && probe.scene->self_contact->report().n_touching < 4; ++n)
        probe.advance(1);
      expect_the_same({is_solid ? "SolidFold" : "Fold", file, {}, n, n + 10, "self-contact/touches/force"});
    }
  std::filesystem::remove_all(folder);
}
