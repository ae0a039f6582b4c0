#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdlib.h>
#include <string>

/// A new folder for one test, removed with it.
class ScratchFolder
{
public:
  ScratchFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "birdstrike_io_XXXXXX").string();
    folder           = ::mkdtemp(name.data());
  }
  ~ScratchFolder()
  {
    std::filesystem::remove_all(folder);
  }
  ScratchFolder(const ScratchFolder &)            = delete;
  ScratchFolder &operator=(const ScratchFolder &) = delete;

  const std::filesystem::path &path() const
  {
    return folder;
  }

  std::string write(const std::string &name, const std::string &text) const
  {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }

private:
  std::filesystem::path folder;
};

inline std::string read_text(const std::filesystem::path &path)
{
  std::ifstream      in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}
