#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace birdstrike::fuzz
{
  /// A folder for what the readers open by name, in TMPDIR, gone with the process. Always of the same name, which is
  /// part of what is read and said: processes beside each other need a TMPDIR each.
  class Folder
  {
  public:
    Folder() : path(std::filesystem::temp_directory_path() / "birdstrike-fuzz")
    {
      std::filesystem::create_directory(path);
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

    const std::filesystem::path path;
  };

  inline std::string_view text_of(const std::uint8_t *data, const std::size_t size)
  {
    return {reinterpret_cast<const char *>(data), size};
  }
} // namespace birdstrike::fuzz
