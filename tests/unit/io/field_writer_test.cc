#include <birdstrike/io/field_writer.h>
#include <birdstrike/io/fields.h>

#include <gtest/gtest.h>

#include "scratch_folder.h"

using namespace birdstrike;

namespace
{
  /// Enough points that writing takes longer than queueing.
  FieldSnapshot make_snapshot(const double value)
  {
    constexpr std::size_t n = 4000;
    FieldSnapshot         snapshot;
    snapshot.points.assign(3 * n, value);
    snapshot.cells.resize(n);
    for (std::uint32_t p = 0; p < n; ++p)
      snapshot.cells[p] = p;
    snapshot.fields.push_back({"pressure", "Pa", false, 1, std::vector<double>(n, value)});
    return snapshot;
  }

  std::string read_series(const std::filesystem::path &folder, const std::size_t n)
  {
    std::string text;
    for (std::size_t k = 0; k < n; ++k)
      text += read_text(folder / ("fields/bird_000" + std::to_string(k) + ".vtu"));
    return text;
  }
} // namespace

TEST(FieldWriter, WritesTheSameFilesAsTheSeriesItself)
{
  const ScratchFolder direct, threaded;
  FieldSeries         a(direct.path(), "bird"), b(threaded.path(), "bird");
  FieldWriter         writer(2);
  for (int k = 0; k < 6; ++k)
    {
      a.write(make_snapshot(k), 1e-3 * k);
      writer.write(b, make_snapshot(k), 1e-3 * k);
    }
  writer.flush();
  EXPECT_EQ(b.n_files(), 6u);
  EXPECT_EQ(read_series(direct.path(), 6), read_series(threaded.path(), 6));
}

TEST(FieldWriter, WritesWhatIsQueuedBeforeItEnds)
{
  const ScratchFolder folder;
  FieldSeries         series(folder.path(), "bird");
  try
    {
      FieldWriter writer(8);
      for (int k = 0; k < 5; ++k)
        writer.write(series, make_snapshot(k), k);
      throw std::runtime_error("the run has failed");
    }
  catch (const std::runtime_error &)
    {
    }
  EXPECT_EQ(series.n_files(), 5u);
}

TEST(FieldWriter, ThrowsAnErrorOfTheDiskInTheCaller)
{
  const ScratchFolder folder;
  FieldSeries         series(folder.path(), "bird");
  FieldWriter         writer;
  writer.write(series, make_snapshot(0), 0.);
  writer.flush();
  std::filesystem::remove_all(folder.path() / "fields");
  writer.write(series, make_snapshot(1), 1.);
  EXPECT_THROW(writer.flush(), std::runtime_error);
  EXPECT_NO_THROW(writer.flush()) << "said once";
}
