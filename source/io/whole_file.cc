#include <birdstrike/core/errors.h>
#include <birdstrike/io/whole_file.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What one call writes of a part may be less than the part; an interrupted call is made again.
    bool write_all(const int descriptor, std::string_view part)
    {
      while (!part.empty())
        {
          const ssize_t n = ::write(descriptor, part.data(), part.size());
          if (n < 0 && errno == EINTR)
            continue;
          if (n < 0)
            return false;
          part.remove_prefix(static_cast<std::size_t>(n));
        }
      return true;
    }

    /// The name is an entry of the folder, which has to reach the disk too.
    void flush_folder(const fs::path &folder)
    {
      const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor < 0)
        return;
      ::fsync(descriptor); // some network file systems refuse: the file itself is on the disk
      ::close(descriptor);
    }
  } // namespace

  void write_whole_file(const fs::path &file, const FunctionRef<int(int descriptor)> write)
  {
    const fs::path aside      = file.string() + ".part";
    const int      descriptor = ::open(aside.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    int            why        = descriptor < 0 ? errno : 0;
    try
      {
        if (why == 0)
          why = write(descriptor);
      }
    catch (...)
      {
        ::close(descriptor);
        ::unlink(aside.c_str());
        throw;
      }
    const auto go_on = [&why](const int result) { why = why == 0 && result != 0 ? errno : why; };
    if (why == 0)
      go_on(::fsync(descriptor));
    if (descriptor >= 0)
      go_on(::close(descriptor));
    if (why == 0)
      go_on(::rename(aside.c_str(), file.c_str()));
    if (why != 0)
      {
        ::unlink(aside.c_str());
        throw std::runtime_error("Cannot write " + file.string() + ": " + std::strerror(why));
      }
    flush_folder(file.parent_path());
  }

  void write_whole_file(const fs::path &file, const std::vector<std::string_view> &parts)
  {
    write_whole_file(file, [&](const int descriptor) {
      for (const std::string_view part : parts)
        if (!write_all(descriptor, part))
          return errno;
      return 0;
    });
  }

  std::string read_whole_file(const fs::path &file)
  {
    std::error_code error;
    if (const auto status = fs::status(file, error); !fs::is_regular_file(status))
      throw InputError("Cannot read " + file.string() + ": " + (error ? error.message() : "it is no file") + ".");
    std::ifstream in(file, std::ios::binary);
    const auto    n = fs::file_size(file, error);
    std::string   bytes(error ? 0 : n, '\0');
    if (!in || error || !in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw InputError("Cannot read " + file.string() + ": " + std::strerror(errno) + ".");
    return bytes;
  }
} // namespace birdstrike
