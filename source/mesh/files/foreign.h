#pragma once

#include <string>

namespace birdstrike
{
  /// How to make a file that is read of one with another ending (".unv"): a command, or what to export. Empty: the
  /// ending is not known. The commands are those of Gmsh 4.8 and meshio 5.0 of Debian 12.
  std::string how_to_convert(const std::string &file, const std::string &ending);
} // namespace birdstrike
