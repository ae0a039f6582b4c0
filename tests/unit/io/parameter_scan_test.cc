#include "io/parameter_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "expect_parts.h"
#include "scratch_folder.h"
#include "small_parameters.h"

namespace
{
  /// The message for a bad file (or override), which must always be short, name its place and offer no internals.
  std::string read_bad(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    const ScratchFolder scratch;
    SmallCase           small;
    try
      {
        small.file.read(scratch.write("case.prm", text), overrides);
      }
    catch (const birdstrike::InputError &error)
      {
        const std::string message = error.what();
        EXPECT_LE(std::count(message.begin(), message.end(), '\n') + 1, 6) << message;
        EXPECT_EQ(message.find("::"), std::string::npos) << message;
        EXPECT_EQ(message.find("xception"), std::string::npos) << message;
        EXPECT_TRUE(message.find("case.prm") != std::string::npos || !overrides.empty()) << message;
        return message;
      }
    ADD_FAILURE() << "accepted:\n" << text;
    return "";
  }
} // namespace

TEST(ParameterScan, MisspeltEntryNamesLineAndNearestEntry)
{
  expect_parts(read_bad("# a bird\nsubsection Bird\n  set Mas = 2\nend\n"),
               {"case.prm, line 3", "section 'Bird'", "'Mas'", "Nearest name here: 'Mass'", "from 0 to 10", "[kg]"});
}

TEST(ParameterScan, NearestNameIsLookedForInOtherSectionsToo)
{
  expect_parts(read_bad("subsection Bird\n  set Thicknes = 2\nend\n"), {"line 2", "'Thickness' in section 'Blade'"});
}

TEST(ParameterScan, EntryInTheWrongSectionNamesTheRightOne)
{
  expect_parts(read_bad("subsection Blade\n  set Velocity = 2\nend\n"),
               {"line 2", "section 'Blade'", "'Velocity'", "section 'Bird/Flight'"});
  expect_parts(read_bad("set Mass = 2\n"), {"line 1", "top level", "section 'Bird'"});
}

TEST(ParameterScan, WrongTypeAndRangeNameWhatIsAllowed)
{
  expect_parts(read_bad("subsection Bird\n  set Mass = heavy\nend\n"),
               {"line 2", "'heavy'", "a number from 0 to 10", "[kg]", "default '1.8'", "Mass of the bird."});
  expect_parts(read_bad("subsection Bird\n  set Mass = 11\nend\n"), {"line 2", "'11'", "a number from 0 to 10"});
  expect_parts(read_bad("subsection Blade\n  set Count = 2.5\nend\n"), {"line 2", "'2.5'", "an integer from 1 to 7"});
  expect_parts(read_bad("subsection Blade\n  set Friction = maybe\nend\n"), {"'maybe'", "true or false"});
  expect_parts(read_bad("subsection Bird\n  set Mass = nan\nend\n"), {"'nan'"});
}

TEST(ParameterScan, BadChoiceNamesTheNearestOne)
{
  expect_parts(read_bad("subsection Bird\n  set Shape = hemisferical\nend\n"),
               {"line 2", "one of flat, hemispherical", "Nearest choice: 'hemispherical'"});
}

TEST(ParameterScan, UnbalancedSubsectionsNameTheLineThatOpened)
{
  expect_parts(read_bad("subsection Bird\n  set Mass = 2\n"), {"'Bird'", "opened in line 1", "no 'end'"});
  expect_parts(read_bad("subsection Bird\n  set Mass = 2\nend\nend\n"), {"line 4", "'end' without an open subsection"});
  expect_parts(read_bad("subsection Bird\n  set Mass = 2\nsubsection Blade\nend\n"),
               {"line 3", "'Blade'", "is 'end' missing for 'Bird', opened in line 1"});
}

