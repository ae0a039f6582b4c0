#include <birdstrike/core/fields.h>
#include <birdstrike/core/numerical_failure.h>
#include <birdstrike/io/fields.h>

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <zlib.h>

#include "scratch_folder.h"

using birdstrike::Field;
using birdstrike::FieldSeries;
using birdstrike::FieldSnapshot;

namespace
{
  using Tree = boost::property_tree::ptree;

  Tree read_xml(const std::filesystem::path &path)
  {
    Tree tree;
    boost::property_tree::read_xml(path.string(), tree);
    return tree;
  }

  std::string decode_base64(const std::string &text)
  {
    static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string              bytes;
    unsigned int             bits = 0, n_bits = 0;
    for (const char c : text)
      if (const std::size_t digit = letters.find(c); digit != std::string::npos)
        {
          bits = bits << 6 | static_cast<unsigned int>(digit);
          n_bits += 6;
          if (n_bits >= 8)
            bytes += static_cast<char>(bits >> (n_bits -= 8) & 0xff);
        }
    return bytes;
  }

  /// The numbers of one array: VTK's header of four 32-bit numbers (blocks, block size, last size, compressed size),
  /// then one zlib stream, each coded in base64 by itself.
  template <class T>
  std::vector<T> read_values(std::string text)
  {
    text.erase(std::remove_if(text.begin(), text.end(), [](const unsigned char c) { return std::isspace(c); }),
               text.end());
    if (text.empty())
      return {};
    const std::string header = decode_base64(text.substr(0, 24)), body = decode_base64(text.substr(24));
    std::uint32_t     sizes[4];
    std::memcpy(sizes, header.data(), sizeof(sizes));
    std::vector<T> values(sizes[1] / sizeof(T));
    uLongf         n_bytes = sizes[1];
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(values.data()), &n_bytes,
                         reinterpret_cast<const Bytef *>(body.data()), sizes[3]),
              Z_OK);
    return values;
  }

  struct Array
  {
    std::string               components, unit;
    std::vector<float>        values;
    std::vector<std::int32_t> whole;
  };

  /// Of PointData or CellData.
  std::map<std::string, Array> read_arrays(const Tree &tree, const std::string &where)
  {
    std::map<std::string, Array> arrays;
    for (const auto &[tag, node] : tree.get_child("VTKFile.UnstructuredGrid.Piece." + where))
      if (tag == "DataArray")
        {
          const bool is_whole                             = node.get<std::string>("<xmlattr>.type") == "Int32";
          arrays[node.get<std::string>("<xmlattr>.Name")] = {
            node.get("<xmlattr>.NumberOfComponents", ""), node.get("<xmlattr>.units", ""),
            is_whole ? std::vector<float>() : read_values<float>(node.data()),
            is_whole ? read_values<std::int32_t>(node.data()) : std::vector<std::int32_t>()};
        }
    return arrays;
  }

  /// Two quadrilaterals side by side.
  FieldSnapshot make_plate()
  {
    FieldSnapshot plate;
    plate.dim    = 2;
    plate.points = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
    plate.cells  = {0, 1, 3, 4, 1, 2, 4, 5};
    plate.fields.push_back({"displacement", "m", false, 3, {}});
    for (int i = 0; i < 18; ++i)
      plate.fields.back().values.push_back(0.5 * i);
    plate.fields.push_back({"thickness", "m", true, 1, {0.25, 0.75}});
    plate.fields.push_back({"stress", "Pa", true, 6, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}});
    plate.fields.push_back({"element", "", true, 1, {16777217, 4}, true}); // no float holds the first
    return plate;
  }
} // namespace

/// A header of three zeros, "no blocks", is what VTK takes for an array without values (vtkXMLDataReader, compressed
/// data); a block of no bytes is none.
TEST(FieldSeries, AnEmptyFileHoldsEmptyArrays)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "bird");
  FieldSnapshot       nothing;
  nothing.fields = {{"velocity", "m/s", false, 3, {}, false}, {"id", "-", false, 1, {}, true}};
  series.write(nothing, 1e-3);
  const Tree piece = read_xml(scratch.path() / "fields" / "bird_0000.vtu").get_child("VTKFile.UnstructuredGrid.Piece");
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfCells"), 0);
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfPoints"), 0);
  int n_arrays = 0;
  for (const std::string part : {"Points", "Cells", "PointData"})
    for (const auto &[tag, node] : piece.get_child(part))
      if (tag == "DataArray")
        {
          ++n_arrays;
          EXPECT_EQ(decode_base64(node.data()), std::string(12, '\0')) << part;
        }
  EXPECT_EQ(n_arrays, 1 + 3 + 2);
}

