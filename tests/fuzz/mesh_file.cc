#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/nodal_thickness.h>

#include "fuzz_input.h"

#include <algorithm>

namespace
{
  using namespace birdstrike;

  const fuzz::Folder &folder()
  {
    static const fuzz::Folder only_one;
    return only_one;
  }

  /// A mesh until a blade can stand on it: cells, sides, names, masses.
  template <int dim>
  void read_mesh(const std::string &file, const std::string &parts)
  {
    GeometryParameters parameters;
    parameters.mesh.generator = MeshGenerator::file;
    parameters.mesh.file      = file;
    parameters.mesh.parts     = parts;
    const BladeMesh<dim> mesh(parameters);
    mesh.compute_mass(DensityLaw(4430.), make_thickness_law(parameters));
  }

  /// A table of thicknesses for the built-in plate.
  void read_thickness_table(const std::string &file)
  {
    static const GeometryParameters plate;
    static const ShellMesh          mesh(plate);
    GeometryParameters              parameters;
    parameters.thickness.table = file;
    find_nodal_thickness(parameters, mesh, {0}, {1});
  }
} // namespace

/// The first two letters say what follows them: the format by its ending (m, i, k, v; t is a table of thicknesses) and
/// the dimension (2, 3) of the cells that are wanted; a '=' behind them begins a line with the parts that are wanted.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  if (size < 2)
    return -1;
  const char *const      endings[] = {"msh", "inp", "key", "vtk", "txt"};
  const std::string_view letters   = "mikvt";
  const std::size_t      format    = letters.find(static_cast<char>(data[0]));
  if (format == letters.npos)
    return -1;
  const bool        has_parts = size > 2 && data[2] == '=';
  const auto *const end       = data + size;
  const auto *const line      = has_parts ? std::find(data + 3, end, '\n') : data + 2;
  const std::string parts(has_parts ? fuzz::text_of(data + 3, static_cast<std::size_t>(line - data) - 3)
                                    : std::string_view());
  const auto *const text = has_parts && line != end ? line + 1 : line;
  const std::string file =
    folder().write(std::string("input.") + endings[format], fuzz::text_of(text, static_cast<std::size_t>(end - text)));
  try
    {
      if (format == 4)
        read_thickness_table(file);
      else if (data[1] == '3')
        read_mesh<3>(file, parts);
      else
        read_mesh<2>(file, parts);
    }
  catch (const InputError &)
    {
    }
  return 0;
}
