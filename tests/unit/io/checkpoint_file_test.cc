#include <birdstrike/core/errors.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/hdf5_handle.h>
#include <birdstrike/io/whole_file.h>

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <random>

#include "scratch_folder.h"

using namespace birdstrike;

// HDF5 File Format Specification, II.A: the version of the superblock follows the eight letters of the signature.
TEST(CheckpointFile, HasTheFormatThatWeSetWhateverLibraryWrites)
{
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  ASSERT_TRUE(set_format(access));
  H5F_libver_t low = H5F_LIBVER_LATEST, high = H5F_LIBVER_LATEST;
  ASSERT_GE(H5Pget_libver_bounds(access, &low, &high), 0);
  EXPECT_EQ(low, H5F_LIBVER_EARLIEST);
  EXPECT_EQ(high, H5F_LIBVER_V18);
  const ScratchFolder scratch;
  const auto          file = scratch.path() / "a.h5";
  write_checkpoint(file, {"", {}, "", 0., 0, {}});
  const std::string bytes = read_whole_file(file), signature = "\x89HDF\r\n\x1a\n";
  ASSERT_EQ(bytes.substr(512, signature.size()), signature);
  EXPECT_EQ(bytes[512 + signature.size()], 0);
}

namespace
{
  Checkpoint some_checkpoint()
  {
    Checkpoint checkpoint;
    checkpoint.parameters = "subsection Case\n  set Name = a \"b\"\nend\n";
    checkpoint.inputs     = {{"a mesh with blanks.msh", "0123456789abcdef"}, {"b.k", "ffffffffffffffff"}};
    checkpoint.program    = "0.2.0 abc";
    checkpoint.time       = 0.1 + 0.2;
    checkpoint.step       = 123456789012345;
    ArchivedState state;
    Archive       archive = Archive::writing(state);
    {
      const auto          group = archive.group("blade");
      double              speed = -0.;
      std::vector<double> list{1., std::numeric_limits<double>::denorm_min(), INFINITY, NAN};
      archive("speed", speed);
      archive.list("list", list);
      std::vector<double> none;
      archive.list("none", none);
      archive.entities("nodes", 3, [](Archive::Row &row, const std::size_t n) {
        double        x = 1. / (1. + n), y = -1e300 * n;
        std::uint32_t flag = n == 1;
        row("position", x, y);
        row("is held", flag);
      });
    }
    checkpoint.state = state;
    return checkpoint;
  }

