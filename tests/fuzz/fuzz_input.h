#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace birdstrike::fuzz
{
  /// A folder for what the readers open by name, in memory where TMPDIR is, gone with the process.
  class Folder
  {
  public:
    Folder()
    {
      std::string name = (std::filesystem::temp_directory_path() / "birdstrike-fuzz-XXXXXX").string();
      path             = ::mkdtemp(name.data());
    }
    ~Folder()
    {
      std::filesystem::remove_all(path);
    }
    Folder(const Folder &)            = delete;
    Folder &operator=(const Folder &) = delete;

    std::string write(const std::string &name, const std::string_view text) const
    {
      const std::string file = path / name;
      std::ofstream(file, std::ios::binary) << text;
      return file;
    }

    std::filesystem::path path;
  };

  inline std::string_view text_of(const std::uint8_t *data, const std::size_t size)
  {
    return {reinterpret_cast<const char *>(data), size};
  }
} // namespace birdstrike::fuzz
