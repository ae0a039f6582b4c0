#pragma once

#include "io/parameter_tree.h"

#include <filesystem>
#include <string>

/// Entries whose values are names of files that a run reads, such as a mesh.
namespace birdstrike
{
  /// By the pattern of its declaration, dealii::Patterns::FileName.
  bool names_file(const KnownEntry &entry);

  /// Where a file is that somebody has named.
  struct FoundFile
  {
    std::string path;    ///< as the program opens it; as it was named where there is none
    std::string warning; ///< a sentence without the entry's name; empty: there is nothing to say
  };

  /// Of a line of a parameter file in this folder: beside it, else seen from the working directory. Warns of a file
  /// that is found there only, and of one that is there, too, with other contents.
  FoundFile find_beside(const std::string &name, const std::filesystem::path &folder);

  /// Of an override of the command line: seen from the working directory, else beside the parameter file.
  FoundFile find_from_here(const std::string &name, const std::filesystem::path &folder);

  /// Whether both are files of the same contents.
  bool have_same_contents(const std::filesystem::path &a, const std::filesystem::path &b);
} // namespace birdstrike
