#include <birdstrike/core/errors.h>
#include <birdstrike/io/option_number.h>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  std::string refusal_of_option(const std::string &word)
  {
    try
      {
        return "accepted as " + std::to_string(read_option_count("--number", word, 1, 1000));
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }
} // namespace

TEST(OptionNumber, IsReadAsInAParameterFile)
{
  EXPECT_EQ(read_option_count("--number", "010", 1, 1000), 10u) << "no octal number";
  EXPECT_EQ(read_option_count("--number", " 7 ", 1, 1000), 7u);
  EXPECT_EQ(read_option_count("--number", "2*4", 1, 1000), 8u);
  EXPECT_EQ(read_option_number("--ratio", "6/5"), 1.2);
  EXPECT_EQ(read_option_number("--ratio", "01.5"), 1.5);
}

TEST(OptionNumber, RefusesWhatIsNoNumberOfTheRange)
{
  for (const char *word : {"", " ", "1e1", "2.5", "1'5", "0", "1001", "-3", "nan", "99999999999999999999", "ten"})
    EXPECT_NE(refusal_of_option(word).find("Allowed: an integer from 1 to 1000"), std::string::npos)
      << word << ": " << refusal_of_option(word);
  EXPECT_NE(refusal_of_option("0x10").find("the unit 'x10' is not known"), std::string::npos)
    << "no hexadecimal number";
  EXPECT_NE(refusal_of_option("1,5").find("a decimal comma"), std::string::npos) << refusal_of_option("1,5");
  EXPECT_NE(refusal_of_option("3 mm").find("plain number"), std::string::npos) << refusal_of_option("3 mm");
}