TEST(ParameterScan, UnknownSubsectionAndStatementAreRefused)
{
  expect_parts(read_bad("subsection Brid\nend\n"), {"line 1", "'Brid'", "Nearest name here: 'Bird'", "Bird, Blade"});
  expect_parts(read_bad("subsection Bird\n  Mass = 2\nend\n"), {"line 2", "'Mass = 2'", "set ENTRY = VALUE"});
  expect_parts(read_bad("subsection Bird\n  set Mass 2\nend\n"), {"line 2", "'=' is missing", "'Mass 2'"});
  expect_parts(read_bad("subsection\nend\n"), {"line 1", "subsection NAME"});
}

TEST(ParameterScan, EntrySetTwiceInOneFileIsRefused)
{
  expect_parts(read_bad("subsection Bird\n  set Mass = 2\n  set Mass = 3\nend\n"),
               {"line 3", "second time", "'2' in line 2", "'3'"});
}

TEST(ParameterScan, MissingFileNamesTheNearest)
{
  const ScratchFolder scratch;
  scratch.write("frontal.prm", "");
  SmallCase small;
  try
    {
      small.file.read((scratch.path() / "fontal.prm").string());
      FAIL();
    }
  catch (const birdstrike::InputError &error)
    {
      expect_parts(error.what(), {"fontal.prm'", "no such file", "frontal.prm'"});
    }
  try // a folder is named as one, with what could be meant in it
    {
      small.file.read(scratch.path().string());
      FAIL();
    }
  catch (const birdstrike::InputError &error)
    {
      expect_parts(error.what(), {"it is a folder", "in it: frontal.prm", "/frontal.prm'"});
      EXPECT_EQ(std::string(error.what()).find("Nearest"), std::string::npos) << error.what();
    }
  EXPECT_THROW(small.file.read("/no/such/folder/case.prm"), birdstrike::InputError);
}

namespace
{
  double read_mass(const std::string &text)
  {
    const ScratchFolder scratch;
    scratch.write("heavy.prm", "subsection Bird\n  set Mass = 3\nend\n");
    SmallCase small;
    small.file.read(scratch.write("case.prm", text));
    return small.values.mass;
  }
} // namespace

// A path of Windows at the end of a comment is no reason to lose the line below.
TEST(ParameterScan, ACommentEndsWithItsLine)
{
  EXPECT_EQ(read_mass("# from C:\\cases\\\ninclude heavy.prm\n"), 3.);
  EXPECT_EQ(read_mass("# from C:\\cases\\ \t\r\ninclude heavy.prm\r\n"), 3.) << "Windows";
  EXPECT_EQ(read_mass("# an old Mac \\\rsubsection Bird # and its lines\r  set Mass = 3\rend\r"), 3.);
  EXPECT_EQ(read_mass("subsection Bird\n  set Mass = 2 # kg \\\n  set Shape = flat\nend\n"), 2.);
  EXPECT_EQ(read_mass("subsection Bird\n  # set Mass = 1 \\\n  set Mass = 2\nend\n"), 2.);
  EXPECT_EQ(read_mass("\xEF\xBB\xBF# C:\\\ninclude heavy.prm"), 3.) << "with the mark of UTF-8";
}

TEST(ParameterScan, LinesThatEndInABackslashGoOnAndMayHoldComments)
{
  EXPECT_EQ(read_mass("subsection Bird\n  set Mass = \\ # a formula\n    1 + \\\n    1\nend\n"), 2.);
  EXPECT_EQ(read_mass("subsection Bird\n  set Mass = 1 + \\\n  # 5 + \\\n    1\nend\n"), 2.) << "a line taken out";
  EXPECT_EQ(read_mass("subsection Bird\n  set Mass = 2\nend\\"), 2.) << "the file ends there";
  expect_parts(read_bad("subsection Bird\n  set Mass = 1 + \\\n\n  set Mass = 2\nend\n"), {"line 2", "'1 +'"});
}

