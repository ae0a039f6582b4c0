#include "mesh/files/numbered_groups.h"
#include "mesh/files/readers.h"
#include "mesh/files/vtk/attributes.h"

#include <algorithm>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    using Id = ImportedMesh::Id;

    /// A type of VTK's cells that is read; `order`: places of its points round the faces.
    struct CellType
    {
      unsigned int dim, n_points;
      unsigned int order[8];
    };

    const CellType *find_type(const Id number)
    {
      static const std::map<Id, CellType> known{{3, {1, 2, {0, 1}}},
                                                {8, {2, 4, {0, 1, 3, 2}}}, // pixel
                                                {9, {2, 4, {0, 1, 2, 3}}},
                                                {11, {3, 8, {0, 1, 3, 2, 4, 5, 7, 6}}}, // voxel
                                                {12, {3, 8, {0, 1, 2, 3, 4, 5, 6, 7}}}};
      const auto                          found = known.find(number);
      return found != known.end() ? &found->second : nullptr;
    }

    bool is_of_no_cell(const Id type) ///< empty, a point, points
    {
      return type >= 0 && type <= 2;
    }

    class VtkFile
    {
    public:
      explicit VtkFile(const std::string &path) : path(path), words(path), attributes(words)
      {
      }

      ImportedMesh read()
      {
        read_head();
        while (!words.peek().empty())
          read_section(upper(words.word()));
        if (types.size() != cells.size())
          refuse_mesh_file(path,
                           "there are " + std::to_string(cells.size()) + " cells and " + std::to_string(types.size()) +
                             " cell types",
                           "Save it again.");
        add_elements();
        return std::move(mesh);
      }

    private:
      std::string                  path;
      VtkWords                     words;
      VtkAttributes                attributes;
      ImportedMesh                 mesh;
      std::vector<std::vector<Id>> cells;
      std::vector<Id>              types;

      /// Version, title, ASCII or BINARY, each in a line of its own.
      void read_head()
      {
        words.next();
        words.next();
        const std::string kind = upper(words.peek());
        words.skip_line();
        if (kind != "ASCII")
          words.refuse("the file is not written as text", "Save it as VTK legacy, ASCII.");
      }

      void read_section(const std::string &keyword)
      {
        if (keyword == "DATASET")
          read_kind();
        else if (keyword == "POINTS")
          read_points();
        else if (keyword == "CELLS")
          read_cells();
        else if (keyword == "CELL_TYPES")
          types = words.must_ids(words.must_count());
        else if (keyword == "CELL_DATA")
          attributes.begin(true, cells.size());
        else if (keyword == "POINT_DATA")
          attributes.begin(false, mesh.nodes.size());
        else if (!attributes.take(keyword))
          words.refuse("'" + keyword.substr(0, 40) + "' stands where a keyword of VTK's legacy format must stand",
                       "A number too few or too many above? Save it again as VTK legacy, ASCII.");
      }

      void read_kind()
      {
        if (const std::string kind = upper(words.must_word()); kind != "UNSTRUCTURED_GRID")
          words.refuse("the file holds " + kind + ", no unstructured grid", "Save it as a legacy unstructured grid.");
      }

      void read_points()
      {
        const std::size_t n = words.must_count();
        words.must_word(); // their type
        for (std::size_t k = 0; k < n; ++k)
          {
            Point3 x;
            for (unsigned int d = 0; d < 3; ++d)
              x[d] = words.must_number();
            mesh.nodes.emplace_back(static_cast<Id>(k), x);
          }
      }

      /// Until version 4 each cell with its number of points before them, in version 5 offsets and all points.
      void read_cells()
      {
        const std::size_t first = words.must_count(), second = words.must_count();
        if (upper(words.peek()) == "OFFSETS")
          return read_offsets(first, second);
        for (std::size_t k = 0; k < first; ++k)
          cells.push_back(words.must_ids(words.must_count()));
      }

      void read_offsets(const std::size_t n_offsets, const std::size_t n_points)
      {
        words.skip_words(2); // OFFSETS and their type
        const auto begin = words.must_ids(n_offsets);
        if (upper(words.must_word()) != "CONNECTIVITY")
          words.refuse("CONNECTIVITY is missing behind " + std::to_string(n_offsets) + " OFFSETS", "Save it again.");
        words.must_word(); // their type
        const auto points = words.must_ids(n_points);
        for (std::size_t k = 0; k + 1 < n_offsets; ++k)
          if (begin[k] < 0 || begin[k] > begin[k + 1] || begin[k + 1] > static_cast<Id>(points.size()))
            words.refuse("CELLS above have OFFSETS that do not ascend from 0 to the number of points",
                         "Save it again.");
          else
            cells.emplace_back(points.begin() + begin[k], points.begin() + begin[k + 1]);
      }

      /// Cells of two or three dimensions, for all that is known of their type.
      unsigned int add_not_offered(const std::size_t cell)
      {
        static const std::set<Id> of_a_surface{5, 6, 7, 8, 9, 22, 23, 28, 30, 34, 36};
        const bool                is_of_higher_order = types[cell] > 20;
        const unsigned int        dim                = of_a_surface.contains(types[cell]) ? 2 : 3;
        mesh.elements_not_offered[dim].push_back(mesh.not_offered(
          static_cast<Id>(cell), 0,
          "cell # is of VTK's type " + std::to_string(types[cell]) + " with " + std::to_string(cells[cell].size()) +
            " points. Allowed: quadrilaterals, hexahedra and lines of the first order",
          is_of_higher_order
            ? "Mesh by the first order (Gmsh: Mesh.ElementOrder = 1)."
            : "Recombine triangles (Gmsh: Mesh.RecombineAll = 1), sweep bodies; remove other cells, or "
              "name the materials that are the blade in Blade/Mesh/Parts."));
        return dim;
      }

      void add_elements()
      {
        const std::vector<Id> numbers = attributes.numbers();
        NumberedGroups        group(mesh, path);
        for (std::size_t k = 0; k < cells.size(); ++k)
          {
            if (is_of_no_cell(types[k]))
              continue;
            const CellType *type       = find_type(types[k]);
            const bool      is_offered = type != nullptr && type->n_points == cells[k].size();
            const auto      dim        = is_offered ? type->dim : add_not_offered(k);
            if (is_offered)
              {
                auto &added = mesh.elements[dim].emplace_back();
                added.id    = static_cast<Id>(k);
                for (unsigned int p = 0; p < type->n_points; ++p)
                  added.nodes[p] = cells[k][type->order[p]];
              }
            if (!numbers.empty() && numbers[k] >= 0)
              group(dim, numbers[k]).elements[dim].push_back(static_cast<Id>(k));
          }
      }
    };
  } // namespace

  ImportedMesh read_vtk(const std::string &path)
  {
    return VtkFile(path).read();
  }
} // namespace birdstrike
