#include <birdstrike/core/archive.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/number.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace birdstrike;

namespace
{
  /// One of everything that parts hold.
  struct Part
  {
    double                           energy = 0.;
    bool                             is_wet = false;
    std::vector<std::uint64_t>       ids;
    std::vector<Point3>              position;
    std::vector<float>               correction;
    std::vector<std::int32_t>        piece;
    std::vector<std::vector<double>> bounds;
    std::array<Lanes, 2>             stress{};

    void archive(Archive &archive)
    {
      const auto group = archive.group("part");
      archive("energy", energy);
      archive("is wet", is_wet);
      archive.population("particles", ids);
      correction.resize(ids.size());
      position.resize(ids.size());
      piece.resize(ids.size());
      bounds.resize(ids.size());
      archive.rows("particles", ids.size(), [&](Archive::Row &row, const std::size_t p) {
        row("position", position[p]);
        row("correction", correction[p]);
        row("piece", piece[p]);
        row.list("bounds", bounds[p]);
      });
      archive.entities("elements", 2 * n_lanes, [&](Archive::Row &row, const std::size_t e) {
        row("stress", stress[e / n_lanes][e % n_lanes]);
      });
    }
  };

  Part make_part()
  {
    Part part;
    part.energy     = 0.1;
    part.is_wet     = true;
    part.ids        = {7, 3};
    part.position   = {{1., 2., 3.}, {4., 5., 6.}};
    part.correction = {0.3f, -0.f};
    part.piece      = {-1, 5};
    part.bounds     = {{}, {1e300, 2.}};
    for (std::size_t e = 0; e < 2 * n_lanes; ++e)
      part.stress[e / n_lanes][e % n_lanes] = 0.7 * static_cast<double>(e);
    return part;
  }

  ArchivedState write(Part &part)
  {
    ArchivedState state;
    Archive       archive = Archive::writing(state);
    part.archive(archive);
    return state;
  }

  std::string message_of_reading(const ArchivedState &state)
  {
    try
      {
        Part    part;
        Archive archive = Archive::reading(state);
        part.archive(archive);
        archive.finish();
        return "";
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }
} // namespace

TEST(Archive, ReadsToTheBitWhatItWrote)
{
  Part                part    = make_part(), again;
  const ArchivedState state   = write(part);
  Archive             archive = Archive::reading(state);
  again.archive(archive);
  archive.finish();
  EXPECT_EQ(find_difference(state, write(again)), "");
  EXPECT_EQ(again.piece, part.piece);
  EXPECT_EQ(again.ids, part.ids);
  EXPECT_TRUE(std::signbit(again.correction[1]));
}

TEST(Archive, NamesEveryQuantityByPartAndEntities)
{
  Part                part  = make_part();
  const ArchivedState state = write(part);
  EXPECT_EQ(state.at("part/particles/position").real, (std::vector<double>{1., 2., 3., 4., 5., 6.}));
  EXPECT_EQ(state.at("part/particles").whole, part.ids);
  EXPECT_EQ(state.at("part/particles/bounds").lengths, (std::vector<std::uint64_t>{0, 2}));
  EXPECT_EQ(state.at("part/elements/stress").real[n_lanes], 0.7 * n_lanes);
}

namespace
{
  /// A population of many, and what comes of it piece by piece.
  struct Pieces : StateSink
  {
    ArchivedState whole;
    std::size_t   largest = 0;

    void take(const std::string &name, const ArchivedQuantity &piece) override
    {
      largest                    = std::max(largest, piece.size());
      ArchivedQuantity &quantity = whole[name];
      quantity.is_real           = piece.is_real;
      quantity.n_components      = piece.n_components;
      quantity.real.insert(quantity.real.end(), piece.real.begin(), piece.real.end());
      quantity.whole.insert(quantity.whole.end(), piece.whole.begin(), piece.whole.end());
      quantity.lengths.insert(quantity.lengths.end(), piece.lengths.begin(), piece.lengths.end());
    }
  };