  std::string said_of(const std::filesystem::path &file)
  {
    try
      {
        read_checkpoint(file);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

TEST(CheckpointFile, ReadsBackToTheLastBit)
{
  const ScratchFolder scratch;
  const auto          file    = scratch.path() / "checkpoint.h5";
  const Checkpoint    written = some_checkpoint();
  write_checkpoint(file, written);
  const Checkpoint read = read_checkpoint(file);
  EXPECT_EQ(read.parameters, written.parameters);
  EXPECT_EQ(read.inputs, written.inputs);
  EXPECT_EQ(read.program, written.program);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(find_difference(written.state, read.state), "") << "bits, so that NaN and -0 count";
  EXPECT_EQ(read.state.size(), written.state.size());
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

// In pieces and in any order, each in its place.
TEST(CheckpointFile, OfAStateThatComesInPiecesIsTheSameFile)
{
  const ScratchFolder scratch;
  const auto          at_once = scratch.path() / "at_once.h5", in_pieces = scratch.path() / "in_pieces.h5";
  Checkpoint          checkpoint = some_checkpoint();
  write_checkpoint(at_once, checkpoint);
  StateInventory sizes;
  for (const auto &[name, quantity] : checkpoint.state)
    sizes.take(name, quantity);
  const ArchivedState state = std::move(checkpoint.state);
  checkpoint.state.clear();
  const auto describe = [&](StateSink &to) {
    for (auto entry = state.rbegin(); entry != state.rend(); ++entry)
      {
        ArchivedQuantity  one = entry->second, rest = one;
        const std::size_t n = one.size() / 2;
        if (one.is_real)
          {
            one.real.resize(n);
            rest.real.erase(rest.real.begin(), rest.real.begin() + static_cast<std::ptrdiff_t>(n));
          }
        else
          {
            one.whole.resize(n);
            rest.whole.erase(rest.whole.begin(), rest.whole.begin() + static_cast<std::ptrdiff_t>(n));
          }
        rest.lengths.clear();
        to.take(entry->first, one);
        to.take(entry->first, rest);
      }
  };
  write_checkpoint(in_pieces, checkpoint, sizes, describe);
  EXPECT_EQ(find_difference(read_checkpoint(at_once).state, read_checkpoint(in_pieces).state), "");
  EXPECT_EQ(find_difference(read_checkpoint(in_pieces).state, state), "");

  const auto describe_less = [&](StateSink &to) { to.take(state.begin()->first, state.begin()->second); };
  EXPECT_THROW(write_checkpoint(scratch.path() / "less.h5", checkpoint, sizes, describe_less), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "less.h5")) << "half a state is none";
}

TEST(CheckpointFile, IsHdf5BehindALineOfText)
{
  const ScratchFolder scratch;
  const auto          file = scratch.path() / "checkpoint.h5";
  write_checkpoint(file, some_checkpoint());
  const std::string bytes = read_whole_file(file);
  EXPECT_TRUE(bytes.starts_with("birdstrike checkpoint 4, ")) << bytes.substr(0, 60);
  EXPECT_EQ(bytes.substr(512, 8), "\x89HDF\r\n\x1a\n") << "HDF5's signature where its user block ends";
}

TEST(CheckpointFile, OfAnotherKindIsRefusedInASentence)
{
  const ScratchFolder scratch;
  EXPECT_NE(said_of(scratch.path() / "none.h5").find("Cannot read"), std::string::npos);
  EXPECT_NE(said_of(scratch.path()).find("Cannot read"), std::string::npos) << "a folder";
  EXPECT_NE(said_of(scratch.write("empty.h5", "")).find("is no checkpoint"), std::string::npos);
  EXPECT_NE(said_of(scratch.write("text.h5", std::string(600, 'x'))).find("is no checkpoint"), std::string::npos);
  const auto file = scratch.path() / "checkpoint.h5";
  write_checkpoint(file, some_checkpoint());
  std::string bytes = read_whole_file(file);
  bytes.replace(bytes.find("checkpoint 4"), 12, "checkpoint 9");
  EXPECT_NE(said_of(scratch.write("later.h5", bytes)).find("is of format 9, this program reads 4"), std::string::npos);
}

TEST(CheckpointFile, ThatIsCutOffOrDamagedIsRefusedBeforeHdf5SeesIt)
{
  const ScratchFolder scratch;
  const auto          file = scratch.path() / "checkpoint.h5";
  write_checkpoint(file, some_checkpoint());
  const std::string whole = read_whole_file(file);
  std::mt19937      draw(7);
  for (int k = 0; k < 100; ++k)
    {
      std::string       bytes = whole;
      const std::size_t at    = 512 + draw() % (whole.size() - 512);
      bytes[at]               = static_cast<char>(bytes[at] ^ (1 << draw() % 8)); // a CRC sees every single bit
      EXPECT_NE(said_of(scratch.write("damaged.h5", bytes)).find("is damaged"), std::string::npos) << "byte " << at;
    }
  for (const std::size_t left : {whole.size() - 1, whole.size() / 2, std::size_t(512)})
    EXPECT_NE(said_of(scratch.write("cut.h5", whole.substr(0, left))).find("is cut off"), std::string::npos) << left;
}

TEST(CheckpointFile, ADiskThatIsFullLeavesTheOldFileAndNoOther)
{
  const ScratchFolder scratch;
  const auto          file = scratch.path() / "a";
  write_whole_file(file, {"old ", "text"});
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1000, before.rlim_max}; // as a disk with 1000 bytes left
  const auto   then = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string said;
  try
    {
      write_whole_file(file, {std::string(900, 'x'), std::string(900, 'y')});
    }
  catch (const std::runtime_error &error)
    {
      said = error.what();
    }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, then);
  EXPECT_EQ(said, "Cannot write " + file.string() + ": File too large");
  EXPECT_EQ(read_whole_file(file), "old text");
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST(CheckpointFile, AFolderThatIsNotThereOrNameThatIsTakenIsAnError)
{
  const ScratchFolder scratch;
  EXPECT_THROW(write_whole_file(scratch.path() / "no folder" / "a", {"b"}), std::runtime_error);
  std::filesystem::create_directory(scratch.path() / "taken");
  EXPECT_THROW(write_whole_file(scratch.path() / "taken", {"b"}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "taken.part"));
}
