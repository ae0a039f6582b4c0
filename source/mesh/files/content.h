#pragma once

#include <string>

namespace birdstrike
{
  /// Reads the first lines of a mesh file and throws InputError where they are of another known format than its ending
  /// says (all.msh of CalculiX holds Abaqus' keywords), or, where this ending is read, of one that is not offered, with
  /// what to do: another ending, or the way of saving it. Text of no known format passes.
  ///
  /// `ending`: in small letters with its point.
  void check_content(const std::string &file, const std::string &ending);

  /// Whether a file's first line with something in it begins with '*': .inp is Abaqus' then, else UCD.
  bool begins_with_keyword(const std::string &file);
} // namespace birdstrike
