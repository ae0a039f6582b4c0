#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <gtest/gtest.h>

#include "scratch_folder.h"

using namespace birdstrike;

namespace
{
  std::string refusal_of_half(const std::string &override_text, const std::string &another = "Case/Name=case")
  {
    const ScratchFolder scratch;
    CaseParameters      parameters;
    try
      {
        parameters.read(scratch.write("case.prm", ""), {"Case/Symmetry plane=y", override_text, another});
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(SymmetryPlane, HalvesBothPartsOfASymmetricCase)
{
  const ScratchFolder scratch;
  CaseParameters      parameters;
  parameters.read(scratch.write("case.prm", ""), {"Bird/Pitch=30", "Blade/Loads/Pressure=1e5*y^2"});
  EXPECT_FALSE(parameters.bird.is_halved || parameters.blade.is_halved);
  parameters.read(scratch.write("case.prm", ""), {"Case/Symmetry plane=y", "Bird/Pitch=30", "Blade/Probes=a: 0.2 0 0"});
  EXPECT_TRUE(parameters.bird.is_halved && parameters.blade.is_halved);
}

TEST(SymmetryPlane, RefusesWhatIsNotItsOwnMirrorImage)
{
  for (const auto &[text, entry] : {std::pair{"Bird/Velocity=0, 10, 177", "Bird/Velocity"},
                                    {"Bird/Aim point=0.2, 0.01, 0", "Bird/Aim point"},
                                    {"Bird/Chordwise offset=0.01", "Bird/Chordwise offset"},
                                    {"Bird/Yaw=10", "Bird/Yaw"},
                                    {"Bird/Roll=10", "Bird/Roll"},
                                    {"Bird/Lattice shift=0.5, 0", "Bird/Lattice shift"},
                                    {"Blade/Thickness/Value=0.004 + 0.01*y", "Thickness/Value"},
                                    {"Blade/Thickness/Value=0.00427+if(y>0.042,0.002,0)", "Thickness/Value"},
                                    {"Blade/Thickness/Value=0.004+if(x>0.3 && y<-0.04,0.002,0)", "Thickness/Value"},
                                    {"Blade/Loads/Pressure=1e5*y", "Loads/Pressure"},
                                    {"Blade/Loads/Pressure=if(t>5e-3, 1e5*y, 0)", "Loads/Pressure"},
                                    {"Blade/Loads/Initial velocity=0; 1; 0", "Loads/Initial velocity"},
                                    {"Blade/Loads/Initial spin=1; 0; 0", "Loads/Initial spin"},
                                    {"Blade/Supports/Clamped=0, 2", "Supports/Clamped"},
                                    {"Blade/Supports/Driven=1: uz = 1e-3*t; 3: uz = 1e-3*t", "Supports/Driven"},
                                    {"Blade/Mesh/Elements along chord=7", "Blade/Mesh"},
                                    {"Blade/Probes=a: 0.2 -0.01 0", "Probes"}})
    {
      const std::string message = refusal_of_half(text);
      EXPECT_NE(message.find(entry), std::string::npos) << text << ": " << message;
      EXPECT_NE(message.find("symmetric"), std::string::npos) << text << ": " << message;
    }
}

TEST(SymmetryPlane, TakesEdgesThatAreDrivenAlike)
{
  EXPECT_EQ(refusal_of_half("Blade/Supports/Driven=2, 3: uz = 1e-3*t"), "");
  EXPECT_EQ(refusal_of_half("Blade/Supports/Driven=1: uz = 1e-3*t"), "");
}

TEST(SymmetryPlane, RefusesAThicknessOfASectionThatIsNotItsOwnMirrorImage)
{
  const std::string ids = "Blade/Section 2/Material ids=1";
  EXPECT_EQ(refusal_of_half("Blade/Section 2/Thickness=0.004 + y^2", ids), "");
  EXPECT_EQ(refusal_of_half("Blade/Section 2/Thickness=0.004 + 0.01*y"), "") << "not in use";
  EXPECT_NE(
    refusal_of_half("Blade/Section 2/Thickness=0.004 + 0.01*y", ids).find("Section 2/Thickness is not symmetric"),
    std::string::npos);
}

TEST(SymmetryPlane, RefusesAProfileOfThicknessThatIsNotItsOwnMirrorImage)
{
  const std::string maximum = "Blade/Thickness/Maximum=0.004 - 0.001*s";
  EXPECT_EQ(refusal_of_half(maximum), "");
  for (const char *text : {"Blade/Thickness/Leading edge=0.5", "Blade/Thickness/Maximum station=0.4"})
    {
      const std::string message = refusal_of_half(text, maximum);
      EXPECT_NE(message.find("Thickness/Maximum station"), std::string::npos) << text << ": " << message;
    }
}
