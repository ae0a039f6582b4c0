#include "report/measurement/data_table.h"
#include <birdstrike/core/errors.h>

#include <gtest/gtest.h>

#include <string>

#include "../io/scratch_folder.h"

// Tables as loggers and spreadsheets write them. Expected values are those that stand in the text, in SI.
namespace birdstrike::data_table_test
{
  namespace
  {
    DataTable read(const std::string &text)
    {
      static const ScratchFolder scratch;
      return DataTable(scratch.write("table.csv", text));
    }

    std::string refusal(const std::string &text, const std::string &column)
    {
      try
        {
          read(text).column(column);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    void expect_table(const std::string &text, const std::string &what)
    {
      const DataTable table = read(text);
      EXPECT_EQ(table.column("time").values, (std::vector<double>{0., 1e-3, 2e-3})) << what;
      EXPECT_EQ(table.column("load cell").values, (std::vector<double>{0., 5e3, -2.5e3})) << what;
    }
  } // namespace

  TEST(DataTable, WhatLoggersAndSpreadsheetsWriteIsRead)
  {
    const std::string rows = "0,0\n1,5\n2,-2.5\n", semicolons = "0;0\n1;5\n2;-2.5\n";
    for (const auto &[what, text] : std::vector<std::pair<std::string, std::string>>{
           {"square brackets", "time [ms],load cell [kN]\n" + rows},
           {"round brackets", "time (ms),load cell (kN)\n" + rows},
           {"strokes", "time / ms,load cell / kN\n" + rows},
           {"units below", "time,load cell\nms,kN\n" + rows},
           {"units below in round brackets", "time,load cell\n(ms),(kN)\n" + rows},
           {"sep=", "sep=;\ntime [ms];load cell [kN]\n" + semicolons},
           {"sep= in marks", "\"sep=,\"\ntime [ms],load cell [kN]\n" + rows},
           {"sep= of tabulators", "SEP=\t\ntime [ms]\tload cell [kN]\n0\t0\n1\t5\n2\t-2.5\n"},
           {"preamble", "Logger 3000, serial 17\nRate\n\ntime [ms];load cell [kN]\n" + semicolons},
           {"preamble of pairs",
            "Operator;Smith\nSample rate;10000\nDate;2024-05-06\ntime [ms];load cell [kN]\n" + semicolons},
           {"preamble of pairs, units below",
            "Operator;Smith\nSample rate;10000\ntime;load cell\nms;kN\n" + semicolons},
           {"preamble of one pair", "Operator;Smith\ntime (ms);load cell (kN)\n" + semicolons},
           {"longer preamble than table", "a\nb\nc\nd\ne\nf\ng\ntime [ms],load cell [kN]\n" + rows},
           {"preamble in commas", "Channels: time, force, none\ntime [ms];load cell [kN]\n" + semicolons},
           {"separators at the end", "time [ms];load cell [kN];\n0;0;\n1;5;\n2;-2.5;\n;;\n"},
           {"separators at the end of rows", "time [ms];load cell [kN]\n0;0;\n1;5;\n2;-2.5;\n"},
           {"blanks", "time[ms] \"load cell [kN]\"\n 0   0\n 1   5\n 2\t-2.5\n"},
           {"CR", "time [ms],load cell [kN]\r0,0\r1,5\r2,-2.5\r"},
           {"a column of words", "time [ms],load cell [kN],note\n0,0,\n1,5,hit\n2,-2.5,\n"},
           {"a column of dates", "date,time [ms],load cell [kN]\n2024-05-06,0,0\n2024-05-06,1,5\n2024-05-06,2,-2.5\n"}})
      expect_table(text, what);
  }

  TEST(DataTable, Utf16IsRead)
  {
    std::string bytes = "\xFF\xFE";
    for (const char letter : std::string("time [ms]\tload cell [kN]\r\n0\t0\r\n1\t5\r\n2\t-2.5\r\n"))
      bytes += {letter, '\0'};
    expect_table(bytes, "as spreadsheets write 'Unicode text'");
  }

  TEST(DataTable, AColumnIsKnownWithItsUnitToo)
  {
    const DataTable table = read("t,force (kN),force [N],force (filtered),f / x\n0,1,2,3,4\n");
    EXPECT_EQ(table.column("force (kN)").values[0], 1e3);
    EXPECT_EQ(table.column("force [N]").values[0], 2.);
    EXPECT_EQ(table.column("force (filtered)").values[0], 3.) << "no unit";
    EXPECT_EQ(table.column("f / x").values[0], 4.) << "no unit";
    EXPECT_NE(refusal("t,force (kN),force [N]\n0,1,2\n", "force").find("two columns are called 'force'"),
              std::string::npos);
  }

  TEST(DataTable, RowsThatDoNotFitAreNamedByTheirLine)
  {
    EXPECT_NE(refusal("time,force\n0,abc\n1,5\n2,6\n", "force").find("line 2: 'abc'"), std::string::npos);
    EXPECT_NE(refusal("Rig 3\ntime,force\n0,1\n1\n2,6\n3,7\n", "force")
                .find("line 4: 1 fields, where there are 2 names in line 2"),
              std::string::npos);
    EXPECT_NE(refusal("time,force\n0,1\ntime,force\n1,2\n2,6\n", "force").find("line 3: 'force'"), std::string::npos)
      << "a second head is no comment";
    EXPECT_NE(refusal("0,1\n1,2\n2,6\n", "force").find("line 1: '0' is no name"), std::string::npos);
    EXPECT_NE(refusal("time,1,2\n0,1,2\n1,2,3\n", "1").find("line 1: '1' is no name"), std::string::npos);
    EXPECT_NE(refusal("time;force\n0,0;1,5\n0,1;2,5\n", "force").find("decimal point"), std::string::npos);
    EXPECT_EQ(read("Rig 3\ntime,force\n0,1\n\n# stop\n2,6\n").line_of_row(1), 6u);
  }

  TEST(DataTable, AWorkbookIsNoTable)
  {
    EXPECT_NE(refusal(std::string("PK\x03\x04\0\0", 6), "force").find("save the sheet"), std::string::npos);
  }
} // namespace birdstrike::data_table_test
