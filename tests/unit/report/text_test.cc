#include <birdstrike/report/text.h>

#include <gtest/gtest.h>

using namespace birdstrike;

TEST(Text, QuantitiesTakePrefixes)
{
  EXPECT_EQ(format_quantity(0.00427, "m"), "4.27 mm");
  EXPECT_EQ(format_quantity(0., "J"), "0 J");
  EXPECT_EQ(format_quantity(28320., "J"), "28.32 kJ");
  EXPECT_EQ(format_quantity(-9.3e8, "Pa"), "-930 MPa");
  EXPECT_EQ(format_quantity(999.96, "N"), "1 kN");
  EXPECT_EQ(format_quantity(999.94, "N"), "999.9 N");
  EXPECT_EQ(format_quantity(3.2e-7, "s"), "320 ns");
  EXPECT_EQ(format_quantity(1e-12, "m"), "0.001 nm");
  EXPECT_EQ(format_quantity(1.8, "kg"), "1.8 kg");
  EXPECT_EQ(format_quantity(0.05, "-"), "0.05");
}

TEST(Text, BytesCountsAndDurations)
{
  EXPECT_EQ(format_bytes(0), "0 B");
  EXPECT_EQ(format_bytes(1536), "1.5 KiB");
  EXPECT_EQ(format_bytes(3. * 1024 * 1024 * 1024), "3 GiB");
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1234567), "1 234 567");
  EXPECT_EQ(format_duration(4.2), "4.2 s");
  EXPECT_EQ(format_duration(59.99), "1 min 00 s");
  EXPECT_EQ(format_duration(200), "3 min 20 s");
  EXPECT_EQ(format_duration(7500), "2 h 05 min");
  EXPECT_EQ(format_duration(-1), "unknown");
  EXPECT_EQ(format_share(0.0123), "1.23 %");
}

TEST(Text, TableAlignsItsValues)
{
  TextTable table("Case");
  table.add_heading("Bird");
  table.add("mass", 1.8, "kg");
  table.add("kinetic energy", 28320., "J");
  EXPECT_EQ(table.text(), "Case\nBird\n  mass            1.8 kg\n  kinetic energy  28.32 kJ\n");
}
