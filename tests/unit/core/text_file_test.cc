#include <birdstrike/core/text/text_file.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

// Bytes of UTF-16 below are from The Unicode Standard's own examples (section 3.9, table 3-4: U+004D, U+0430, U+4E8C,
// U+10302) and from what iconv writes.
namespace birdstrike::text_file_test
{
  using namespace std::string_literals;

  TEST(TextFile, Utf16BecomesUtf8)
  {
    const std::string letters = "\x4D\xD0\xB0\xE4\xBA\x8C\xF0\x90\x8C\x82"; // in UTF-8
    EXPECT_EQ(decode_text("\xFF\xFE\x4D\0\x30\x04\x8C\x4E\x00\xD8\x02\xDF"s), letters);
    EXPECT_EQ(decode_text("\xFE\xFF\0\x4D\x04\x30\x4E\x8C\xD8\x00\xDF\x02"s), letters);
    EXPECT_EQ(decode_text("1\0,\0 \0002\0\r\0\n\0"s), "1, 2\n") << "no mark, little end first";
    EXPECT_EQ(decode_text("\0001\0,\0 \0002\0\r\0\n"s), "1, 2\n") << "no mark, big end first";
    EXPECT_EQ(decode_text("\xFF\xFE"s), "") << "a mark alone";
    EXPECT_EQ(decode_text("\xFF\xFE\x00\xD8\x41\0\x42"s), "\xEF\xBF\xBD"
                                                          "A"
                                                          "\xEF\xBF\xBD")
      << "half a pair, half a letter";
  }

  TEST(TextFile, LinesEndInOneWay)
  {
    EXPECT_EQ(decode_text("a\nb\r\nc\rd\r\r\ne\n\rf\r\rg\r"), "a\nb\nc\nd\ne\n\nf\n\ng\n");
    EXPECT_EQ(decode_text("\xEF\xBB\xBF"
                          "a\x1A"),
              "a");
    EXPECT_EQ(decode_text("90\xB0"), "90\xB0") << "Latin-1 stays";
    EXPECT_EQ(decode_text(""), "");
  }

  TEST(TextFile, WhatIsNoTextIsNamed)
  {
    EXPECT_EQ(describe_no_text("$MeshFormat\n"), "");
    EXPECT_EQ(describe_no_text("CDF of peak forces, PK, BZh\n"), "") << "letters alone";
    EXPECT_NE(describe_no_text("\x1F\x8B\x08\x08"s).find("gunzip"), std::string::npos);
    EXPECT_NE(describe_no_text("PK\x03\x04\x14\0"s).find("CSV"), std::string::npos);
    EXPECT_NE(describe_no_text(decode_text("\x89HDF\r\n\x1A\n\0\0"s)).find("HDF5"), std::string::npos);
    EXPECT_NE(describe_no_text("CDF\x01\0\0"s).find("Exodus"), std::string::npos);
    EXPECT_NE(describe_no_text("\x7F"
                               "ELF\x02\x01\x01\0"s)
                .find("no text"),
              std::string::npos);
  }

  TEST(TextFile, SpreadsheetsNameTheirSeparator)
  {
    EXPECT_EQ(named_separator("sep=;"), ';');
    EXPECT_EQ(named_separator("\"SEP=,\""), ',');
    EXPECT_EQ(named_separator("sep=\t"), '\t');
    EXPECT_EQ(named_separator("step=;"), std::nullopt);
    EXPECT_EQ(named_separator("sep=;;"), std::nullopt);
    EXPECT_EQ(named_separator(""), std::nullopt);
  }

  TEST(TextFile, FoldersAndDevicesAreNotRead)
  {
    EXPECT_FALSE(read_text_file("/dev/zero"));
    EXPECT_FALSE(read_text_file(std::filesystem::temp_directory_path()));
    EXPECT_FALSE(read_text_file("no/such/file"));
  }
} // namespace birdstrike::text_file_test
