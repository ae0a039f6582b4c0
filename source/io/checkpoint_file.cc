#include <birdstrike/core/errors.h>
#include <birdstrike/io/checkpoint_file.h>
#include <birdstrike/io/hdf5_handle.h>
#include <birdstrike/io/whole_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <zlib.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;
    using Bytes  = std::string;

    constexpr int         version     = 3;
    constexpr std::size_t n_head      = 512; ///< bytes: the smallest user block of HDF5
    constexpr const char *head_format = "birdstrike checkpoint %d, %llu bytes, CRC-32 %08lx\n";

    unsigned long checksum(const char *begin, const std::size_t n)
    {
      return crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef *>(begin), n);
    }

    void require(const bool is_well, const char *what)
    {
      if (!is_well)
        throw std::runtime_error(std::string("HDF5 refuses to ") + what + ": is the memory exhausted?");
    }

    template <class T>
    hid_t native()
    {
      return std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64;
    }
    template <class T>
    hid_t stored()
    {
      return std::is_same_v<T, double> ? H5T_IEEE_F64LE : H5T_STD_U64LE;
    }

    /// HDF5 in memory: a disk that is full is not its business.
    class Writer
    {
    public:
      Writer() : access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), file(create(access), H5Fclose)
      {
        require(file >= 0, "make a file in memory");
      }

      template <class T>
      void write(const std::string &path, const std::vector<T> &values)
      {
        const hsize_t    n = values.size();
        const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose), make(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
        H5Pset_create_intermediate_group(make, 1);
        const Hdf5Handle data(H5Dcreate2(file, path.c_str(), stored<T>(), space, make, H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose);
        require(data >= 0 && (n == 0 || H5Dwrite(data, native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0),
                "take values");
      }

      void write(const std::string &path, const std::string &text)
      {
        write(path, std::vector<std::uint64_t>(text.begin(), text.end()));
      }

      Bytes image()
      {
        require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "end a file in memory");
        const ssize_t n = H5Fget_file_image(file, nullptr, 0);
        Bytes         bytes(n > 0 ? static_cast<std::size_t>(n) : 0, '\0');
        require(n > 0 && H5Fget_file_image(file, bytes.data(), bytes.size()) == n, "hand over a file in memory");
        return bytes;
      }

    private:
      static hid_t create(const hid_t access)
      {
        constexpr std::size_t increment = 1 << 22;
        H5Pset_fapl_core(access, increment, false);
        return H5Fcreate("checkpoint", H5F_ACC_TRUNC, H5P_DEFAULT, access);
      }

      QuietHdf5  quiet;
      Hdf5Handle access, file;
    };

    /// Of a file whose checksum is right: what is missing was written by another version.
    class Reader
    {
    public:
      Reader(const fs::path &name, Bytes &&bytes)
        : name(name)
        , bytes(std::move(bytes))
        , access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose)
        , file(open(access, this->bytes), H5Fclose)
      {
        if (file < 0)
          refuse("/");
      }

      template <class T>
      std::vector<T> read(const std::string &path) const
      {
        const Hdf5Handle data(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
        const Hdf5Handle space(data < 0 ? -1 : H5Dget_space(data), H5Sclose);
        const auto       n = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
        if (n < 0 || static_cast<std::size_t>(n) > bytes.size() / sizeof(T))
          refuse(path);
        std::vector<T> values(static_cast<std::size_t>(n));
        if (n > 0 && H5Dread(data, native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
          refuse(path);
        return values;
      }

      std::string text(const std::string &path) const
      {
        const auto letters = read<std::uint64_t>(path);
        return {letters.begin(), letters.end()};
      }

      bool has(const std::string &path) const
      {
        return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
      }

      /// Names of what is below a group, groups and data sets, "a/b/values".
      std::vector<std::string> names_below(const std::string &group) const
      {
        std::vector<std::string> names;
        const Hdf5Handle         below(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose);
        const auto               keep = [](hid_t, const char *link, const H5L_info_t *, void *to) -> herr_t {
          static_cast<std::vector<std::string> *>(to)->emplace_back(link);
          return 0;
        };
        if (below < 0 || H5Lvisit(below, H5_INDEX_NAME, H5_ITER_INC, keep, &names) < 0)
          refuse(group);
        return names;
      }

      [[noreturn]] void refuse(const std::string &path) const
      {
        throw InputError("The checkpoint " + name.string() + " has no '" + path +
                         "' that this program can read: it was written by another version.");
      }

    private:
      static hid_t open(const hid_t access, Bytes &bytes)
      {
        constexpr std::size_t increment = 1 << 16;
        H5Pset_fapl_core(access, increment, false);
        H5Pset_file_image(access, bytes.data(), bytes.size());
        return H5Fopen("checkpoint", H5F_ACC_RDONLY, access);
      }

      QuietHdf5  quiet;
      fs::path   name;
      Bytes      bytes;
      Hdf5Handle access, file;
    };

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

    constexpr const char *of_values = "/values", *of_lengths = "/lengths", *of_shape = "/shape";
  } // namespace

  void write_checkpoint(const fs::path &file, const Checkpoint &checkpoint)
  {
    std::optional<Writer> in_memory(std::in_place); // ends before the disk is asked
    Writer               &writer = *in_memory;
    writer.write("parameters", checkpoint.parameters);
    writer.write("program", checkpoint.program);
    writer.write("time", std::vector<double>{checkpoint.time});
    writer.write("step", std::vector<std::uint64_t>{checkpoint.step});
    std::string inputs;
    for (const InputFile &input : checkpoint.inputs)
      inputs += input.fingerprint + ' ' + input.name + '\n';
    writer.write("inputs", inputs);
    std::string changes;
    for (const std::string &change : checkpoint.changes)
      changes += change + '\n';
    if (!changes.empty())
      writer.write("changes", changes);
    for (const auto &[name, quantity] : checkpoint.state)
      {
        const std::string path = "state/" + name;
        if (quantity.is_real)
          writer.write(path + of_values, quantity.real);
        else
          writer.write(path + of_values, quantity.whole);
        writer.write(path + of_shape, std::vector<std::uint64_t>{quantity.n_components, quantity.is_real});
        if (!quantity.lengths.empty())
          writer.write(path + of_lengths, quantity.lengths);
      }
    const Bytes body = writer.image();
    in_memory.reset();
    Bytes head(n_head, '\0');
    std::snprintf(head.data(), head.size(), head_format, version, static_cast<unsigned long long>(body.size()),
                  checksum(body.data(), body.size()));
    write_whole_file(file, {head, body});
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
    checkpoint.parameters = reader.text("parameters");
    checkpoint.program    = reader.text("program");
    const auto time       = reader.read<double>("time");
    const auto step       = reader.read<std::uint64_t>("step");
    if (time.size() != 1 || step.size() != 1)
      reader.refuse("time");
    checkpoint.time = time[0];
    checkpoint.step = step[0];
    for (const std::string &line : lines_of(reader.text("inputs")))
      {
        const std::size_t blank = line.find(' ');
        checkpoint.inputs.push_back({line.substr(blank + 1), line.substr(0, blank)});
      }
    if (reader.has("changes"))
      checkpoint.changes = lines_of(reader.text("changes"));
    for (const std::string &link : reader.names_below("state"))
      {
        if (!link.ends_with(of_values))
          continue;
        const std::string name = link.substr(0, link.size() - std::string(of_values).size()), path = "state/" + name;
        const auto        shape = reader.read<std::uint64_t>(path + of_shape);
        if (shape.size() != 2)
          reader.refuse(path);
        ArchivedQuantity &quantity = checkpoint.state[name];
        quantity.n_components      = shape[0];
        quantity.is_real           = shape[1] != 0;
        if (quantity.is_real)
          quantity.real = reader.read<double>(path + of_values);
        else
          quantity.whole = reader.read<std::uint64_t>(path + of_values);
        if (reader.has(path + of_lengths))
          quantity.lengths = reader.read<std::uint64_t>(path + of_lengths);
      }
    return checkpoint;
  }
} // namespace birdstrike
