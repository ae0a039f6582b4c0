#include "mesh/files/foreign.h"

#include <algorithm>
#include <iterator>

namespace birdstrike
{
  namespace
  {
    struct Foreign
    {
      const char *endings;
      const char *advice; ///< '@' is the file, '#' the file without its ending
    };

    const char *const export_remedy =
      "Export the mesh from its preprocessor as Abaqus (.inp) or LS-DYNA (.k), with sets.";

    const Foreign converters[] = {
      {".unv .mesh", "Convert it: gmsh '@' -save -format msh2 -o '#.msh'"},
      {".bdf .nas", "Convert it: gmsh '@' -save -format msh2 -o '#.msh'\nIt keeps property ids and no names."},
      {".exo .e .ex2",
       "Convert it: meshio convert '@' '#.inp' && sed -i s/CAX4P/S4R/ '#.inp'\nIt keeps node sets by their names."},
      {".med .vtu .xdmf", "Convert it: meshio convert --ascii --output-format vtk42 '@' '#.vtk'\nNames of groups are "
                          "lost: Salome's export "
                          "as .unv keeps them."},
      {".geo", "Mesh it: gmsh '@' -2 -format msh2 -o '#.msh'"},
      {".step .stp .igs .iges .brep",
       "It is a shape without mesh. Mesh it: gmsh '@' -2 -string 'Mesh.RecombineAll=1; Mesh.SubdivisionAlgorithm=1;' "
       "-format msh2 -o '#.msh'\nA shell wants the mid-surface alone, and groups for its sides."},
      {".stl .obj .ply .off", "It holds triangles alone. Mesh the shape (.step) with quadrilaterals or hexahedra."},
      {".cdb .dat", "Ansys: save the mesh of an LS-DYNA analysis as keyword file (.k), or Abaqus (.inp) from a "
                    "preprocessor."},
      {".rad .d3plot .odb .cae .cas .hm .fem .frd .cgns .su2 .neu .mphtxt", export_remedy},
      {".x_t .sat .prt .sldprt .catpart",
       "It is a shape without mesh. Export it as .step, and mesh it with quadrilaterals or hexahedra."}};

    bool has_word(const std::string &words, const std::string &word)
    {
      return (' ' + words + ' ').find(' ' + word + ' ') != std::string::npos;
    }
  } // namespace

  std::string how_to_convert(const std::string &file, const std::string &ending)
  {
    const auto found = std::find_if(std::begin(converters), std::end(converters),
                                    [&ending](const Foreign &foreign) { return has_word(foreign.endings, ending); });
    if (found == std::end(converters) || ending.empty())
      return "";
    std::string text;
    for (const char *letter = found->advice; *letter != '\0'; ++letter)
      text += *letter == '@'   ? file
              : *letter == '#' ? file.substr(0, file.size() - ending.size())
                               : std::string(1, *letter);
    return text;
  }
} // namespace birdstrike