TEST(ParameterScan, DefaultGivesAnEntryOfAnyKindBack)
{
  const ScratchFolder scratch;
  const std::string   path = scratch.write("case.prm", "subsection Bird\n  set Mass = 3\n  set Shape = flat\n"
                                                         "  set Title = a text takes any word\nend\n");
  SmallCase           small;
  small.file.read(path, {"Bird/Mass=default", "Bird/Shape=default", "Bird/Title=default"});
  EXPECT_EQ(small.values.mass, SmallParameters().mass);
  EXPECT_EQ(small.values.shape, SmallParameters().shape);
  EXPECT_EQ(small.values.title, "");
  for (const char *entry : {"Bird/Mass", "Bird/Shape", "Bird/Title"})
    EXPECT_FALSE(small.file.is_given(entry)) << entry;
}

TEST(ParameterScan, BadOverridesNameThemselves)
{
  expect_parts(read_bad("", {"Bird/Mas=2"}), {"--set 'Bird/Mas=2'", "Nearest name here: 'Mass'"});
  expect_parts(read_bad("", {"Brid/Mass=2"}), {"'Brid'", "Nearest name here: 'Bird'"});
  expect_parts(read_bad("", {"Bird/Mass=heavy"}), {"--set", "'heavy'", "a number from 0 to 10"});
  expect_parts(read_bad("", {"Mass=2"}), {"Section/Sub section/Entry=value"});
  expect_parts(read_bad("", {"Bird/Mass"}), {"Section/Sub section/Entry=value"});
  expect_parts(read_bad("", {"Bird/Title=a # b"}), {"'#'"});
}

TEST(ParameterScan, IncludedFilesAreFoundBesideTheFileAndMayBeOverruled)
{
  const ScratchFolder scratch;
  scratch.write("base.prm", "subsection Bird\n  set Mass = 3\n  set Title = base\nend\n");
  SmallCase small;
  small.file.read(scratch.write("case.prm", "include base.prm\nsubsection Bird\n  set Mass = 4\nend\n"));
  EXPECT_EQ(small.values.mass, 4.);
  EXPECT_EQ(small.values.title, "base");

  try
    {
      small.file.read(scratch.write("broken.prm", "\ninclude bse.prm\n"));
      FAIL();
    }
  catch (const birdstrike::InputError &error)
    {
      expect_parts(error.what(), {"bse.prm", "Included by", "broken.prm, line 2", "base.prm'"});
    }
  const std::string loop = scratch.write("loop.prm", "include loop.prm\n");
  EXPECT_THROW(small.file.read(loop), birdstrike::InputError);
}

TEST(ParameterScan, EachEncodingAndEndOfLineIsRead)
{
  const std::string text  = "subsection Bird\n  set Mass = 2.5\nend\n";
  std::string       utf16 = "\xFF\xFE", carriage_returns = text;
  for (const char letter : text)
    utf16 += {letter, '\0'};
  std::replace(carriage_returns.begin(), carriage_returns.end(), '\n', '\r');
  for (const std::string &each : {text, utf16, utf16.substr(2), "\xEF\xBB\xBF" + text, carriage_returns})
    {
      const ScratchFolder scratch;
      SmallCase           small;
      small.file.read(scratch.write("case.prm", each), {});
      EXPECT_EQ(small.values.mass, 2.5);
      EXPECT_EQ(small.file.original(), text);
    }
}

TEST(ParameterScan, ReadsCommentsContinuationsAndCapitalKeywords)
{
  const ScratchFolder scratch;
  SmallCase           small;
  small.file.read(scratch.write("case.prm", "# comment\r\nSUBSECTION Bird # the bird\n"
                                            "  SET   Title =  a bird \\\n     of clay   # not of gel\n"
                                            "  subsection   Flight\n    set Velocity=1e2\n  end\nEND\n"));
  EXPECT_EQ(small.values.title, "a bird of clay");
  EXPECT_EQ(small.values.velocity, 100.);
}
