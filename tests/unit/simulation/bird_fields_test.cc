#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/recorder.h>

#include <gtest/gtest.h>

#include "../io/scratch_folder.h"

using namespace birdstrike;

// ParaView shows the last file of a series from its time on: the series of a bird that has gone ends with nothing.
TEST(BirdFields, EndWithTheBird)
{
  const ScratchFolder scratch;
  CaseParameters      parameters;
  parameters.read(scratch.write("bird.prm", "subsection Blade\n set Kind = none\nend\n"
                                            "subsection Bird\n set Particle spacing = 0.01\nend\n"
                                            "subsection Output\n set Field interval = 1e-3\nend\n"));
  Scene          scene(parameters);
  const Observed observed;
  const Balance  balance(1.);
  {
    RunView run{parameters, observed, balance, balance, nullptr, nullptr, false};
    run.birds = {scene.birds.front().report(false)};
    Recorder recorder(run, scratch.path());
    recorder.record(run);
    run.birds.front().bird = nullptr;
    for (const double time : {0.5e-3, 1e-3, 2e-3, 3e-3}) // the first before a file is due
      {
        run.time = time;
        recorder.record(run);
      }
    recorder.finish(run);
  }
  EXPECT_NE(read_text(scratch.path() / "fields/bird_0000.vtu").find("Name=\"pressure\""), std::string::npos);
  const std::string last = read_text(scratch.path() / "fields/bird_0001.vtu");
  EXPECT_NE(last.find("NumberOfPoints=\"0\""), std::string::npos);
  EXPECT_NE(last.find("Name=\"pressure\""), std::string::npos) << "the same arrays";
  EXPECT_NE(read_text(scratch.path() / "bird.pvd").find("timestep=\"0.001\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "fields/bird_0002.vtu")) << "once";
}
