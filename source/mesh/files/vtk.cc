#include "mesh/files/file_lines.h"
#include "mesh/files/numbered_groups.h"
#include "mesh/files/readers.h"

#include <birdstrike/core/errors.h>

#include <cmath>
#include <map>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    class VtkFile
    {
    public:
      explicit VtkFile(const std::string &path) : path(path), in(path)
      {
      }

      ImportedMesh read()
      {
        std::string line;
        for (unsigned int k = 0; k < 3; ++k)
          std::getline(in, line);
        if (trim(line) != "ASCII")
          refuse("is not written as text", "Save it as VTK legacy, ASCII.");
        bool is_of_cells = false; // what points have is passed over
        for (std::string word; in >> word;)
          if (word == "CELL_DATA" || word == "POINT_DATA")
            is_of_cells = word == "CELL_DATA";
          else if (word == "DATASET" && take<std::string>() != "UNSTRUCTURED_GRID")
            refuse("holds no unstructured grid", "Save it as a legacy unstructured grid.");
          else if (word == "POINTS")
            read_points();
          else if (word == "CELLS")
            read_cells();
          else if (word == "CELL_TYPES")
            types = take_many(take<std::size_t>());
          else if (word == "SCALARS" && is_of_cells)
            read_scalars();
          else if (word == "FIELD" && is_of_cells)
            read_fields();
        if (types.size() != cells.size())
          refuse("has " + std::to_string(cells.size()) + " cells and " + std::to_string(types.size()) + " cell types",
                 "Save it again.");
        add_elements();
        return std::move(mesh);
      }

    private:
      std::string                            path;
      std::ifstream                          in;
      ImportedMesh                           mesh;
      std::vector<std::vector<Id>>           cells;
      std::vector<Id>                        types;
      std::map<std::string, std::vector<Id>> data; ///< of cells

      [[noreturn]] void refuse(const std::string &what, const std::string &remedy) const
      {
        throw InputError("Blade/Mesh/File: '" + path + "' " + what + ".\n" + remedy);
      }

      template <class Value>
      Value take()
      {
        Value value;
        if (!(in >> value))
          refuse("ends too early, or has a word where a number must stand", "Save it again as VTK legacy, ASCII.");
        return value;
      }

      std::vector<Id> take_many(const std::size_t n) ///< whole numbers, however they are written
      {
        std::vector<Id> values;
        for (std::size_t k = 0; k < n; ++k)
          {
            const auto value = take<double>();
            if (std::abs(value) > 1e15 || value != std::floor(value))
              refuse("has " + std::to_string(value) + " where a whole number must stand", "Save it again.");
            values.push_back(static_cast<Id>(value));
          }
        return values;
      }

      void read_points()
      {
        const auto n = take<std::size_t>();
        take<std::string>(); // their type
        for (std::size_t k = 0; k < n; ++k)
          {
            Point3 x;
            for (unsigned int d = 0; d < 3; ++d)
              x[d] = take<double>();
            mesh.nodes.emplace_back(static_cast<Id>(k), x);
          }
      }

      /// Until version 4 each cell with its number of points before them, in version 5 offsets and all points.
      void read_cells()
      {
        const auto first = take<std::size_t>(), second = take<std::size_t>();
        in >> std::ws;
        if (in.peek() != 'O')
          for (std::size_t k = 0; k < first; ++k)
            cells.push_back(take_many(take<std::size_t>()));
        else
          {
            take<std::string>(), take<std::string>(); // OFFSETS and their type
            const auto begin = take_many(first);
            take<std::string>(), take<std::string>(); // CONNECTIVITY
            const auto points = take_many(second);
            for (std::size_t k = 0; k + 1 < first; ++k)
              if (begin[k] < 0 || begin[k] > begin[k + 1] || begin[k + 1] > static_cast<Id>(points.size()))
                refuse("has OFFSETS that do not ascend from 0 to the number of points", "Save it again.");
              else
                cells.emplace_back(points.begin() + begin[k], points.begin() + begin[k + 1]);
          }
      }

      void read_scalars()
      {
        const auto  name = take<std::string>();
        std::string line;
        std::getline(in, line);                   // type, number of components
        take<std::string>(), take<std::string>(); // LOOKUP_TABLE default
        if (trim(line).empty())
          refuse("has SCALARS '" + name + "' without a type", "Save it again.");
        const std::string_view last = trim(line).substr(trim(line).size() - 1);
        data[name]                  = take_many(cells.size() * (last >= "1" && last <= "9" ? last[0] - '0' : 1));
      }

      void read_fields()
      {
        take<std::string>();
        for (auto n = take<unsigned int>(); n > 0; --n)
          {
            const auto name         = take<std::string>();
            const auto n_components = take<std::size_t>(), n_tuples = take<std::size_t>();
            take<std::string>();
            data[name] = take_many(n_components * n_tuples);
          }
      }

      void add_elements()
      {
        static const std::map<Id, std::pair<unsigned int, std::size_t>> known{{3, {1, 2}}, {9, {2, 4}}, {12, {3, 8}}};
        std::vector<Id>                                                 numbers;
        for (const char *name : {"MaterialID", "gmsh:physical", "CellEntityIds"})
          if (numbers.empty())
            numbers = data[name];
        NumberedGroups group(mesh, path);
        for (std::size_t k = 0; k < cells.size(); ++k)
          {
            if (types[k] == 1) // a point
              continue;
            const auto found = known.find(types[k]);
            if (found == known.end() || found->second.second != cells[k].size())
              refuse("contains cells that are not quadrilaterals, hexahedra or lines (cell " + std::to_string(k) +
                       " of VTK's type " + std::to_string(types[k]) + ")",
                     "Recombine triangles (Gmsh: Mesh.RecombineAll = 1), sweep bodies, and save the first order.");
            const unsigned int dim   = found->second.first;
            auto              &added = mesh.elements[dim].emplace_back();
            added.id                 = static_cast<Id>(k);
            std::copy(cells[k].begin(), cells[k].end(), added.nodes.begin());
            if (numbers.size() == cells.size() && numbers[k] >= 0)
              group(dim, numbers[k]).elements[dim].push_back(added.id);
          }
      }
    };
  } // namespace

  ImportedMesh read_vtk(const std::string &path)
  {
    return VtkFile(path).read();
  }
} // namespace birdstrike
