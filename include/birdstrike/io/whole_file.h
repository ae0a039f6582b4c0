#pragma once

#include <birdstrike/core/function_ref.h>

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace birdstrike
{
  /// Writes a file aside, flushes it to the disk and renames it, one part after the other: under its name a file is
  /// whole, whatever happens to the process or the machine. Throws std::runtime_error with what the system says; then
  /// nothing is left behind, and a file that had the name before still has it.
  void write_whole_file(const std::filesystem::path &file, const std::vector<std::string_view> &parts);

  /// The same of what `write` writes to a descriptor, open for reading and writing: it returns 0, or errno of what
  /// failed.
  void write_whole_file(const std::filesystem::path &file, FunctionRef<int(int descriptor)> write);

  /// The same of what `write` puts into a stream: nothing but a buffer of it is ever in memory.
  void stream_whole_file(const std::filesystem::path &file, FunctionRef<void(std::ostream &out)> write);

  /// All bytes of a file. Throws InputError where it cannot be read.
  std::string read_whole_file(const std::filesystem::path &file);
} // namespace birdstrike
