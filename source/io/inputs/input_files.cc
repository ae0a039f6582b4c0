#include "io/inputs/file_entries.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/input_files.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
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

  std::string fingerprint_of(const std::filesystem::path &file)
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
      return "";
    std::ifstream in(file, std::ios::binary);
    return in ? fmt::format("{:016x}", fingerprint(in)) : "";
  }

  std::vector<InputFile> list_input_files(const CaseParameters &parameters)
  {
    const ParameterTree   &tree = parameters.file.tree();
    std::vector<InputFile> files;
    const auto             add = [&files](const std::string &name, const bool is_included) {
      if (const std::string fingerprint = fingerprint_of(name); !fingerprint.empty())
        files.push_back({name, fingerprint, is_included});
    };
    for (const KnownEntry &entry : tree.entries())
      if (names_file(entry))
        add(entry.value, false);
    for (const std::string &name : parameters.file.included_files())
      add(name, true);
    return files;
  }
} // namespace birdstrike
