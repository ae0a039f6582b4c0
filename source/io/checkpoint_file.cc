#include "io/hdf5/hdf5_in_memory.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/whole_file.h>

#include <fmt/format.h>

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <zlib.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;
    using hdf5_in_memory::Reader;
    using hdf5_in_memory::require;
    using hdf5_in_memory::Writer;
    using Bytes = std::string;

    constexpr int         version     = 4;
    constexpr std::size_t n_head      = 512; ///< bytes: the smallest user block of HDF5
    constexpr const char *head_format = "birdstrike checkpoint %d, %llu bytes, CRC-32 %08lx\n";

    unsigned long checksum(const char *begin, const std::size_t n)
    {
      return crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef *>(begin), n);
    }

    /// The HDF5 part of a file that is whole.
    Bytes read_body(const fs::path &file)
    {
      Bytes              bytes = read_whole_file(file);
      int                found = 0;
      unsigned long long n     = 0;
      unsigned long      crc   = 0;
      if (bytes.size() < n_head || std::sscanf(bytes.c_str(), head_format, &found, &n, &crc) != 3)
        throw InputError(file.string() + " is no checkpoint of this program.");
      if (found != version)
        throw InputError(
          fmt::format("The checkpoint {} is of format {}, this program reads {}.\nResume the run with the "
                      "program that began it.",
                      file.string(), found, version));
      if (bytes.size() - n_head != n)
        throw InputError(
          fmt::format("The checkpoint {} is cut off: it has {} of {} bytes.", file.string(), bytes.size() - n_head, n));
      bytes.erase(0, n_head);
      if (checksum(bytes.data(), bytes.size()) != crc)
        throw InputError("The checkpoint " + file.string() + " is damaged: its checksum is another one.");
      return bytes;
    }

    std::vector<std::string> lines_of(const std::string &text)
    {
      std::vector<std::string> lines;
      std::istringstream       in(text);
      for (std::string line; std::getline(in, line);)
        lines.push_back(line);
      return lines;
    }

    using Wholes                         = std::vector<std::uint64_t>;
    constexpr const char *names_of_state = "state/names", *shapes_of_state = "state/shapes", *real_state = "state/real",
                         *whole_state = "state/whole", *lengths_of_state = "state/lengths";
    constexpr std::size_t n_of_shape = 4; // components, whether real, values, lengths

    /// Data sets of a state, to which values come piece by piece: where those of each quantity go on is known from the
    /// sizes of all. A run has hundreds of quantities, most of them of a few numbers: a data set of its own each took
    /// most of the time of a checkpoint.
    class StateWriter : public StateSink
    {
    public:
      StateWriter(Writer &writer, const StateInventory &sizes)
        : real(writer.column<double>(real_state, add_up(sizes, true)))
        , whole(writer.column<std::uint64_t>(whole_state, add_up(sizes, false)))
        , lengths(writer.column<std::uint64_t>(lengths_of_state, count_lengths(sizes)))
      {
        require(real.is_open() && whole.is_open() && lengths.is_open(), "make data sets");
        std::size_t n_real = 0, n_whole = 0, n_lengths = 0;
        for (const auto &[name, shape] : sizes.shapes())
          {
            std::size_t &n = shape.is_real ? n_real : n_whole;
            places[name]   = {n, n_lengths, n + shape.n_values};
            n += shape.n_values;
            n_lengths += shape.n_lengths;
          }
      }

      void take(const std::string &name, const ArchivedQuantity &piece) override
      {
        Place &place = places.at(name);
        if (place.value + piece.size() > place.end)
          throw std::logic_error("Checkpoint: '" + name + "' has more values than it had when they were counted.");
        require((piece.is_real ? real.write(place.value, piece.real) : whole.write(place.value, piece.whole)) &&
                  lengths.write(place.length, piece.lengths),
                "take values");
      }

      void require_all() const
      {
        for (const auto &[name, place] : places)
          if (place.value != place.end)
            throw std::logic_error("Checkpoint: '" + name + "' has fewer values than it had when they were counted.");
      }

    private:
      struct Place
      {
        std::size_t value, length, end;
      };

      static std::size_t add_up(const StateInventory &sizes, const bool is_real)
      {
        std::size_t n = 0;
        for (const auto &[name, shape] : sizes.shapes())
          n += shape.is_real == is_real ? shape.n_values : 0;
        return n;
      }
      static std::size_t count_lengths(const StateInventory &sizes)
      {
        std::size_t n = 0;
        for (const auto &[name, shape] : sizes.shapes())
          n += shape.n_lengths;
        return n;
      }

      hdf5_in_memory::Column<double>        real;
      hdf5_in_memory::Column<std::uint64_t> whole, lengths;
      std::map<std::string, Place>          places;
    };

    void write_state(Writer &writer, const StateInventory &sizes, const FunctionRef<void(StateSink &)> describe)
    {
      Bytes  names;
      Wholes shapes;
      for (const auto &[name, shape] : sizes.shapes())
        {
          names += name + '\0';
          shapes.insert(shapes.end(), {shape.n_components, shape.is_real, shape.n_values, shape.n_lengths});
        }
      writer.write(names_of_state, names);
      writer.write(shapes_of_state, shapes);
      StateWriter state(writer, sizes);
      describe(state);
      state.require_all();
    }

    ArchivedState read_state(const Reader &reader)
    {
      const auto names   = reader.read<Bytes>(names_of_state);
      const auto shapes  = reader.read<Wholes>(shapes_of_state);
      auto       real    = reader.column<double>(real_state);
      auto       whole   = reader.column<std::uint64_t>(whole_state);
      auto       lengths = reader.column<std::uint64_t>(lengths_of_state);
      const auto take    = [](auto &from, auto &values, const std::uint64_t n) {
        if (n > from.left())
          return false;
        values.resize(n);
        return from.read(values.data(), n);
      };
      ArchivedState state;
      std::size_t   s = 0;
      for (std::size_t begin = 0; begin < names.size(); begin = names.find('\0', begin) + 1, s += n_of_shape)
        {
          const std::string name = names.c_str() + begin;
          if (s + n_of_shape > shapes.size())
            reader.refuse(name);
          ArchivedQuantity &quantity = state[name];
          quantity.n_components      = shapes[s];
          quantity.is_real           = shapes[s + 1] != 0;
          if (!(quantity.is_real ? take(real, quantity.real, shapes[s + 2])
                                 : take(whole, quantity.whole, shapes[s + 2])) ||
              !take(lengths, quantity.lengths, shapes[s + 3]))
            reader.refuse(name);
        }
      if (s != shapes.size() || real.left() + whole.left() + lengths.left() > 0)
        reader.refuse("state");
      return state;
    }

    /// The HDF5 part, into the target.
    void write_body(hdf5_on_disk::Target &target, const Checkpoint &checkpoint, const StateInventory &sizes,
                    const FunctionRef<void(StateSink &)> describe)
    {
      Writer writer(target);
      writer.write("parameters", checkpoint.parameters);
      writer.write("program", checkpoint.program);
      writer.write("time", std::vector<double>{checkpoint.time});
      writer.write("step", Wholes{checkpoint.step});
      std::string inputs;
      for (const InputFile &input : checkpoint.inputs)
        inputs += input.fingerprint + ' ' + input.name + '\n';
      writer.write("inputs", inputs);
      std::string changes;
      for (const std::string &change : checkpoint.changes)
        changes += change + '\n';
      if (!changes.empty())
        writer.write("changes", changes);
      write_state(writer, sizes, describe);
      writer.finish();
    }

    /// The line of text before the HDF5 part that stands behind it; returns errno of what failed.
    int write_head(const int descriptor)
    {
      std::vector<char>  piece(1 << 20);
      unsigned long      crc = crc32_z(0, nullptr, 0);
      unsigned long long n   = 0;
      ssize_t            got = 0;
      while ((got = ::pread(descriptor, piece.data(), piece.size(), static_cast<off_t>(n_head + n))) > 0)
        {
          crc = crc32_z(crc, reinterpret_cast<const Bytef *>(piece.data()), static_cast<std::size_t>(got));
          n += static_cast<unsigned long long>(got);
        }
      Bytes head(n_head, '\0');
      std::snprintf(head.data(), head.size(), head_format, version, n, crc);
      if (got < 0)
        return errno;
      const ssize_t written = ::pwrite(descriptor, head.data(), n_head, 0);
      return written == static_cast<ssize_t>(n_head) ? 0 : written < 0 ? errno : EIO;
    }
  } // namespace

  void write_checkpoint(const fs::path &file, const Checkpoint &checkpoint, const StateInventory &sizes,
                        const FunctionRef<void(StateSink &)> describe)
  {
    write_whole_file(file, [&](const int descriptor) {
      hdf5_on_disk::Target target{descriptor, n_head};
      write_body(target, checkpoint, sizes, describe);
      return target.error != 0 ? target.error : write_head(descriptor);
    });
  }

  void write_checkpoint(const fs::path &file, const Checkpoint &checkpoint)
  {
    const auto describe = [&](StateSink &to) {
      for (const auto &[name, quantity] : checkpoint.state)
        to.take(name, quantity);
    };
    StateInventory sizes;
    describe(sizes);
    write_checkpoint(file, checkpoint, sizes, describe);
  }

  std::vector<fs::path> find_checkpoints(const fs::path &run_folder)
  {
    std::vector<fs::path> files;
    const fs::path        folder = run_folder / checkpoint_folder;
    if (fs::is_directory(folder))
      for (const auto &entry : fs::directory_iterator(folder))
        if (const std::string name = entry.path().filename().string();
            name.starts_with(checkpoint_stem) && name.ends_with(".h5"))
          files.push_back(entry.path());
    std::ranges::sort(files, std::greater<>());
    return files;
  }

  Checkpoint read_checkpoint(const fs::path &file)
  {
    const Reader reader(file, read_body(file));
    Checkpoint   checkpoint;
    checkpoint.parameters = reader.read<Bytes>("parameters");
    checkpoint.program    = reader.read<Bytes>("program");
    const auto time       = reader.read<std::vector<double>>("time");
    const auto step       = reader.read<Wholes>("step");
    if (time.size() != 1 || step.size() != 1)
      reader.refuse("time");
    checkpoint.time = time[0];
    checkpoint.step = step[0];
    for (const std::string &line : lines_of(reader.read<Bytes>("inputs")))
      {
        const std::size_t blank = line.find(' ');
        checkpoint.inputs.push_back({line.substr(blank + 1), line.substr(0, blank)});
      }
    if (reader.has("changes"))
      checkpoint.changes = lines_of(reader.read<Bytes>("changes"));
    checkpoint.state = read_state(reader);
    return checkpoint;
  }
} // namespace birdstrike
