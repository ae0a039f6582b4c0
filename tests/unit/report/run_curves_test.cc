#include "report/measurement/run_curves.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/report/measurement.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

// The filter's curve goes on where the run has ended, at 25.99 ms, and begins before it: no value was computed there.
TEST(RunCurves, AFilteredForceIsThatOfTheRun)
{
  const ScratchFolder scratch;
  RecordedRun         run;
  const auto          folder = scratch.path() / "run";
  run.write(folder, scratch.write("plate.prm", ""));
  {
    std::ofstream file(folder / "filtered.csv");
    file << "time [s],contact_force_x [N],contact_force_y [N],contact_force_z [N]\n";
    for (int k = -200; k <= 2800; ++k)
      file << 1e-5 * k << ",3,0," << (k < 0 || k > 2599 ? 0 : 4) << "\n";
  }
  const auto force = birdstrike::read_run_curve(folder, "force");
  EXPECT_EQ(force.x.front(), 0.);
  EXPECT_NEAR(force.x.back(), 25.99e-3, 1e-12);
  EXPECT_EQ(force.y.front(), 5.);
  EXPECT_EQ(force.y.back(), 5.);
  std::ofstream(folder / "filtered.csv") << "time [s],contact_force_x [N],contact_force_y [N],contact_force_z [N]\n"
                                            "-1,0,0,0\n1,0,0,0\n";
  EXPECT_THROW(birdstrike::read_run_curve(folder, "force"), birdstrike::InputError) << "no value lies in the run";
}

// A run made without a filter has no filtered.csv: what is wrong is its entry, not a file or a column.
TEST(RunCurves, WithoutAFilterSayWhy)
{
  const ScratchFolder scratch;
  RecordedRun         run;
  for (const auto &[of_class, cause] : {std::pair("none", "it was made with Output/Channel class = none"),
                                        std::pair("CFC 1000", "it has not ended, or had no contact")})
    {
      run.channel_class = of_class;
      run.write(scratch.path() / of_class, scratch.write("plate.prm", ""));
      std::string said;
      try
        {
          birdstrike::read_run_curve(scratch.path() / of_class, "-force");
        }
      catch (const birdstrike::InputError &error)
        {
          said = error.what();
        }
      EXPECT_NE(said.find(cause), std::string::npos) << said;
    }
}

TEST(RunCurves, RunsAreNamedByWhatTheirFoldersDifferIn)
{
  using Names      = std::vector<std::string>;
  const auto names = [](const Names &folders) { return birdstrike::shortest_names(folders); };
  EXPECT_EQ(names({"runs/a"}), Names{"a"});
  EXPECT_EQ(names({"runs/a/", "runs/b"}), (Names{"a", "b"}));
  EXPECT_EQ(names({"one/out", "two/out/", "three"}), (Names{"one/out", "two/out", "three"}));
  EXPECT_EQ(names({"x/one/out", "y/one/out", "y/two/out"}), (Names{"x/one/out", "y/one/out", "two/out"}));
  EXPECT_EQ(names({"out", "out"}), (Names{"out", "out"})) << "the same folder";
  EXPECT_EQ(names({"out", "a/out"}), (Names{"out", "a/out"}));
}
