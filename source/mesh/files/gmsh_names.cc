#include "mesh/files/file_lines.h"
#include "mesh/files/readers.h"

namespace birdstrike
{
  MeshLabels read_gmsh_names(const std::string &path, const unsigned int dim)
  {
    MeshLabels labels;
    FileLines  lines(path);
    while (lines.next() && lines.text() != "$PhysicalNames")
      if (lines.text() == "$Nodes") // names stand before
        return labels;
    lines.next(); // their number
    while (lines.next() && lines.text() != "$EndPhysicalNames")
      {
        const std::string_view text  = trim(lines.text());
        const std::size_t      blank = text.find(' '), quote = text.find('"');
        if (blank == std::string_view::npos || quote == std::string_view::npos || quote + 2 > text.size())
          lines.refuse("cannot read a physical name", "Gmsh writes: dimension, number, \"name\".");
        const auto of  = lines.integer(text.substr(0, blank));
        const auto ids = {static_cast<unsigned int>(lines.integer(text.substr(blank, quote - blank)))};
        if (of == dim || of + 1 == dim)
          (of == dim ? labels.materials : labels.boundaries)
            .add(std::string(text.substr(quote + 1, text.size() - quote - 2)), ids);
      }
    return labels;
  }
} // namespace birdstrike
