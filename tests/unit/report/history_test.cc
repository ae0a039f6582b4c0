#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/report/history.h>

#include <gtest/gtest.h>

#include <deal.II/base/hdf5.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../io/scratch_folder.h"

using birdstrike::History;

namespace
{
  /// Two columns and one profile over [3 stations][2 faces] in which every value is different.
  void record(History &history, double &time, const int n_rows)
  {
    history.add_column({"time", "s"}, [&time] { return time; });
    history.add_column({"tip_deflection", "m"}, [&time] { return std::sin(1. / (time + 0.3)); });
    history.add_profile({"root_stress", "Pa"}, {{{"chord", "m"}, {-1., 0., 1.}}, {{"face", "-"}, {-1., 1.}}},
                        [&time](const std::span<double> values) {
                          for (std::size_t i = 0; i < values.size(); ++i)
                            values[i] = 1e6 * time + i / 7.;
                        });
    for (int i = 0; i < n_rows; ++i)
      {
        time = 0.1 * i;
        history.append_row();
        if (i == 1)
          history.flush();
      }
  }
} // namespace

TEST(History, TableNumbersItsColumnsAndReadsBackExactly)
{
  const ScratchFolder scratch;
  double              time = 0.;
  {
    History history(scratch.path(), false);
    record(history, time, 5);
  }
  std::ifstream in(scratch.path() / "history.csv");
  std::string   line;
  for (const std::string expected : {"# 1: time [s]", "# 2: tip_deflection [m]", "time,tip_deflection"})
    {
      ASSERT_TRUE(std::getline(in, line));
      EXPECT_EQ(line, expected);
    }
  for (int i = 0; i < 5; ++i)
    {
      ASSERT_TRUE(std::getline(in, line));
      EXPECT_EQ(std::stod(line), 0.1 * i);
      EXPECT_EQ(std::stod(line.substr(line.find(',') + 1)), std::sin(1. / (0.1 * i + 0.3)));
    }
  EXPECT_FALSE(std::getline(in, line));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "results.h5"));
}

TEST(History, ResultsFileHoldsColumnsProfilesAxesAndUnits)
{
  const ScratchFolder scratch;
  double              time = 0.;
  {
    History history(scratch.path(), true);
    record(history, time, 4);
    history.set_constant({"root_stress_at_peak", "Pa"}, {{{"chord", "m"}, {0., 1.}}}, {3., 4.});
  }
  using dealii::HDF5::File;
  File file((scratch.path() / "results.h5").string(), File::FileAccessMode::open);
  auto deflection = file.open_dataset("history/tip_deflection");
  EXPECT_EQ(deflection.get_attribute<std::string>("unit"), "m");
  const auto read = deflection.read<std::vector<double>>();
  ASSERT_EQ(read.size(), 4u);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(read[i], std::sin(1. / (0.1 * i + 0.3)));

  auto stress = file.open_dataset("root_stress/values");
  EXPECT_EQ(stress.get_dimensions(), (std::vector<hsize_t>{4, 3, 2}));
  EXPECT_EQ(stress.get_attribute<std::string>("unit"), "Pa");
  // Row 3, station 1, face 1 is value 3 of its row: the last axis runs fastest.
  EXPECT_EQ(stress.read_hyperslab<std::vector<double>>({3, 1, 1}, {1, 1, 1}).at(0), 1e6 * (0.1 * 3) + 3. / 7.);
  EXPECT_EQ(file.open_dataset("root_stress/chord").read<std::vector<double>>(), (std::vector<double>{-1., 0., 1.}));
  EXPECT_EQ(file.open_dataset("root_stress_at_peak/values").read<std::vector<double>>(), (std::vector<double>{3., 4.}));
}

TEST(History, RefusesBadNamesAndLateColumns)
{
  const ScratchFolder scratch;
  History             history(scratch.path(), true);
  const auto          one = [] { return 1.; };
  history.add_column({"time", "s"}, one);
  EXPECT_THROW(history.add_column({"time", "s"}, one), std::logic_error);
  EXPECT_THROW(history.add_column({"a,b", "s"}, one), std::logic_error);
  EXPECT_THROW(history.set_constant({"c", "m"}, {{{"x", "m"}, {1., 2.}}}, {1.}), std::logic_error);
  history.append_row();
  EXPECT_THROW(history.add_column({"late", "s"}, one), std::logic_error);
  EXPECT_EQ(history.n_rows(), 1u);
  EXPECT_EQ(history.column("time"), std::vector<double>{1.});
  EXPECT_THROW(history.column("none"), std::logic_error);
}

TEST(History, FailingRunKeepsItsTable)
{
  const ScratchFolder scratch;
  double              time = 0.;
  EXPECT_THROW(
    {
      History history(scratch.path(), true);
      record(history, time, 5);
      throw std::runtime_error("the run is lost");
    },
    std::runtime_error);
  const std::string text = read_text(scratch.path() / "history.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 5);
  // From the flush after two rows.
  dealii::HDF5::File file((scratch.path() / "results.h5").string(), dealii::HDF5::File::FileAccessMode::open);
  EXPECT_EQ(file.open_dataset("history/time").read<std::vector<double>>().size(), 2u);
}

TEST(History, RefusesAFolderThatDoesNotExist)
{
  EXPECT_THROW(History("/no/such/folder", false), std::runtime_error);
}

TEST(History, RefusesARowThatHoldsWhatIsNoNumber)
{
  const ScratchFolder scratch;
  double              time = 0., stress = 1.;
  {
    History history(scratch.path(), true);
    history.add_column({"time", "s"}, [&time] { return time; });
    history.add_column({"deflection", "m"}, [&time] { return 1. / (1. - time); });
    history.add_profile({"root_stress", "Pa"}, {{{"chord", "m"}, {0., 1.}}},
                        [&stress](const std::span<double> values) { values[0] = values[1] = stress; });
    history.append_row();
    time = 1.;
    EXPECT_THROW(history.append_row(), birdstrike::NumericalFailure);
    time   = 2.;
    stress = std::nan("");
    EXPECT_THROW(history.append_row(), birdstrike::NumericalFailure);
    stress = 1.;
    history.append_row();
  }
  std::ifstream in(scratch.path() / "history.csv");
  std::string   text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_TRUE(text.ends_with("\n0,1\n2,-1\n")) << text;
  dealii::HDF5::File results((scratch.path() / "results.h5").string(), dealii::HDF5::File::FileAccessMode::open);
  EXPECT_EQ(results.open_dataset("/history/deflection").get_dimensions()[0], 2u);
  EXPECT_EQ(results.open_dataset("/root_stress/values").get_dimensions()[0], 2u);
}
