#include "strike_harness.h"

#include <birdstrike/core/numerical_failure.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  std::string failure_of_crushing(const std::vector<std::string> &overrides)
  {
    const char *crush = R"(
subsection Time
  set End time = 3e-4
  set Energy error limit = 1e9
end
subsection Blade
  subsection Mesh
    set Length = 0.1
    set Chord = 0.02
    set Elements along span = 20
    set Elements along chord = 4
  end
  subsection Thickness
    set Value = 0.005
  end
  subsection Material
    set Name = Al 6061-T6
  end
  subsection Loads
    set Initial velocity = -1600*x/0.1; 0; 0
  end
end
subsection Bird
  set Enabled = false
end
)";
    try
      {
        test::run_text(crush, overrides);
      }
    catch (const NumericalFailure &failure)
      {
        return failure.what();
      }
    return "";
  }
} // namespace

// A plate that is crushed along its plane at 1600 m/s folds its elements to nothing; at 800 m/s it folds soundly.
TEST(Collapse, EndsTheRunInWords)
{
  const std::string message = failure_of_crushing({});
  for (const char *part :
       {"stable step of the blade", "Time/Smallest step", "element", "t = ", "Blade/Material/Failure"})
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Collapse, TheLimitIsTheUsers)
{
  const std::string message = failure_of_crushing({"Time/Smallest step=0.5"});
  EXPECT_NE(message.find("Time/Smallest step 0.5"), std::string::npos) << message;
}