  void describe_many(Archive &archive)
  {
    archive.rows("nodes", 100000, [](Archive::Row &row, const std::size_t n) {
      std::vector<std::uint64_t> list(n % 3, n);
      row("place", 0.1 * static_cast<double>(n), 1., 2.);
      row.list("neighbors", list);
    });
  }
} // namespace

// So that a checkpoint of a million particles stands nowhere as a whole beside the particles.
TEST(Archive, HandsOverManyEntitiesPieceByPiece)
{
  ArchivedState collected;
  Archive       to_memory = Archive::writing(collected);
  describe_many(to_memory);
  Pieces  pieces;
  Archive to_sink = Archive::writing(pieces);
  describe_many(to_sink);
  EXPECT_EQ(find_difference(collected, pieces.whole), "");
  EXPECT_LE(pieces.largest, 3u * 4096u);
  EXPECT_EQ(collected.at("nodes/place").real.size(), 300000u);
  EXPECT_EQ(collected.at("nodes/neighbors").lengths[99998], 99998u % 3);

  StateInventory sizes;
  Archive        to_sizes = Archive::writing(sizes);
  describe_many(to_sizes);
  EXPECT_EQ(sizes.shapes().size(), 2u);
  EXPECT_EQ(sizes.shapes().at("nodes/place").n_values, 300000u);
  EXPECT_EQ(sizes.shapes().at("nodes/place").n_components, 3u);
  EXPECT_EQ(sizes.shapes().at("nodes/neighbors").n_values,
            99999u); // of three lists in a row 0, 1, 2; 100000 = 3 x 33333 + 1
  EXPECT_EQ(sizes.shapes().at("nodes/neighbors").n_lengths, 100000u);
}

// What another number of ranks has written comes in another order.
TEST(Archive, PutsEntitiesWhereTheirIdsBelong)
{
  Part          part  = make_part(), again;
  ArchivedState state = write(part);
  auto         &ids   = state.at("part/elements").whole;
  auto         &value = state.at("part/elements/stress").real;
  std::reverse(ids.begin(), ids.end());
  std::reverse(value.begin(), value.end());
  Archive archive = Archive::reading(state);
  again.archive(archive);
  EXPECT_EQ(find_difference(write(part), write(again)), "");
}

TEST(Archive, NamesWhatIsMissingTooMuchOrOfAnotherShape)
{
  Part                part  = make_part();
  const ArchivedState whole = write(part);
  ArchivedState       less = whole, more = whole, other = whole, fewer = whole;
  less.erase("part/particles/piece");
  EXPECT_NE(message_of_reading(less).find("no 'part/particles/piece'"), std::string::npos);
  more["part/colour"];
  EXPECT_NE(message_of_reading(more).find("'part/colour'"), std::string::npos);
  other.at("part/particles/position").real.pop_back();
  EXPECT_NE(message_of_reading(other).find("'part/particles/position' of 5 values"), std::string::npos);
  fewer.at("part/elements").whole[0] = 99;
  EXPECT_NE(message_of_reading(fewer).find("'part/elements'"), std::string::npos);
  EXPECT_EQ(message_of_reading(whole), "");
}

TEST(Archive, TellsTheFirstDifferenceByNameAndEntity)
{
  Part          part  = make_part();
  ArchivedState state = write(part), other = state;
  other.at("part/particles/position").real[4] = -5.;
  EXPECT_EQ(find_difference(state, other), "'part/particles/position', entity 1 in order, component 1: 5 and -5");
  other                                         = state;
  other.at("part/particles/correction").real[1] = 0.; // not the same bits as -0
  EXPECT_NE(find_difference(state, other), "");
  other = state;
  other.erase("part/energy");
  EXPECT_EQ(find_difference(state, other), "'part/energy' is missing in the second");
  EXPECT_EQ(find_difference(other, state), "'part/energy' is missing in the first");
}