TEST(FieldSeries, PlateFileHoldsItsCellsAndArrays)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "blade");
  series.write(make_plate(), 1e-3);
  const Tree tree  = read_xml(scratch.path() / "fields" / "blade_0000.vtu");
  const Tree piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfCells"), 2);
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfPoints"), 6); // the cells share two

  std::map<std::string, std::string> topology;
  for (const auto &[tag, node] : piece.get_child("Cells"))
    if (tag == "DataArray")
      topology[node.get<std::string>("<xmlattr>.Name")] = node.data();
  constexpr std::uint8_t vtk_quad = 9;
  EXPECT_EQ(read_values<std::uint8_t>(topology.at("types")), (std::vector<std::uint8_t>{vtk_quad, vtk_quad}));
  EXPECT_EQ(read_values<std::int32_t>(topology.at("offsets")), (std::vector<std::int32_t>{4, 8}));
  EXPECT_EQ(read_values<std::int32_t>(topology.at("connectivity")),
            (std::vector<std::int32_t>{0, 1, 4, 3, 1, 2, 5, 4})); // VTK goes round a quadrilateral

  const auto at_nodes = read_arrays(tree, "PointData"), of_cells = read_arrays(tree, "CellData");
  ASSERT_EQ(at_nodes.size(), 1u);
  ASSERT_EQ(of_cells.size(), 3u);
  EXPECT_EQ(at_nodes.at("displacement").components, "3");
  EXPECT_EQ(at_nodes.at("displacement").unit, "m");
  const auto &displacement = at_nodes.at("displacement").values;
  ASSERT_EQ(displacement.size(), 18u);
  EXPECT_EQ(displacement[17], 8.5f);
  EXPECT_EQ(of_cells.at("thickness").values, (std::vector<float>{.25, .75}));
  EXPECT_EQ(of_cells.at("stress").components, "6");
  EXPECT_EQ(of_cells.at("stress").values[6], 7.f);
  EXPECT_EQ(of_cells.at("element").whole, (std::vector<std::int32_t>{16777217, 4}));
  const auto points = read_values<float>(piece.get_child("Points.DataArray").data());
  EXPECT_EQ(std::vector<float>(points.begin() + 15, points.begin() + 18), (std::vector<float>{2., 1., 0.}));
}

TEST(FieldSeries, HexahedraGoRoundTheirBottomAndTop)
{
  const ScratchFolder scratch;
  FieldSnapshot       brick;
  brick.dim    = 3;
  brick.points = std::vector<double>(24, 0.);
  brick.cells  = {0, 1, 2, 3, 4, 5, 6, 7};
  FieldSeries series(scratch.path(), "blade");
  series.write(brick, 0.);
  const Tree tree = read_xml(scratch.path() / "fields" / "blade_0000.vtu");
  for (const auto &[tag, node] : tree.get_child("VTKFile.UnstructuredGrid.Piece.Cells"))
    if (tag == "DataArray" && node.get<std::string>("<xmlattr>.Name") == "connectivity")
      {
        EXPECT_EQ(read_values<std::int32_t>(node.data()), (std::vector<std::int32_t>{0, 1, 3, 2, 4, 5, 7, 6}));
      }
}

TEST(FieldSeries, ParticlesAreVertexCells)
{
  const ScratchFolder scratch;
  FieldSnapshot       bird;
  bird.dim    = 0;
  bird.points = {0, 0, 0, 1, 2, 3};
  bird.fields.push_back({"pressure", "Pa", false, 1, {1e5, 2e5}});
  bird.fields.push_back({"velocity", "m/s", false, 3, {0, 0, 100, 0, 0, 200}});
  FieldSeries series(scratch.path(), "bird");
  series.write(bird, 0.);
  const Tree tree  = read_xml(scratch.path() / "fields" / "bird_0000.vtu");
  const Tree piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfCells"), 2);
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfPoints"), 2);
  const auto arrays = read_arrays(tree, "PointData");
  EXPECT_EQ(arrays.at("pressure").values, (std::vector<float>{1e5, 2e5}));
  EXPECT_EQ(arrays.at("velocity").values, (std::vector<float>{0, 0, 100, 0, 0, 200}));
}

