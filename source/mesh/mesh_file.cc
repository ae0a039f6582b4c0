#include "mesh/mesh_file.h"
#include <birdstrike/core/quiet_errors.h>

#include <birdstrike/core/errors.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>

namespace birdstrike
{
  namespace
  {
    template <int dim>
    const std::string cells_of = dim == 2 ? "quadrilaterals" : "hexahedra";

    std::ifstream open(const std::string &file)
    {
      std::ifstream in(file);
      if (!in)
        throw InputError("Blade/Mesh/File: cannot open '" + file + "'.\nPaths are relative to the working directory.");
      return in;
    }

    /// Two formats end on .inp; only Abaqus' begins with a keyword or comment line.
    bool is_abaqus(const std::string &file)
    {
      std::ifstream in    = open(file);
      char          first = 0;
      in >> first;
      return first == '*';
    }

    /// Whether some element is a brick (C3D8, C3D8R, ...); deal.II's reader takes the nodes of any type as they come.
    bool has_abaqus_bricks(const std::string &file)
    {
      std::ifstream in = open(file);
      for (std::string line; std::getline(in, line);)
        {
          line.erase(std::remove_if(line.begin(), line.end(), [](const unsigned char c) { return std::isspace(c); }),
                     line.end());
          std::transform(line.begin(), line.end(), line.begin(), [](const unsigned char c) { return std::toupper(c); });
          if (line.find("TYPE=C3D8") != std::string::npos)
            return true;
        }
      return false;
    }

    template <int dim>
    typename dealii::GridIn<dim, 3>::Format format_of(const std::string &file)
    {
      using Reader             = dealii::GridIn<dim, 3>;
      const std::string suffix = file.substr(std::min(file.rfind('.'), file.size()));
      if (suffix == ".msh")
        return Reader::msh;
      if (suffix == ".inp")
        return is_abaqus(file) ? Reader::abaqus : Reader::ucd;
      if (suffix == ".vtk")
        return Reader::vtk;
      throw InputError("Blade/Mesh/File: '" + file +
                       "' has an unknown ending.\nAllowed: .msh (Gmsh 2 and 4), .inp (UCD or Abaqus), .vtk.");
    }

    template <int dim>
    void read(const std::string &file, dealii::Triangulation<dim, 3> &triangulation)
    {
      const auto             format = format_of<dim>(file);
      std::ifstream          in     = open(file);
      const QuietErrors      quiet;
      dealii::GridIn<dim, 3> reader;
      reader.attach_triangulation(triangulation);
      if (format == dealii::GridIn<dim, 3>::abaqus && has_abaqus_bricks(file) != (dim == 3))
        throw std::invalid_argument("elements of another dimension");
      try
        {
          reader.read(in, format);
        }
      catch (const typename dealii::Triangulation<dim, 3>::DistortedCellList &)
        {
          // The cells exist; check_shape finds the first bad one and names it.
        }
    }

    /// Number of cells if the file can be read in this dimension, else 0.
    template <int dim>
    unsigned int count_cells(const std::string &file)
    {
      dealii::Triangulation<dim, 3> triangulation;
      try
        {
          read(file, triangulation);
        }
      catch (const std::exception &)
        {
          return 0;
        }
      return triangulation.n_active_cells();
    }

    template <int dim>
    [[noreturn]] void refuse(const std::string &file)
    {
      if (const unsigned int n_others = count_cells<5 - dim>(file); n_others > 0)
        throw InputError("Blade/Mesh/File: '" + file + "' holds " + std::to_string(n_others) + " " + cells_of<5 - dim> +
                         ", but " + cells_of<dim> +
                         (dim == 2 ? " of the mid-surface are needed.\nSet Blade/Kind = solid, or give a surface mesh."
                                   : " are needed for Blade/Kind = solid.\nSet Blade/Kind = shell, or give a volume "
                                     "mesh."));
      throw InputError("Blade/Mesh/File: '" + file + "' is not a mesh of " + cells_of<dim> +
                       " that can be read.\nAllowed: " + cells_of<dim> + " with labelled boundary " +
                       (dim == 2 ? "lines" : "quadrilaterals") +
                       ", every other cell kind removed; Gmsh format 2 or 4, text; Abaqus with sets EB1, EB2, ... and "
                       "surfaces SS1, SS2, ...\nSave again with " +
                       (dim == 2 ? "'Recombine' on and only physical surfaces and lines."
                                 : "only physical volumes and surfaces (transfinite or swept, recombined)."));
    }
  } // namespace

  template <int dim>
  void read_mesh_file(const MeshParameters &parameters, dealii::Triangulation<dim, 3> &triangulation)
  {
    const std::string &file = parameters.file;
    open(file);
    try
      {
        read(file, triangulation);
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::exception &)
      {
        refuse<dim>(file);
      }
    if (parameters.file_scale != 1.)
      dealii::GridTools::scale(parameters.file_scale, triangulation);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (!cell->reference_cell().is_hyper_cube())
        throw InputError("Blade/Mesh/File: '" + file + "' contains cells that are not " + cells_of<dim> + " (cell " +
                         std::to_string(cell->active_cell_index()) + ").\n" +
                         (dim == 2 ? "Recombine the triangles (Gmsh: Mesh.RecombineAll = 1)."
                                   : "Mesh the body by sweeping or transfinite volumes; tetrahedra and wedges are "
                                     "not offered."));
  }

  template void read_mesh_file(const MeshParameters &, dealii::Triangulation<2, 3> &);
  template void read_mesh_file(const MeshParameters &, dealii::Triangulation<3, 3> &);
} // namespace birdstrike
