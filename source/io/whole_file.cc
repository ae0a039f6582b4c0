#include <birdstrike/core/errors.h>
#include <birdstrike/io/whole_file.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <streambuf>
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

    /// Characters on their way to a descriptor.
    class DescriptorBuffer : public std::streambuf
    {
    public:
      explicit DescriptorBuffer(const int descriptor) : descriptor(descriptor)
      {
        setp(buffer.data(), buffer.data() + buffer.size());
      }

      int why() const ///< errno of the first write that failed, 0
      {
        return error;
      }

    protected:
      int_type overflow(const int_type letter) override
      {
        if (sync() != 0)
          return traits_type::eof();
        if (!traits_type::eq_int_type(letter, traits_type::eof()))
          sputc(traits_type::to_char_type(letter));
        return traits_type::not_eof(letter);
      }

      int sync() override
      {
        if (error == 0 && !write_all(descriptor, {pbase(), static_cast<std::size_t>(pptr() - pbase())}))
          error = errno;
        setp(buffer.data(), buffer.data() + buffer.size());
        return error == 0 ? 0 : -1;
      }

      std::streamsize xsputn(const char *text, const std::streamsize n) override
      {
        if (n <= epptr() - pptr())
          {
            std::memcpy(pptr(), text, static_cast<std::size_t>(n));
            pbump(static_cast<int>(n));
            return n;
          }
        if (sync() != 0)
          return 0;
        if (!write_all(descriptor, {text, static_cast<std::size_t>(n)}))
          error = errno;
        return error == 0 ? n : 0;
      }

    private:
      int                       descriptor, error = 0;
      std::array<char, 1 << 16> buffer;
    };

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

  void stream_whole_file(const fs::path &file, const FunctionRef<void(std::ostream &out)> write)
  {
    write_whole_file(file, [&](const int descriptor) {
      DescriptorBuffer buffer(descriptor);
      std::ostream     out(&buffer);
      write(out);
      out.flush();
      return buffer.why();
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
