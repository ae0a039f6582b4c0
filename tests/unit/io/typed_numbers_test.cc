#include "io/typed_numbers.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/units.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scratch_folder.h"

using namespace birdstrike;

namespace
{
  /// In SI units; NaN for what is no unit.
  double one(const std::string &unit)
  {
    const auto parsed = parse_unit(unit);
    return parsed ? parsed->to_si(1.) : std::nan("");
  }

  /// The text that an entry of the program gets for what is typed.
  std::string read(const std::string &path, const std::string &typed)
  {
    static const CaseParameters parameters;
    static const ParameterTree  tree  = parameters.file.tree();
    const std::size_t           slash = path.rfind('/');
    SectionPath                 section;
    for (std::size_t begin = 0, end; begin < slash; begin = end + 1)
      {
        end = std::min(path.find('/', begin), slash);
        section.push_back(path.substr(begin, end - begin));
      }
    return read_typed_numbers(typed, *tree.find(section, path.substr(slash + 1)), "here");
  }

  double value(const std::string &path, const std::string &typed)
  {
    return std::stod(read(path, typed));
  }

  std::string refusal_of_number(const std::string &path, const std::string &typed)
  {
    try
      {
        return "accepted as " + read(path, typed);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }
} // namespace

TEST(TypedNumbers, FunctionsHaveSeveralArguments)
{
  EXPECT_EQ(value("Bird/Mass", "max(1, 2)"), 2.);
  EXPECT_EQ(value("Bird/Mass", "min(1,2) kg"), 1.);
  EXPECT_EQ(value("Bird/Mass", "max(500, pow(2, 3)) g"), 0.5);
  EXPECT_NEAR(value("Bird/Yaw", "atan2(1, 1)*180/pi"), 45., 1e-13);
  EXPECT_EQ(value("Bird/Mass", "if(1<2, 3, 4)"), 3.);
  EXPECT_EQ(value("Bird/Speed", "max(100, 150)"), 150.) << "of a list of at most one number";
  EXPECT_EQ(read("Bird/Velocity", "0, min(1, 2), max(3, 4)"), "0, 1, 4");
  EXPECT_EQ(read("Bird/Velocity", "0, 0, max(36, 72) km/h"), "0, 0, 20");
  EXPECT_EQ(read("Bird/Mass", "(1, 2)"), "(1, 2)") << "no number: left to the entry's pattern";
  EXPECT_EQ(read("Bird/Mass", "1, 2, 3"), "1, 2, 3");
}

TEST(TypedNumbers, UnitsInsideFunctionsAndUnknownOnesAreNamed)
{
  EXPECT_NE(refusal_of_number("Bird/Mass", "max(1 kg, 2 kg)").find("'kg' stands inside a formula"), std::string::npos);
  EXPECT_NE(refusal_of_number("Blade/Thickness/Value", "0.168 parsec").find("the unit 'parsec' is not known"),
            std::string::npos);
  for (const char *formula : {"0.003 + 0.001*x", "1e-3*exp(-x/1e-2)", "4e-3*x", "3e-3", "if(x<0.1, 0.004, 0.002)"})
    EXPECT_EQ(read("Blade/Thickness/Value", formula), formula);
  EXPECT_EQ(read("Blade/Loads/Pressure", "1e6*exp(-t/1e-4)"), "1e6*exp(-t/1e-4)");
}

// One mil is a thousandth of an inch of 25.4 mm; the others are other spellings of units.
TEST(Units, AreKnownByOtherSpellingsToo)
{
  EXPECT_NEAR(one("mil"), 25.4e-6, 1e-20);
  EXPECT_EQ(one("µs"), one("us"));
  EXPECT_EQ(one("μm"), one("um"));
  EXPECT_EQ(one("lbm"), one("lb"));
  EXPECT_EQ(one("g/cc"), one("g/cm^3"));
  EXPECT_EQ(one("m/sec"), one("m/s"));
  EXPECT_EQ(one("tonne"), 1000.);
  EXPECT_EQ(one("KT"), one("knots"));
  EXPECT_EQ(parse_unit("°C")->offset, 273.15);
  EXPECT_NEAR(value("Time/End time", "2000 µs"), 2e-3, 1e-18);
}

// Exact by definition: NIST SP 811 (2008), appendix B.8; to round-off.
TEST(Units, AreThoseOfTheStandards)
{
  const auto expect = [](const char *unit, const double si) { EXPECT_NEAR(one(unit), si, 4e-16 * si) << unit; };
  expect("in", 0.0254);
  expect("ft", 0.3048);
  expect("lb", 0.45359237);
  expect("lbf", 4.4482216152605);
  expect("psi", 6894.757293168361);
  expect("knots", 1852. / 3600.);
  expect("kts", 1852. / 3600.);
  expect("mph", 0.44704);
  expect("rpm", 0.10471975511965977);
  expect("deg", 0.017453292519943295);
  expect("g/cm^3", 1000.);
  expect("t/mm^3", 1e12);
  expect("J/(kg K)", 1.);
  expect("N/mm^2", 1e6);
  expect("N/mm2", 1e6);
  expect("kg/m3", 1.);
  expect("mm/ms2", 1e3);
  expect("km/h", 1. / 3.6);
  expect("1/s", 1.);
  expect("N mm", 1e-3);
  expect("degC", 274.15);
  for (const char *text :
       {"", "-", "furlong", "m/", "m^", "(m", "m)", "m^99", "5 m", "m99", "m2.5", "m 2", "m2^2", "2m", "(mm)2"})
    EXPECT_FALSE(parse_unit(text)) << text;
}

TEST(TypedNumbers, APlainNumberStaysAsItIsTyped)
{
  for (const char *text : {"0.0025", "2.50e-3", "-1", "1E5"})
    EXPECT_EQ(read("Bird/Chordwise offset", text), text);
  EXPECT_EQ(read("Bird/Velocity", "0, 0, 177.4"), "0, 0, 177.4");
}

TEST(TypedNumbers, DecimalUnitsGiveTheVeryNumber)
{
  EXPECT_EQ(value("Bird/Particle spacing", "2.5 mm"), 0.0025);
  EXPECT_EQ(value("Blade/Mesh/Length", "311.2mm"), 0.3112);
  EXPECT_EQ(value("Blade/Thickness/Value", "4.27 mm"), 0.00427);
  EXPECT_EQ(value("Blade/Material/Density", "4.43 g/cm^3"), 4430.);
  EXPECT_EQ(value("Blade/Material/Density", "4.43e-9 t/mm^3"), 4430.);
  EXPECT_EQ(value("Blade/Material/Yield stress", "880 MPa"), 880e6);
  EXPECT_EQ(value("Bird/Yaw", "36.4 deg"), 36.4);
  EXPECT_EQ(value("Time/End time", "12 ms"), 12e-3);
}

TEST(TypedNumbers, FormulasAndUnitsGoTogether)
{
  EXPECT_DOUBLE_EQ(value("Blade/Loads/Damping", "2*pi*50 Hz"), 100. * M_PI);
  EXPECT_DOUBLE_EQ(value("Bird/Chordwise offset", "-88.9/2 mm"), -0.04445);
  EXPECT_DOUBLE_EQ(value("Blade/Material/Poisson's ratio", "1/3"), 1. / 3.);
  EXPECT_DOUBLE_EQ(value("Bird/Equation of state/Sound speed", "2*(700 + 41.45)"), 1482.9);
  EXPECT_DOUBLE_EQ(value("Blade/Material/Initial temperature", "20 degC"), 293.15);
  EXPECT_DOUBLE_EQ(value("Bird/Yaw", "pi/6 rad"), 30.);
  EXPECT_EQ(read("Time/Maximum ratio", "2*4"), "8");
}

TEST(TypedNumbers, ListsHaveAUnitForEachNumberOrOneForAll)
{
  EXPECT_EQ(read("Bird/Aim point", "217.84 mm, 0, 1 cm"), "0.21784, 0, 0.01");
  EXPECT_EQ(read("Bird/Aim point", "217.84, 0, 10 mm"), "0.21784, 0, 0.01");
  EXPECT_NE(refusal_of_number("Bird/Aim point", "217.84 mm, 5, 0").find("'5' has no unit"), std::string::npos);
  EXPECT_DOUBLE_EQ(value("Blade/Rigid/Centre", "2*25 mm, 0, 0"), 0.05);
}

TEST(TypedNumbers, TextsAreReadPieceByPieceAndFormulasLeftAlone)
{
  EXPECT_EQ(read("Blade/Thickness/By material", "1: 4 mm; 2: 3 mm"), "1: 0.004; 2: 0.003");
  EXPECT_EQ(read("Blade/Loads/Initial spin", "0; 300 rpm; 0"), "0; 31.41592653589793; 0");
  for (const char *formula : {"1e6*exp(-t/1e-4)", "if(x<0.1, 1e5, 0)", "0.004+0.001*x", ""})
    EXPECT_EQ(read("Blade/Loads/Pressure", formula), formula);
  EXPECT_EQ(read("Blade/Supports/Driven", "3: uz = 1e-3*sin(2*pi*100*t)"), "3: uz = 1e-3*sin(2*pi*100*t)");
  EXPECT_EQ(read("Blade/Probes", "tip 1 m: 0.3 0 0"), "tip 1 m: 0.3 0 0");
  EXPECT_EQ(read("Case/Name", "blade of 4 mm"), "blade of 4 mm");
  EXPECT_EQ(read("Blade/Material/Density", "table"), "table");
}

TEST(TypedNumbers, WrongUnitsAreRefusedInWords)
{
  const std::string mass = refusal_of_number("Bird/Mass", "3 mm");
  EXPECT_NE(mass.find("here: 'Mass' = '3 mm': 'mm' is a unit of something else"), std::string::npos) << mass;
  EXPECT_NE(mass.find("Unit of this entry: kg; units that it takes: kg, g, mg, t, lb, oz."), std::string::npos) << mass;
  EXPECT_NE(refusal_of_number("Bird/Mass", "3 stone").find("the unit 'stone' is not known"), std::string::npos);
  EXPECT_NE(refusal_of_number("Bird/Mass", "0,1").find("a decimal comma"), std::string::npos);
  EXPECT_NE(refusal_of_number("Blade/Loads/Initial spin", "0; 50 Hz; 0").find("something else"), std::string::npos);
  EXPECT_NE(refusal_of_number("Blade/Material/Yield stress", "880 mm").find("something else"), std::string::npos);
  EXPECT_NE(refusal_of_number("Bird/Length over diameter", "2 m").find("a plain number"), std::string::npos);
}
