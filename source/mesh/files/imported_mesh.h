#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/mesh/file_notes.h>
#include <birdstrike/mesh/named_ids.h>

#include <deal.II/grid/tria.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace birdstrike
{
  /// What a file says about its mesh besides the cells.
  struct MeshLabels
  {
    NamedIds                  boundaries, materials{NamedIds::Of::materials};
    std::vector<std::int64_t> node_ids{}, element_ids{}; ///< of the file, per vertex and cell; empty: not known
    /// Of shells, per cell and corner in the order of deal.II's vertices; 0: not given; empty: no file says it.
    std::vector<std::array<double, 4>> corner_thickness{}; ///< in units of the file
    FileNotes                          notes{};
  };

  /// A mesh as a finite-element program writes it down: nodes, elements and groups of them, by the ids of the file. The
  /// readers of a format fill it, `make_triangulation` makes deal.II's mesh of it.
  struct ImportedMesh
  {
    using Id = std::int64_t;

    static constexpr Id largest_number = 2'000'000'000; ///< of a group: deal.II keeps the highest ids for itself

    /// Corners of a brick's sides, as places in Element::nodes; Abaqus' S1 to S6.
    static constexpr unsigned int brick_sides[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                                       {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

    struct Element
    {
      Id                    id;
      std::array<Id, 8>     nodes{};     ///< as Abaqus, LS-DYNA, VTK and Gmsh list them: round the faces
      std::array<double, 4> thickness{}; ///< at the corners of a quadrilateral, 0: not given
    };

    /// Something that the file does or has, which is refused if it is of the blade.
    struct NotOffered
    {
      Id            id;
      std::size_t   line; ///< 0: not known
      std::uint32_t reason;
    };

    /// A set with a name; it may hold elements of any dimension, nodes, and sides of elements. Elements of the mesh's
    /// own dimension make it a material, elements one below, nodes and sides a boundary: a side belongs to it if it is
    /// listed, or if all of its nodes are.
    struct Group
    {
      std::string                    name;
      std::vector<std::string>       other_names{}; ///< longer, which tell it from others of its name
      std::optional<unsigned int>    material_number, boundary_number; ///< by which the file calls it, too
      std::optional<unsigned int>    dim;      ///< of its elements, where the format says it: known, even if empty
      std::array<std::vector<Id>, 4> elements; ///< ids, by dimension
      std::vector<Id>                nodes;
      std::vector<std::vector<Id>>   sides;                ///< by their nodes
      bool                           is_part_only = false; ///< Mesh/Parts may name it, no other entry
      std::string                    not_read{};           ///< says where it stands and why; refused where it is named
      std::optional<NotOffered>      not_offered{};        ///< of all its nodes

      std::vector<std::string> all_names() const;
    };

    /// Why things of the file are not offered; '#' in `what` stands for their id.
    struct Reason
    {
      std::string what, remedy;

      bool operator==(const Reason &other) const = default;
    };

    std::vector<std::pair<Id, Point3>>  nodes;
    std::array<std::vector<Element>, 4> elements; ///< by dimension: lines 1, quadrilaterals 2, bricks 3
    std::vector<Group>                  groups;

    /// By dimension (of a kind that has none here: 0); groups hold their ids as those of others.
    std::array<std::vector<NotOffered>, 4> elements_not_offered;
    std::vector<NotOffered>                nodes_not_offered;
    std::vector<Reason>                    reasons;
    FileNotes                              notes;

    /// Where a file has several lists of nodes and elements (Abaqus: parts), each id is that of the file plus this
    /// times the number of the list.
    static constexpr Id ids_of_a_list = Id(1) << 40;
    bool                has_lists     = false; ///< several

    NotOffered not_offered(Id id, std::size_t line, const std::string &what, const std::string &remedy);
  };

  /// Throws InputError about a mesh file.
  [[noreturn]] void refuse_mesh_file(const std::string &path, const std::string &what, const std::string &remedy);

  /// Cells of dimension dim with their nodes, in the order of the file; other nodes are left out. Ids: a cell or a side
  /// of the boundary that lies in no group has 0; each combination of groups that occurs has an id of its own: the
  /// number of one of its groups if there is one that no smaller combination has, else one above 100 and all numbers.
  /// Elements one dimension below that are no side of the boundary are left out.
  ///
  /// Bricks that are inside out are turned. Folded ones pass, so that `check_cells` can name them. Throws InputError
  /// for elements of a node, and ids, that are not there or there twice, and what `check_elements` refuses. `path` is
  /// for its text.
  template <int dim>
  MeshLabels make_triangulation(const ImportedMesh &mesh, const std::string &path,
                                dealii::Triangulation<dim, 3> &triangulation);
} // namespace birdstrike
