#include "report/measurement/run_curves.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <string>

#include "../io/scratch_folder.h"
#include "recorded_run.h"

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
