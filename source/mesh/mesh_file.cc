#include "mesh/mesh_file.h"

#include "mesh/files/content.h"
#include "mesh/files/file_lines.h"
#include "mesh/files/foreign.h"
#include "mesh/files/parts.h"
#include "mesh/files/readers.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/core/quiet_errors.h>

#include <deal.II/grid/grid_tools.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>

namespace birdstrike
{
  namespace
  {
    template <int dim>
    const std::string cells_of = dim == 2 ? "quadrilaterals" : "hexahedra";

    std::string ending_of(const std::string &file)
    {
      std::string ending = file.substr(std::min(file.rfind('.'), file.size()));
      std::transform(ending.begin(), ending.end(), ending.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return ending;
    }

    ImportedMesh import(const std::string &file)
    {
      const std::string ending = ending_of(file);
      check_content(file, ending);
      if (ending == ".k" || ending == ".key" || ending == ".dyn")
        return read_ls_dyna(file);
      if (ending == ".vtk")
        return read_vtk(file);
      if (ending == ".inp")
        return begins_with_keyword(file) ? read_abaqus(file) : read_ucd(file); // two formats have this ending
      if (ending == ".msh")
        return read_gmsh(file);
      if (const std::string advice = how_to_convert(file, ending); !advice.empty())
        throw InputError("Blade/Mesh/File: '" + file + "': files " + ending + " are not read.\n" + advice);
      throw InputError("Blade/Mesh/File: '" + file +
                       "' has an unknown ending.\nAllowed: .msh (Gmsh 2 and 4), .inp (Abaqus or UCD), .k .key .dyn "
                       "(LS-DYNA), .vtk.");
    }

    template <int dim>
    [[noreturn]] void refuse(const std::string &file, const std::size_t n_others)
    {
      if (n_others > 0)
        throw InputError("Blade/Mesh/File: '" + file + "' holds " + std::to_string(n_others) + " " + cells_of<5 - dim> +
                         ", but " + cells_of<dim> +
                         (dim == 2 ? " of the mid-surface are needed.\nSet Blade/Kind = solid, give a surface mesh, or "
                                     "name the parts that are the blade in Blade/Mesh/Parts."
                                   : " are needed for Blade/Kind = solid.\nSet Blade/Kind = shell, or give a volume "
                                     "mesh."));
      throw InputError(
        "Blade/Mesh/File: '" + file + "' is not a mesh of " + cells_of<dim> + " that can be read.\nAllowed: " +
        cells_of<dim> + " with labelled boundary " + (dim == 2 ? "lines" : "quadrilaterals") +
        ", every other cell kind removed; Gmsh format 2 or 4, text; Abaqus; LS-DYNA; VTK legacy.\n"
        "Save again with " +
        (dim == 2
           ? "'Recombine' on and only physical surfaces and lines. Once a curve is physical, Gmsh saves a surface only "
             "if it is physical too: Physical Surface(\"blade\") = {1};"
           : "only physical volumes and surfaces (transfinite or swept, recombined)."));
    }

    void require_memory(const std::string &file, const double needed, const std::string &what)
    {
      constexpr double gibi = 1024. * 1024. * 1024.;
      if (const auto available = static_cast<double>(available_memory()); needed > available)
        throw InputError(
          fmt::format("Blade/Mesh/File: '{}' needs about {:.3g} GiB of memory for its {}; {:.3g} GiB are "
                      "there.\nGive a coarser mesh.",
                      file, needed / gibi, what, available / gibi));
    }

    void require_file(const std::string &file)
    {
      std::error_code error;
      if (!std::filesystem::is_regular_file(file, error) || !std::ifstream(file)) // what is no file may never end
        throw InputError("Blade/Mesh/File: cannot open '" + file +
                         "'.\nA path is searched beside the parameter file, then from the working directory.");
    }

    /// What a reader keeps of a byte: a node takes 32 bytes, an element with its place in a group 112, of lines of some
    /// 30 letters.
    constexpr double bytes_per_byte = 5.; // its text among it

    /// Bricks make a body, whatever else there is; quadrilaterals are a surface only where there are none.
    template <int dim>
    MeshLabels take(ImportedMesh mesh, const MeshParameters &parameters, dealii::Triangulation<dim, 3> &triangulation)
    {
      const std::string &file = parameters.file;
      keep_parts(mesh, dim, parameters.parts, file);
      if (mesh.elements[dim].empty() || (dim == 2 && !mesh.elements[3].empty()))
        refuse<dim>(file, mesh.elements[5 - dim].size());
      require_memory(file,
                     prices::building_element * static_cast<double>(mesh.elements[dim].size()) +
                       prices::building_node * static_cast<double>(mesh.nodes.size()),
                     std::to_string(mesh.elements[dim].size()) + " elements");
      const QuietErrors quiet;
      MeshLabels        labels = make_triangulation(mesh, file, triangulation);
      labels.notes             = std::move(mesh.notes);
      return labels;
    }
  } // namespace

  template <int dim>
  MeshLabels read_mesh_file(const MeshParameters &parameters, dealii::Triangulation<dim, 3> &triangulation)
  {
    const std::string &file = parameters.file;
    require_file(file);
    const auto n_bytes = std::filesystem::file_size(file);
    if (n_bytes == 0)
      throw InputError("Blade/Mesh/File: '" + file + "' is empty (0 bytes).\nSave the mesh again.");
    require_memory(file, bytes_per_byte * static_cast<double>(n_bytes), std::to_string(n_bytes) + " bytes");
    MeshLabels labels = take(import(file), parameters, triangulation);
    if (parameters.file_scale != 1.)
      dealii::GridTools::scale(parameters.file_scale, triangulation);
    for (auto &corners : labels.corner_thickness)
      for (double &thickness : corners)
        thickness *= parameters.file_scale;
    return labels;
  }

  template MeshLabels read_mesh_file(const MeshParameters &, dealii::Triangulation<2, 3> &);
  template MeshLabels read_mesh_file(const MeshParameters &, dealii::Triangulation<3, 3> &);
} // namespace birdstrike
