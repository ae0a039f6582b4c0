#include "mesh/generated_surface.h"
#include "mesh/mesh_file.h"
#include "mesh/shell_mesh_grid.h"

#include <numeric>

namespace birdstrike
{
  SurfaceMesh ShellMesh::Grid::extract(const std::vector<std::uint32_t> &node_of_vertex) const
  {
    static const unsigned int counter_clockwise[4] = {0, 1, 3, 2};
    SurfaceMesh               mesh;
    mesh.nodes.resize(triangulation.n_vertices());
    for (std::size_t v = 0; v < triangulation.n_vertices(); ++v)
      for (unsigned int d = 0; d < 3; ++d)
        mesh.nodes[node_of_vertex[v]][d] = triangulation.get_vertices()[v][d];
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        std::array<std::uint32_t, 4> nodes;
        for (unsigned int k = 0; k < 4; ++k)
          nodes[k] = node_of_vertex[cell->vertex_index(counter_clockwise[k])];
        mesh.cells.push_back(nodes);
        mesh.material_ids.push_back(cell->material_id());
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            mesh.rim.push_back(
              {static_cast<std::uint32_t>(cell->active_cell_index()),
               0,
               {{node_of_vertex[cell->face(f)->vertex_index(0)], node_of_vertex[cell->face(f)->vertex_index(1)]}},
               cell->face(f)->boundary_id()});
      }
    update_topology(mesh);
    return mesh;
  }

  ShellMesh::ShellMesh(const MeshParameters &parameters, const bool is_halved)
    : grid(std::make_unique<Grid>()), is_halved(is_halved), is_generated(parameters.generator != "file")
  {
    if (is_generated)
      make_shell(generate_surface(parameters, is_halved), grid->triangulation);
    else
      read_mesh_file(parameters, grid->triangulation);
    std::vector<std::uint32_t> identity(grid->triangulation.n_vertices());
    std::iota(identity.begin(), identity.end(), 0);
    extract(identity);
    check_shape(plain);
  }

  ShellMesh::~ShellMesh() = default;

  void ShellMesh::extract(const std::vector<std::uint32_t> &node_of_vertex)
  {
    plain = grid->extract(node_of_vertex);
    if (!is_generated)
      face_upwards(plain);
    if (!is_halved)
      return;
    cut_at_symmetry_plane(plain);
    if (is_generated)
      plain.mirrored_ids = {2};
  }

  const SurfaceMesh &ShellMesh::surface() const
  {
    return plain;
  }
} // namespace birdstrike