TEST(FieldSeries, ListNamesEveryFileWithItsTime)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "blade");
  for (const double time : {0., 0.5e-3, 1e-3})
    series.write(make_plate(), time);
  const Tree          tree = read_xml(scratch.path() / "blade.pvd");
  std::vector<double> times;
  for (const auto &[tag, node] : tree.get_child("VTKFile.Collection"))
    if (tag == "DataSet")
      {
        times.push_back(node.get<double>("<xmlattr>.timestep"));
        EXPECT_TRUE(std::filesystem::exists(scratch.path() / node.get<std::string>("<xmlattr>.file")));
      }
  EXPECT_EQ(times, (std::vector<double>{0., 0.5e-3, 1e-3}));
  EXPECT_EQ(series.n_files(), 3u);
  std::size_t n_bytes = 0;
  for (const auto &file : std::filesystem::directory_iterator(scratch.path() / "fields"))
    n_bytes += file.file_size();
  EXPECT_EQ(series.n_bytes(), n_bytes);
}

TEST(FieldSeries, RefusesArraysThatDoNotFit)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "blade");
  FieldSnapshot       plate = make_plate();
  plate.fields[0].values.pop_back();
  EXPECT_THROW(series.write(plate, 0.), std::logic_error);
  plate          = make_plate();
  plate.cells[3] = 6;
  EXPECT_THROW(series.write(plate, 0.), std::logic_error);
  EXPECT_EQ(series.n_files(), 0u);
}

TEST(FieldSeries, ForecastIsTheSizeOfTheArrays)
{
  // 6 nodes with 3 + 3 floats; 2 cells with 1 + 6 + 1 values, 4 nodes and an offset of 4 bytes each and a 1-byte type.
  EXPECT_EQ(birdstrike::compute_field_file_bytes(make_plate()), 6u * 6 * 4 + 2u * ((8 + 5) * 4 + 1));
}

// 1e39 has no number in single precision, which the file is in.
TEST(FieldSeries, RefusesWhatIsNoNumberAndKeepsWhatIsThere)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "bird");
  FieldSnapshot       bird;
  bird.points = {0., 0., 0., 0.1, 0.2, 0.3};
  bird.fields = {{"velocity", "m/s", false, 3, std::vector<double>(6, 1.)}, {"id", "", false, 1, {5., 7.}, true}};
  series.write(bird, 0.);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e39})
    {
      FieldSnapshot lost           = bird;
      lost.fields[0].values[3 + 1] = bad;
      try
        {
          series.write(lost, 1e-3);
          ADD_FAILURE() << bad << " was written";
        }
      catch (const birdstrike::NumericalFailure &failure)
        {
          EXPECT_EQ(failure.facts().quantity, "velocity");
          EXPECT_EQ(failure.facts().time, 1e-3);
          EXPECT_STREQ(failure.facts().where.kind, "particle");
          EXPECT_EQ(failure.facts().where.id, 7u);
          EXPECT_EQ(failure.facts().where.position[2], 0.3);
        }
    }
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "fields/bird_0000.vtu"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "fields/bird_0001.vtu"));
  EXPECT_EQ(read_xml(scratch.path() / "bird.pvd").get_child("VTKFile.Collection").count("DataSet"), 1u);
}

TEST(FieldSeries, NamesTheElementOfAValueThatIsNone)
{
  const ScratchFolder scratch;
  FieldSeries         series(scratch.path(), "blade");
  FieldSnapshot       blade;
  blade.dim    = 2;
  blade.points = {0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0.};
  blade.cells  = {0, 1, 2, 3};
  blade.fields = {{"element", "", true, 1, {12.}, true}, {"damage", "-", true, 1, {std::nan("")}}};
  try
    {
      series.write(blade, 0.);
      FAIL();
    }
  catch (const birdstrike::NumericalFailure &failure)
    {
      EXPECT_STREQ(failure.facts().where.kind, "element");
      EXPECT_EQ(failure.facts().where.id, 12u);
      EXPECT_EQ(failure.facts().where.position[0], 0.5);
    }
}
