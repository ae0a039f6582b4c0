#include "io/parameter_tree.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/input_files.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace birdstrike
{
  namespace
  {
    std::uint64_t fingerprint(std::istream &in)
    {
      std::uint64_t           hash = 14695981039346656037u;
      std::array<char, 65536> buffer;
      while (in.read(buffer.data(), buffer.size()), in.gcount() > 0)
        for (std::streamsize k = 0; k < in.gcount(); ++k)
          hash = (hash ^ static_cast<unsigned char>(buffer[static_cast<std::size_t>(k)])) * 1099511628211u;
      return hash;
    }
  } // namespace

  std::vector<InputFile> list_input_files(const CaseParameters &parameters)
  {
    const ParameterTree    tree = parameters.file.tree();
    std::vector<InputFile> files;
    for (const KnownEntry &entry : tree.entries())
      {
        std::error_code error;
        if (entry.value.empty() || !std::filesystem::is_regular_file(entry.value, error))
          continue;
        if (std::ifstream in(entry.value, std::ios::binary); in)
          files.push_back({entry.value, fmt::format("{:016x}", fingerprint(in))});
      }
    return files;
  }
} // namespace birdstrike
