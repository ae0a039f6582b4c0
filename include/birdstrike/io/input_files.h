#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;

  /// A file that a case reads besides its own: a mesh, or parameters that it includes.
  struct InputFile
  {
    std::string name;
    std::string fingerprint;         ///< of its contents: 16 hexadecimal digits (FNV-1a, Fowler, Noll & Vo 1991)
    bool        is_included = false; ///< parameters, whose entries stand in parameters.prm
    std::string copy        = {};    ///< in the run folder, as "inputs/blade.msh"; empty: there is none

    bool operator==(const InputFile &) const = default;
  };

  /// Of a file's contents; empty where it cannot be read.
  std::string fingerprint_of(const std::filesystem::path &file);

  /// The files that entries name, in the order of declaration, then those that are included. One that cannot be read is
  /// left out: whoever needs it will say so.
  std::vector<InputFile> list_input_files(const CaseParameters &parameters);
} // namespace birdstrike
